// Written by scripts/contract from contract/registers.toml and its neighbours.
// What the capability registers read as, word 0 lowest in words_o.
// built_unit
assign words_o[0 +: 32] = {
  2'd0, 1'(DuplicateLines), 1'(Counters), 2'd0, 2'(EvalLanes), 1'd0, 3'(PaletteRgbPorts), 1'd0,
  3'(PaletteLrgbPorts), 1'd0, 7'(CacheKib), 1'd0, 3'(Ways), 2'd0, 2'(Tmus)};
// built_fifos
assign words_o[32 +: 32] = {
  7'd0, 9'(MissFifo), 5'd0, 11'(FragmentFifo)};
// built_effects
assign words_o[64 +: 32] = {
  8'd0, 8'(Stages), 7'd0, 1'(HalfVector), 1'd0, 3'(ExtraPasses), 1'd0, 3'(ExtraSets)};
// choices
assign words_o[96 +: 32] = {
  1'd0, 3'(ptm_register_pkg::ProbesLog2Max), 3'd0, 1'd1, 2'd0, 6'd63, 1'd0, 3'd7, 1'd0, 3'd7,
  8'd31};
// sizes
assign words_o[128 +: 32] = {
  5'(ptm_register_pkg::LineBits), 3'(ptm_register_pkg::Draws), 4'd0,
  4'(ptm_register_pkg::LevelsMax), 3'd0, 13'(ptm_register_pkg::LargestSide)};
// palettes
assign words_o[160 +: 32] = {
  20'd0, 4'(ptm_register_pkg::RgbIndexBits), 4'(ptm_register_pkg::LrgbIndexBits), 1'd0,
  3'(ptm_register_pkg::LrgbPalettes)};
// built_evaluator
assign words_o[192 +: 32] = {
  3'd0, 1'(RoundNearest), 4'(Guard), 3'd0, 5'(BasisFrac), 4'(LightFrac), 2'd0, 2'(LightInt),
  4'(DeltaBits), 4'(CoefBits)};
// built_luminance
assign words_o[224 +: 32] = {
  13'd0, 3'(FilterFrac), 1'd0, 3'(ShiftGroups), 4'(ShiftMin), 1'd0, 3'(LumFrac), 4'(LumBits)};
