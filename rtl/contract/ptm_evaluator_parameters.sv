// What the parameters of ptm_evaluator may be: docs/spec/datapath.md, Parameters. Nothing else.
//
// A module of its own, so that a tool which does not read the unit (Icarus Verilog 11) can be asked
// too.
// Written by scripts/contract from contract/parameters.toml; change it there.
`include "ptm_assert.svh"
module ptm_evaluator_parameters #(
`include "contract/ptm_evaluator_parameters.svh"
  ,
  parameter int Assemble     = 1,
  parameter int SidebandBits = 32
) ();
  `PTM_REQUIRE(ptm_illegal_CoefBits_not_4_to_12, CoefBits >= 4 && CoefBits <= 12)
  `PTM_REQUIRE(ptm_illegal_DeltaBits_not_5_to_13, DeltaBits >= 5 && DeltaBits <= 13)
  `PTM_REQUIRE(ptm_illegal_LightInt_not_1_to_3, LightInt >= 1 && LightInt <= 3)
  `PTM_REQUIRE(ptm_illegal_LightFrac_not_4_to_14, LightFrac >= 4 && LightFrac <= 14)
  `PTM_REQUIRE(ptm_illegal_BasisFrac_not_4_to_twice_LightFrac,
               BasisFrac >= 4 && BasisFrac <= 2 * LightFrac)
  `PTM_REQUIRE(ptm_illegal_Guard_not_0_to_12, Guard >= 0 && Guard <= 12)
  `PTM_REQUIRE(ptm_illegal_RoundNearest_not_0_or_1, RoundNearest == 0 || RoundNearest == 1)
  `PTM_REQUIRE(ptm_illegal_LumBits_not_8_to_12, LumBits >= 8 && LumBits <= 12)
  `PTM_REQUIRE(ptm_illegal_LumFrac_not_0_to_4, LumFrac >= 0 && LumFrac <= 4)
  `PTM_REQUIRE(ptm_illegal_ShiftMin_not_minus_8_to_0, ShiftMin >= -8 && ShiftMin <= 0)
  `PTM_REQUIRE(ptm_illegal_ShiftGroups_not_3_or_6, ShiftGroups == 3 || ShiftGroups == 6)
  `PTM_REQUIRE(ptm_illegal_FilterFrac_not_0_to_4, FilterFrac >= 0 && FilterFrac <= 4)
  `PTM_REQUIRE(ptm_illegal_Assemble_not_0_or_1, Assemble == 0 || Assemble == 1)
  `PTM_REQUIRE(ptm_illegal_SidebandBits_not_1_or_more, SidebandBits >= 1)
endmodule
