// What the unit is built with, as its capability registers say it: docs/spec/unit.md,
// Identification and capabilities. Constants.
//
// Twin: capability_words() in model/reference/unit/register_map.cpp.
module ptm_registers_capabilities #(
  `include "contract/ptm_unit_parameters.svh"
) (
  output logic [32*ptm_unit_pkg::CapabilityWords-1:0] words_o  // word 0 lowest
);
  `include "contract/ptm_capability_words.svh"
endmodule
