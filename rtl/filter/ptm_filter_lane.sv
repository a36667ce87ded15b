// U7 for one field of a TMU's word, registers L1 and L2 included: 3 multiplies.
//
//   |P| top = lerp(t00, t10, wu), bottom = lerp(t01, t11, wu) |L1| lerp(top, bottom, wv) |L2|
//                                                                        docs/spec/unit.md, U7
//
// A tap that is not fetched has weight 0 and may be anything. Latency 2.
// Twin: bilinear filtering in model/reference/unit/.
module ptm_filter_lane #(
  parameter int Width        = 8,
  parameter int RoundNearest = 1
) (
  input  logic             clk_i,
  input  logic             load_l1_i,
  input  logic             load_l2_i,
  input  logic [Width-1:0] t00_i,
  input  logic [Width-1:0] t10_i,
  input  logic [Width-1:0] t01_i,
  input  logic [Width-1:0] t11_i,
  input  logic [7:0]       wu_i,  // of the beat in P
  input  logic [7:0]       wv_i,  // of the beat in L1
  output logic [Width-1:0] l2_o
);
  logic [Width-1:0] top, bottom, value;
  logic [Width-1:0] l1_top_q, l1_bottom_q, l2_q;
  ptm_arith_lerp #(.Width(Width), .RoundNearest(RoundNearest))
    u_top (.a_i(t00_i), .b_i(t10_i), .f_i(wu_i), .y_o(top));
  ptm_arith_lerp #(.Width(Width), .RoundNearest(RoundNearest))
    u_bottom (.a_i(t01_i), .b_i(t11_i), .f_i(wu_i), .y_o(bottom));
  ptm_arith_lerp #(.Width(Width), .RoundNearest(RoundNearest))
    u_value (.a_i(l1_top_q), .b_i(l1_bottom_q), .f_i(wv_i), .y_o(value));

  always_ff @(posedge clk_i) begin
    if (load_l1_i) begin
      l1_top_q    <= top;
      l1_bottom_q <= bottom;
    end
    if (load_l2_i) l2_q <= value;
  end
  assign l2_o = l2_q;
endmodule
