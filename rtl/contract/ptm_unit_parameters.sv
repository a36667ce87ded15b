// What the parameters of ptm_unit may be: docs/spec/unit-timing.md, Parameters. Nothing else. Of
// Stages, ptm_effect_chain refuses those that the build has not.
//
// Written by scripts/contract from contract/parameters.toml; change it there.
`include "ptm_assert.svh"
module ptm_unit_parameters #(
`include "contract/ptm_unit_parameters.svh"
) ();
  ptm_evaluator_parameters #(
`include "contract/ptm_evaluator_map.svh"
  ) u_evaluator ();

  `PTM_REQUIRE(ptm_illegal_Tmus_not_1_to_3, Tmus >= 1 && Tmus <= 3)
  `PTM_REQUIRE(ptm_illegal_CacheKib_not_1_2_4_8_16_32_or_64,
               CacheKib == 1 || CacheKib == 2 || CacheKib == 4 || CacheKib == 8 || CacheKib == 16 ||
               CacheKib == 32 || CacheKib == 64)
  `PTM_REQUIRE(ptm_illegal_Ways_not_1_2_or_4, Ways == 1 || Ways == 2 || Ways == 4)
  `PTM_REQUIRE(ptm_illegal_FragmentFifo_not_4_to_1024, FragmentFifo >= 4 && FragmentFifo <= 1024)
  `PTM_REQUIRE(ptm_illegal_MissFifo_not_4_times_Tmus_to_256,
               MissFifo >= 4 * Tmus && MissFifo <= 256)
  `PTM_REQUIRE(ptm_illegal_PaletteLrgbPorts_not_1_2_or_4,
               PaletteLrgbPorts == 1 || PaletteLrgbPorts == 2 || PaletteLrgbPorts == 4)
  `PTM_REQUIRE(ptm_illegal_PaletteRgbPorts_not_1_2_or_4,
               PaletteRgbPorts == 1 || PaletteRgbPorts == 2 || PaletteRgbPorts == 4)
  `PTM_REQUIRE(ptm_illegal_EvalLanes_not_1_or_3, EvalLanes == 1 || EvalLanes == 3)
  `PTM_REQUIRE(ptm_illegal_ExtraPasses_not_0_to_4, ExtraPasses >= 0 && ExtraPasses <= 4)
  `PTM_REQUIRE(ptm_illegal_ExtraSets_not_0_to_ExtraPasses,
               ExtraSets >= 0 && ExtraSets <= 4 && ExtraSets <= ExtraPasses)
  `PTM_REQUIRE(ptm_illegal_HalfVector_not_0_or_1, HalfVector == 0 || HalfVector == 1)
  `PTM_REQUIRE(ptm_illegal_HalfVector_without_ExtraPasses, HalfVector == 0 || ExtraPasses != 0)
  `PTM_REQUIRE(ptm_illegal_Stages_not_a_mask_of_8_bits, Stages >= 0 && Stages <= 255)
  `PTM_REQUIRE(ptm_illegal_Counters_not_0_or_1, Counters == 0 || Counters == 1)
  `PTM_REQUIRE(ptm_illegal_DuplicateLines_not_0_or_1, DuplicateLines == 0 || DuplicateLines == 1)
  `PTM_REQUIRE(ptm_illegal_DuplicateLines_without_Counters, DuplicateLines == 0 || Counters != 0)
endmodule
