// U11, result of one channel, from the products of ptm_back_combine_products.
//
//   modulate, decal  div255(s)            blend  min(255, narrow(s, 8))
//   none, add, replace  min(255, s)                                    docs/spec/unit.md, U11
//
// Twin: combine_channel() in model/reference/unit/combine.h. Combinational.
module ptm_back_combine_scale #(
  parameter int RoundNearest = 1
) (
  input  logic [2:0]  combine_i,
  input  logic [16:0] lit_i,
  input  logic [16:0] color_i,
  output logic [7:0]  y_o
);
  logic [17:0] sum, quotient, exact;
  assign sum = {1'b0, lit_i} + {1'b0, color_i};

  ptm_arith_divide_255 #(.Width(18), .RoundNearest(RoundNearest))
    u_divide (.p_i(sum), .quotient_o(quotient));

  logic signed [18:0] blended;
  ptm_arith_narrow #(.InBits(19), .AmountBits(4), .OutBits(19), .RoundNearest(RoundNearest))
    u_narrow (.x_i({1'b0, sum}), .amount_i(4'd8), .y_o(blended));

  always_comb begin
    case (combine_i)
      ptm_unit_pkg::CombineModulate,
      ptm_unit_pkg::CombineDecal: exact = quotient;
      ptm_unit_pkg::CombineBlend: exact = blended[17:0];
      default:                    exact = sum;
    endcase
  end
  assign y_o = exact[17:8] != '0 ? 8'd255 : exact[7:0];

  logic unused_sign;
  assign unused_sign = blended[18];
endmodule
