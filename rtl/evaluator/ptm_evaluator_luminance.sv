// D6. Luminance.
//
//   lum = clamp(narrow(acc, Guard - LumFrac), 0, 2^(LumBits+LumFrac) - 1)     docs/spec/datapath.md
//
// Twin: ptm::reference::luminance() in model/reference/luminance.h. Combinational.
module ptm_evaluator_luminance #(
  parameter int SumW         = 22,
  parameter int Guard        = 4,
  parameter int LumBits      = 10,
  parameter int LumFrac      = 0,
  parameter int RoundNearest = 1
) (
  input  logic signed [SumW-1:0]                               acc_i,
  output logic        [ptm_pkg::lum_bits(LumBits, LumFrac)-1:0] lum_o,
  output logic                                                 saturated_o  // the clamp changed it
);
  localparam int LumW = ptm_pkg::lum_bits(LumBits, LumFrac);
  localparam int Drop = ptm_pkg::larger(0, Guard - LumFrac);
  localparam int Grow = ptm_pkg::larger(0, LumFrac - Guard);
  // Wide enough for acc << Grow, for the carry of rounding, and to see the bits above lum.
  localparam int ExactW = ptm_pkg::larger(SumW + Grow + 1, LumW + 2);

  logic signed [SumW+Grow-1:0] grown;
  logic signed [ExactW-1:0] exact;
  assign grown = (SumW+Grow)'(acc_i) <<< Grow;
  ptm_arith_narrow #(
    .InBits      (SumW + Grow),
    .AmountBits  (4),
    .OutBits     (ExactW),
    .RoundNearest(RoundNearest)
  ) u_narrow (
    .x_i     (grown),
    .amount_i(4'(Drop)),
    .y_o     (exact)
  );

  logic negative, above;
  assign negative    = exact[ExactW-1];
  assign above       = !negative && exact[ExactW-2:LumW] != '0;
  assign saturated_o = negative || above;
  assign lum_o       = negative ? '0 : above ? '1 : exact[LumW-1:0];
endmodule
