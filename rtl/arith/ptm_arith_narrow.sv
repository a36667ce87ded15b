// Drops k fraction bits; the one place where the datapath rounds, but for ptm_arith_lerp's own.
//
//   nearest   y = floor(x / 2^k + 1/2), ties toward plus infinity     docs/spec/datapath.md, narrow
//   truncate  y = floor(x / 2^k)
//
// The contract adds half a unit first and shifts afterwards. Here the shift comes first and keeps
// one bit more: floor((floor(2x / 2^k) + 1) / 2) is the same number for every k >= 0 (for k = 0 it
// is floor((2x + 1) / 2) = x), and the adder carries one constant bit instead of a decoded 2^(k-1).
// With a constant amount the shifter is wires. The caller's widths guarantee that y fits OutBits.
// Twin: ptm::reference::narrow() in model/reference/rounding.h. Combinational.
module ptm_arith_narrow #(
  parameter int InBits       = 20,
  parameter int AmountBits   = 5,
  parameter int OutBits      = 20,
  parameter int RoundNearest = 1    // 0: truncate
) (
  input  logic signed [InBits-1:0]     x_i,
  input  logic        [AmountBits-1:0] amount_i,  // k >= 0, data or constant
  output logic signed [OutBits-1:0]    y_o
);
  if (RoundNearest != 0) begin : gen_nearest
    // One bit wider than x: 2x, and 2x is even, so adding 1 cannot wrap for k = 0 either.
    logic signed [InBits:0] doubled, shifted, biased;
    assign doubled = {x_i, 1'b0};
    assign shifted = doubled >>> amount_i;
    assign biased  = shifted + (InBits+1)'(1);
    if (OutBits <= InBits) begin : gen_slice
      assign y_o = biased[OutBits:1];
    end else begin : gen_extend
      assign y_o = {{(OutBits-InBits){biased[InBits]}}, biased[InBits:1]};
    end
  end else begin : gen_truncate
    logic signed [InBits-1:0] shifted;
    assign shifted = x_i >>> amount_i;
    assign y_o     = OutBits'(shifted);
  end
endmodule
