// Clamps to the range of an OutBits-wide two's-complement number.
//
//   y = min(max(x, -2^(OutBits-1)), 2^(OutBits-1) - 1)                docs/spec/datapath.md, sat
//
// Twin: ptm::reference::sat() in model/reference/rounding.h. Combinational.
module ptm_arith_saturate #(
  parameter int InBits  = 10,
  parameter int OutBits = 9
) (
  input  logic signed [InBits-1:0]  x_i,
  output logic signed [OutBits-1:0] y_o
);
  if (InBits <= OutBits) begin : gen_fits
    assign y_o = OutBits'(x_i);
  end else begin : gen_clamp
    // x fits if all bits from the result's sign upwards are alike: each is what its neighbour is.
    logic fits, negative;
    assign negative = x_i[InBits-1];
    assign fits     = x_i[InBits-1:OutBits] == x_i[InBits-2:OutBits-1];
    assign y_o      = fits ? x_i[OutBits-1:0] : {negative, {(OutBits-1){!negative}}};
  end
endmodule
