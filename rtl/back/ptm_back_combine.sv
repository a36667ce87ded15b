// U11: what becomes of the lit map's P and the colour texture's C; registers C1 and C2.
//
//   evaluator -> products |C1| result |C2| -> pixels               docs/spec/unit.md, U11
//
// C2 is the unit's output. Latency 2, a pixel a cycle.
`include "ptm_assert.svh"
module ptm_back_combine #(
  parameter int RoundNearest = 1
) (
  input  logic        clk_i,
  input  logic        rst_ni,
  // From the evaluator
  input  logic                               valid_i,
  output logic                               ready_o,
  input  logic [ptm_unit_pkg::PixelBits-1:0] x_i,
  input  logic [ptm_unit_pkg::PixelBits-1:0] y_i,
  input  logic [2:0]                         combine_i,
  input  logic [8:0]                         ka_i,
  input  logic [8:0]                         kd_i,
  input  logic [23:0]                        lit_i,          // P, red lowest
  input  logic [23:0]                        color_i,        // C
  input  logic [7:0]                         color_alpha_i,  // Ca
  input  logic [7:0]                         map_alpha_i,
  input  logic [1:0]                         flags_i,        // lum_saturated, color_saturated
  // Pixels
  output logic                               valid_o,
  input  logic                               ready_i,
  output logic [ptm_unit_pkg::PixelBits-1:0] x_o,
  output logic [ptm_unit_pkg::PixelBits-1:0] y_o,
  output logic [23:0]                        rgb_o,
  output logic [7:0]                         alpha_o,
  output logic [1:0]                         flags_o,
  // C1, C2 take over a pixel: for what travels beside it
  output logic                               load_c1_o,
  output logic                               load_c2_o
);
  logic c1_valid, c2_ready, c1_load, c2_load;
  ptm_stream_reg u_c1 (
    .clk_i(clk_i), .rst_ni(rst_ni), .valid_i(valid_i), .ready_o(ready_o), .load_o(c1_load),
    .valid_o(c1_valid), .ready_i(c2_ready)
  );
  ptm_stream_reg u_c2 (
    .clk_i(clk_i), .rst_ni(rst_ni), .valid_i(c1_valid), .ready_o(c2_ready), .load_o(c2_load),
    .valid_o(valid_o), .ready_i(ready_i)
  );

  assign load_c1_o = c1_load;
  assign load_c2_o = c2_load;

  // Products | C1
  logic [3*17-1:0] lit_product, color_product;
  ptm_back_combine_products u_products (
    .combine_i(combine_i), .lit_i(lit_i), .color_i(color_i), .alpha_i(color_alpha_i), .ka_i(ka_i),
    .kd_i(kd_i), .lit_o(lit_product), .color_o(color_product)
  );

  logic [ptm_unit_pkg::PixelBits-1:0] c1_x_q, c1_y_q, c2_x_q, c2_y_q;
  logic [2:0]                         c1_combine_q;
  logic [3*17-1:0]                    c1_lit_q, c1_color_q;
  logic [7:0]                         c1_alpha_q, c2_alpha_q;
  logic [1:0]                         c1_flags_q, c2_flags_q;
  always_ff @(posedge clk_i) begin
    if (c1_load) begin
      c1_x_q       <= x_i;
      c1_y_q       <= y_i;
      c1_combine_q <= combine_i;
      c1_lit_q     <= lit_product;
      c1_color_q   <= color_product;
      c1_alpha_q   <= combine_i == ptm_unit_pkg::CombineReplace ? color_alpha_i : map_alpha_i;
      c1_flags_q   <= flags_i;
    end
  end

  // Result | C2
  logic [23:0] rgb, c2_rgb_q;
  for (genvar c = 0; c < 3; c++) begin : gen_channel
    ptm_back_combine_scale #(.RoundNearest(RoundNearest)) u_scale (
      .combine_i(c1_combine_q), .lit_i(c1_lit_q[17*c +: 17]), .color_i(c1_color_q[17*c +: 17]),
      .y_o(rgb[8*c +: 8])
    );
  end
  always_ff @(posedge clk_i) begin
    if (c2_load) begin
      c2_x_q     <= c1_x_q;
      c2_y_q     <= c1_y_q;
      c2_rgb_q   <= rgb;
      c2_alpha_q <= c1_alpha_q;
      c2_flags_q <= c1_flags_q;
    end
  end
  assign x_o     = c2_x_q;
  assign y_o     = c2_y_q;
  assign rgb_o   = c2_rgb_q;
  assign alpha_o = c2_alpha_q;
  assign flags_o = c2_flags_q;
endmodule
