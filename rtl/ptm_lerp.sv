// Linear interpolation of stored, unsigned values, before D1.
//
//   y = a + narrow((b - a) * f, 8)             docs/spec/datapath.md, Filtering coefficients
//
// The result lies between a and b, so it needs no more bits than they have.
// Twin: ptm::reference::lerp() in model/reference/lerp.h. Combinational.
module ptm_lerp #(
  parameter int Width        = 8,  // of a stored value: CoefBits + FilterFrac
  parameter int RoundNearest = 1
) (
  input  logic [Width-1:0]                 a_i,
  input  logic [Width-1:0]                 b_i,
  input  logic [ptm_pkg::LerpFracBits-1:0] f_i,  // Q0.8
  output logic [Width-1:0]                 y_o
);
  // The difference has a sign; the weight gets one that stays 0.
  localparam int ProductW = Width + 1 + ptm_pkg::LerpFracBits + 1;

  logic signed [Width:0] difference, step;
  logic signed [ProductW-1:0] product;
  assign difference = {1'b0, b_i} - {1'b0, a_i};
  assign product    = ProductW'(difference) * ProductW'(signed'({1'b0, f_i}));

  ptm_narrow #(
    .InBits      (ProductW),
    .AmountBits  (4),
    .OutBits     (Width + 1),
    .RoundNearest(RoundNearest)
  ) u_narrow (
    .x_i     (product),
    .amount_i(4'(ptm_pkg::LerpFracBits)),
    .y_o     (step)
  );

  // Modulo 2^Width: the sum is in range.
  assign y_o = a_i + step[Width-1:0];

  logic unused_sign;
  assign unused_sign = step[Width];
endmodule
