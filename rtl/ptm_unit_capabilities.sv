// What the unit is built with, as its capability registers say it: docs/spec/unit.md,
// Identification and capabilities. Constants.
//
// Twin: capability_words() in model/reference/unit/register_map.cpp.
module ptm_unit_capabilities #(
  `include "contract/ptm_unit_parameters.svh"
) (
  output logic [32*ptm_unit_pkg::CapabilityWords-1:0] words_o  // word 0 lowest
);
  // Build
  assign words_o[31:0]    = {2'd0, 1'(DuplicateLines), 1'(Counters), 2'd0, 2'(EvalLanes), 1'b0,
                             3'(PaletteRgbPorts), 1'b0, 3'(PaletteLrgbPorts), 1'b0, 7'(CacheKib),
                             1'b0, 3'(Ways), 2'd0, 2'(Tmus)};
  assign words_o[63:32]   = {7'd0, 9'(MissFifo), 5'd0, 11'(FragmentFifo)};
  // Effects
  assign words_o[95:64]   = {8'd0, 8'(Stages), 7'd0, 1'(HalfVector), 1'b0, 3'(ExtraPasses), 1'b0,
                             3'(ExtraSets)};
  // Choices of a draw's control, a bit a code: combine, wrap, mip, format; bilinear; probes
  assign words_o[127:96]  = {1'b0, 3'(ptm_unit_pkg::ProbesLog2), 3'd0, 1'b1, 2'd0,
                             6'((2 << ptm_unit_pkg::CombineReplace) - 1), 1'b0,
                             3'((2 << ptm_unit_pkg::WrapClamp) - 1), 1'b0,
                             3'((2 << ptm_unit_pkg::MipLinear) - 1),
                             8'((2 << ptm_unit_pkg::FormatPaletteRgb) - 1)};
  // Sizes
  assign words_o[159:128] = {5'(ptm_unit_pkg::LineBits), 3'(ptm_unit_pkg::Draws), 4'd0,
                             4'(ptm_unit_pkg::LevelsMax), 3'd0, 13'(ptm_unit_pkg::LargestSide)};
  assign words_o[191:160] = {20'd0, 4'(ptm_unit_pkg::RgbBits), 4'(ptm_unit_pkg::LrgbBits), 1'b0,
                             3'(ptm_unit_pkg::LrgbPalettes)};
  // The evaluator
  assign words_o[223:192] = {3'd0, 1'(RoundNearest), 4'(Guard), 3'd0, 5'(BasisFrac), 4'(LightFrac),
                             2'd0, 2'(LightInt), 4'(DeltaBits), 4'(CoefBits)};
  assign words_o[255:224] = {13'd0, 3'(FilterFrac), 1'b0, 3'(ShiftGroups), 4'(ShiftMin), 1'b0,
                             3'(LumFrac), 4'(LumBits)};
endmodule
