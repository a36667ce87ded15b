// D7, scale: from products, or from an RGB map's luminance, to 8-bit colour.
//
//   LRGB     out[c] = min(255, narrow(product[c], LumFrac + FilterFrac) / 255)
//   RGB map  out    = min(255, narrow(lum, LumFrac)), one channel a beat, in all three places
//                                                                        docs/spec/datapath.md
// Twins: ptm::reference::color_scale() and color_direct() in model/reference/color.h.
// Combinational.
module ptm_evaluator_color_scale #(
  parameter int LumBits      = 10,
  parameter int LumFrac      = 0,
  parameter int FilterFrac   = 0,
  parameter int RoundNearest = 1,
  localparam int LumW     = ptm_pkg::lum_bits(LumBits, LumFrac),
  localparam int ProductW = ptm_pkg::color_product_bits(LumBits, LumFrac, FilterFrac)
) (
  input  logic [ProductW-1:0] red_i,  // products
  input  logic [ProductW-1:0] green_i,
  input  logic [ProductW-1:0] blue_i,
  input  logic [LumW-1:0]     lum_i,
  input  logic                rgb_map_i,
  output logic [23:0]         rgb_o,       // red lowest
  output logic                saturated_o  // any channel was limited
);
  // A carry of rounding and, for the signed narrowing, a sign that stays 0.
  localparam int ScaledW = ProductW - LumFrac - FilterFrac + 1;
  localparam int DirectW = LumBits + 1;

  logic signed [DirectW:0] direct;
  ptm_arith_narrow #(.InBits(LumW + 1), .AmountBits(4), .OutBits(DirectW + 1),
               .RoundNearest(RoundNearest))
    u_narrow_direct (.x_i({1'b0, lum_i}), .amount_i(4'(LumFrac)), .y_o(direct));

  logic [3*ProductW-1:0] product;
  logic [2:0] limited;
  assign product     = {blue_i, green_i, red_i};
  assign saturated_o = limited != '0;

  for (genvar c = 0; c < 3; c++) begin : gen_channel
    logic signed [ScaledW:0] scaled;
    ptm_arith_narrow #(.InBits(ProductW + 1), .AmountBits(4), .OutBits(ScaledW + 1),
                 .RoundNearest(RoundNearest))
      u_narrow (.x_i({1'b0, product[c*ProductW +: ProductW]}),
                .amount_i(4'(LumFrac + FilterFrac)), .y_o(scaled));

    logic [ScaledW-1:0] quotient, exact;
    ptm_arith_divide_255 #(.Width(ScaledW), .RoundNearest(RoundNearest))
      u_divide (.p_i(scaled[ScaledW-1:0]), .quotient_o(quotient));

    assign exact           = rgb_map_i ? ScaledW'(direct[DirectW-1:0]) : quotient;
    assign limited[c]      = exact[ScaledW-1:8] != '0;
    assign rgb_o[8*c +: 8] = limited[c] ? 8'd255 : exact[7:0];

    logic unused_sign;
    assign unused_sign = scaled[ScaledW];
  end

  logic unused_sign;
  assign unused_sign = direct[DirectW];
endmodule
