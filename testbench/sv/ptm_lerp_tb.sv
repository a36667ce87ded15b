// Both roundings of the lerp side by side, for 8-bit and for the widest stored values.
// No design logic.
module ptm_lerp_tb (
  input  logic [15:0] a_i,
  input  logic [15:0] b_i,
  input  logic [7:0]  f_i,
  output logic [15:0] nearest8_o,
  output logic [15:0] truncate8_o,
  output logic [15:0] nearest16_o,
  output logic [15:0] truncate16_o
);
  logic [7:0] nearest8, truncate8;
  assign nearest8_o  = 16'(nearest8);
  assign truncate8_o = 16'(truncate8);

  ptm_arith_lerp #(.Width(8), .RoundNearest(1))
    u_nearest8 (.a_i(a_i[7:0]), .b_i(b_i[7:0]), .f_i(f_i), .y_o(nearest8));
  ptm_arith_lerp #(.Width(8), .RoundNearest(0))
    u_truncate8 (.a_i(a_i[7:0]), .b_i(b_i[7:0]), .f_i(f_i), .y_o(truncate8));
  ptm_arith_lerp #(.Width(16), .RoundNearest(1))
    u_nearest16 (.a_i(a_i), .b_i(b_i), .f_i(f_i), .y_o(nearest16_o));
  ptm_arith_lerp #(.Width(16), .RoundNearest(0))
    u_truncate16 (.a_i(a_i), .b_i(b_i), .f_i(f_i), .y_o(truncate16_o));
endmodule
