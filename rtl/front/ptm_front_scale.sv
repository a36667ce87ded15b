// U4 behind its product, and U5, one direction: both texels and the weight between them.
//
//   bilinear  s = ((fu * W_l + 2^11) >> 12) - 128, i0 = s >> 8, wu = s & 255, i1 = i0 + 1
//   point     i0 = (fu * W_l) >> 20, wu = 0                        docs/spec/unit.md, U4, U5
//   -1 becomes W_l - 1 (repeat) or 0; W_l becomes 0 (repeat) or W_l - 1
//
// Stands still, at 0, while not enabled: the simulation of a draw without this texture saves it.
// Twin: ptm::reference::scale_coordinate() in model/reference/unit/beats.h. Combinational.
module ptm_front_scale (
  input  logic        enable_i,
  input  logic        bilinear_i,
  input  logic        repeat_i,
  input  logic [31:0] product_i,  // fu * W_l, 20 fraction bits
  input  logic [12:0] side_i,     // W_l, 1..4096
  output logic [11:0] i0_o,
  output logic [11:0] i1_o,
  output logic [7:0]  weight_o    // Q0.8
);
  logic [31:0]        rounded;      // product + 2^11 < 2^32: fu is below 1
  logic signed [20:0] s;            // Q12.8 with a sign
  logic signed [13:0] index, next;  // within -1 .. W_l - 1 and 0 .. W_l
  logic [11:0]        last;
  always_comb begin
    rounded  = '0;
    s        = '0;
    index    = '0;
    next     = '0;
    last     = '0;
    i0_o     = '0;
    i1_o     = '0;
    weight_o = '0;
    if (enable_i) begin
      rounded  = product_i + 32'd2048;
      s        = signed'({1'b0, rounded[31:12]}) - 21'sd128;
      index    = bilinear_i ? 14'(signed'(s[20:8])) : signed'({2'b0, product_i[31:20]});
      next     = index + 14'sd1;
      last     = 12'(side_i - 13'd1);
      i0_o     = !index[13] ? index[11:0] : repeat_i ? last : 12'd0;
      i1_o     = next != signed'({1'b0, side_i}) ? next[11:0] : repeat_i ? 12'd0 : last;
      weight_o = bilinear_i ? s[7:0] : 8'd0;
    end
  end

  logic unused_bits;
  assign unused_bits = ^{rounded[11:0], index[12]};
endmodule
