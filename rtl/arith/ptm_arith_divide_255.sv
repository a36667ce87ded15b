// x / 255 without a divider, before the limit to 255.                    docs/spec/datapath.md, D7
//
//   nearest   t = p + 128, (t + (t >> 8)) >> 8
//   truncate  (p + 1 + (p >> 8)) >> 8
//
// Exact below 65,535 and at least 255 above.
// Twin: ptm::reference::divide_255() in model/reference/color.h. Combinational.
module ptm_arith_divide_255 #(
  parameter int Width        = 19,
  parameter int RoundNearest = 1
) (
  input  logic [Width-1:0] p_i,
  output logic [Width-1:0] quotient_o
);
  // One bit wider: p + 128 + ((p + 128) >> 8) < 2p + 256.
  logic [Width:0] biased, scaled;
  if (RoundNearest != 0) begin : gen_nearest
    assign biased = (Width+1)'(p_i) + (Width+1)'(128);
    assign scaled = biased + (biased >> 8);
  end else begin : gen_truncate
    logic [Width:0] p;
    assign p      = (Width+1)'(p_i);
    assign biased = p + (Width+1)'(1);
    assign scaled = biased + (p >> 8);
  end
  assign quotient_o = Width'(scaled >> 8);
endmodule
