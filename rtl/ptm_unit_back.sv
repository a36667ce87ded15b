// The back of the texture unit: from the taps in D to the pixel. Skeleton, the ports are final.
module ptm_unit_back #(
  // EvalConfig; as ptm_evaluator, but CoefBits at most 10
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
  // UnitConfig
  parameter int Tmus             = 3,  // 1..3
  parameter int PaletteLrgbPorts = 4,  // 1, 2, 4
  parameter int PaletteRgbPorts  = 1   // 1, 2, 4
) (
  input  logic        clk_i,
  input  logic        rst_ni,
  input  logic [ptm_unit_pkg::Draws*ptm_unit_pkg::DrawW-1:0] draws_i,  // draw_t, draw 0 lowest
  // Palettes: addresses are offsets from 0x4000 and 0x8000
  input  logic        pal_lrgb_we_i,
  input  logic [10:0] pal_lrgb_addr_i,
  input  logic        pal_rgb_we_i,
  input  logic [14:0] pal_rgb_addr_i,
  input  logic [31:0] pal_data_i,
  // What stands in D; it leaves in a cycle in which d_valid_i and d_ready_o are high
  input  logic                                d_valid_i,
  output logic                                d_ready_o,
  input  ptm_unit_pkg::beat_t                 d_beat_i,
  input  logic [Tmus*ptm_unit_pkg::TapsW-1:0] d_taps_i,  // taps_t, TMU 0 lowest
  // Pixels
  output logic                               pix_valid_o,
  input  logic                               pix_ready_i,
  output logic [ptm_unit_pkg::PixelBits-1:0] pix_x_o,
  output logic [ptm_unit_pkg::PixelBits-1:0] pix_y_o,
  output logic [23:0]                        pix_rgb_o,  // red lowest
  output logic [7:0]                         pix_alpha_o,
  output logic                               pix_lum_saturated_o,
  output logic                               pix_color_saturated_o,
  // What counters grow by, each in the cycle of the event
  output logic [2:0] inc_palette_o,
  output logic [7:0] inc_filter_o,
  output logic [4:0] inc_eval_o,
  output logic [2:0] inc_combine_o
);
  assign d_ready_o = 1'b1;
  assign {pix_valid_o, pix_x_o, pix_y_o, pix_rgb_o, pix_alpha_o} = '0;
  assign {pix_lum_saturated_o, pix_color_saturated_o} = '0;
  assign {inc_palette_o, inc_filter_o, inc_eval_o, inc_combine_o} = '0;
endmodule
