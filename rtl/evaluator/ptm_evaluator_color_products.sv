// D7, products: lum * rgb[c], 3 multiplies, exact.                       docs/spec/datapath.md
//
// Twin: ptm::reference::color_products() in model/reference/color.h. Combinational.
module ptm_evaluator_color_products #(
  parameter int LumW = 10,
  parameter int RgbW = 8
) (
  input  logic [LumW-1:0]      lum_i,
  input  logic [3*RgbW-1:0]    rgb_i,  // red lowest
  output logic [LumW+RgbW-1:0] red_o,
  output logic [LumW+RgbW-1:0] green_o,
  output logic [LumW+RgbW-1:0] blue_o
);
  localparam int ProductW = LumW + RgbW;

  assign red_o   = ProductW'(lum_i) * ProductW'(rgb_i[0*RgbW +: RgbW]);
  assign green_o = ProductW'(lum_i) * ProductW'(rgb_i[1*RgbW +: RgbW]);
  assign blue_o  = ProductW'(lum_i) * ProductW'(rgb_i[2*RgbW +: RgbW]);
endmodule
