// Linear interpolation of stored, unsigned values, before D1.
//
//   y = a + narrow((b - a) * f, 8)                                docs/spec/datapath.md, Steps
//
// The result lies between a and b, so it needs no more bits than they have.
// Twin: ptm::reference::lerp() in model/reference/lerp.h. Combinational.
`include "ptm_assert.svh"
module ptm_arith_lerp #(
  parameter int Width        = 8,  // of a stored value: CoefBits + FilterFrac
  parameter int RoundNearest = 1
) (
  input  logic [Width-1:0]                 a_i,
  input  logic [Width-1:0]                 b_i,
  input  logic [ptm_pkg::LerpFracBits-1:0] f_i,  // Q0.8
  output logic [Width-1:0]                 y_o
);
  `PTM_REQUIRE(ptm_illegal_Width_not_1_or_more, Width >= 1)
  `PTM_REQUIRE(ptm_illegal_RoundNearest_not_0_or_1, RoundNearest == 0 || RoundNearest == 1)

  // y = floor((a * 2^8 + (b - a) * f + half) / 2^8). It is in range, so all of it may be computed
  // modulo 2^(Width + 8), where the difference needs no sign.
  localparam int SumW = Width + ptm_pkg::LerpFracBits;
  localparam logic [ptm_pkg::LerpFracBits-1:0] Half =
      RoundNearest != 0 ? {1'b1, {(ptm_pkg::LerpFracBits-1){1'b0}}} : '0;

  logic [SumW-1:0] difference, product, sum;
  assign difference = SumW'(b_i) - SumW'(a_i);
  assign product    = difference * SumW'(f_i);
  assign sum        = {a_i, Half} + product;
  assign y_o        = sum[SumW-1:ptm_pkg::LerpFracBits];

  logic unused_fraction;
  assign unused_fraction = ^sum[ptm_pkg::LerpFracBits-1:0];
endmodule
