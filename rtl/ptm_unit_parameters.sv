// What the parameters of ptm_unit may be: docs/spec/unit-timing.md, Parameters. Nothing else. Of
// Stages, ptm_effect_chain refuses those that the build has not.
//
// Twin: validate() in model/reference/unit/unit_config.cpp.
`include "ptm_assert.svh"
module ptm_unit_parameters #(
  parameter int CoefBits     = 8,
  parameter int DeltaBits    = 9,
  parameter int LightInt     = 2,
  parameter int LightFrac    = 8,
  parameter int BasisFrac    = 8,
  parameter int Guard        = 4,
  parameter int RoundNearest = 1,
  parameter int LumBits      = 10,
  parameter int LumFrac      = 0,
  parameter int ShiftMin     = -4,
  parameter int ShiftGroups  = 6,
  parameter int FilterFrac   = 0,
  parameter int Tmus             = 3,
  parameter int CacheKib         = 16,
  parameter int Ways             = 2,
  parameter int FragmentFifo     = 192,
  parameter int MissFifo         = 64,
  parameter int PaletteLrgbPorts = 4,
  parameter int PaletteRgbPorts  = 1,
  parameter int EvalLanes        = 1,
  parameter int HalfVector       = 0,
  parameter int ExtraSets        = 0,
  parameter int ExtraPasses      = 0,
  parameter int Stages           = 0,
  parameter int Counters         = 1,
  parameter int DuplicateLines   = 1
) ();
  ptm_evaluator_parameters #(
    .CoefBits(CoefBits), .DeltaBits(DeltaBits), .LightInt(LightInt), .LightFrac(LightFrac),
    .BasisFrac(BasisFrac), .Guard(Guard), .RoundNearest(RoundNearest), .LumBits(LumBits),
    .LumFrac(LumFrac), .ShiftMin(ShiftMin), .ShiftGroups(ShiftGroups), .FilterFrac(FilterFrac)
  ) u_evaluator ();

  `PTM_REQUIRE(ptm_illegal_CoefBits_above_10_in_a_unit, CoefBits <= 10)
  `PTM_REQUIRE(ptm_illegal_Tmus_not_1_to_3, Tmus >= 1 && Tmus <= 3)
  `PTM_REQUIRE(ptm_illegal_CacheKib_not_1_2_4_8_16_32_or_64,
               CacheKib >= 1 && CacheKib <= 64 && (CacheKib & (CacheKib - 1)) == 0)
  `PTM_REQUIRE(ptm_illegal_Ways_not_1_2_or_4, Ways == 1 || Ways == 2 || Ways == 4)
  `PTM_REQUIRE(ptm_illegal_FragmentFifo_not_4_to_1024, FragmentFifo >= 4 && FragmentFifo <= 1024)
  `PTM_REQUIRE(ptm_illegal_MissFifo_not_4_times_Tmus_to_256,
               MissFifo >= 4 * Tmus && MissFifo <= 256)
  `PTM_REQUIRE(ptm_illegal_PaletteLrgbPorts_not_1_2_or_4,
               PaletteLrgbPorts == 1 || PaletteLrgbPorts == 2 || PaletteLrgbPorts == 4)
  `PTM_REQUIRE(ptm_illegal_PaletteRgbPorts_not_1_2_or_4,
               PaletteRgbPorts == 1 || PaletteRgbPorts == 2 || PaletteRgbPorts == 4)
  `PTM_REQUIRE(ptm_illegal_EvalLanes_not_1_or_3, EvalLanes == 1 || EvalLanes == 3)
  `PTM_REQUIRE(ptm_illegal_HalfVector_not_0_or_1, HalfVector == 0 || HalfVector == 1)
  `PTM_REQUIRE(ptm_illegal_HalfVector_without_ExtraPasses, HalfVector == 0 || ExtraPasses > 0)
  `PTM_REQUIRE(ptm_illegal_ExtraPasses_not_0_to_4, ExtraPasses >= 0 && ExtraPasses <= 4)
  `PTM_REQUIRE(ptm_illegal_ExtraSets_not_0_to_ExtraPasses,
               ExtraSets >= 0 && ExtraSets <= ExtraPasses)
  `PTM_REQUIRE(ptm_illegal_Stages_not_a_mask_of_8_bits, Stages >= 0 && Stages <= 255)
  `PTM_REQUIRE(ptm_illegal_Counters_not_0_or_1, Counters == 0 || Counters == 1)
  `PTM_REQUIRE(ptm_illegal_DuplicateLines_not_0_or_1, DuplicateLines == 0 || DuplicateLines == 1)
  `PTM_REQUIRE(ptm_illegal_DuplicateLines_without_Counters, DuplicateLines == 0 || Counters != 0)
endmodule
