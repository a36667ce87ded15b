// D4 for one term: a constant left shift, then one non-negative right shift that rounds.
//
//   t = narrow(p << PreShift, shift + Offset)                            docs/spec/datapath.md, D4
//
// Offset = frac - Guard + PreShift; PreShift makes shift + Offset >= 0 for every legal shift.
// Combinational.
module ptm_evaluator_align_term #(
  parameter int InBits       = 20,
  parameter int PreShift     = 0,
  parameter int Offset       = 4,
  parameter int AmountMax    = 19,  // shift + Offset at the highest shift
  parameter int OutBits      = 20,
  parameter int RoundNearest = 1
) (
  input  logic signed [InBits-1:0]             p_i,
  input  logic signed [ptm_pkg::ShiftBits-1:0] shift_i,
  output logic signed [OutBits-1:0]            t_o
);
  localparam int AmountBits = $clog2(AmountMax + 1);
  localparam int WideBits   = InBits + PreShift;

  logic signed [WideBits-1:0] wide;
  assign wide = WideBits'(p_i) <<< PreShift;

  // Modulo 2^AmountBits is enough: the sum lies in 0..AmountMax for every legal shift.
  logic [AmountBits-1:0] amount;
  assign amount = AmountBits'(shift_i) + AmountBits'(Offset);

  ptm_arith_narrow #(
    .InBits      (WideBits),
    .AmountBits  (AmountBits),
    .OutBits     (OutBits),
    .RoundNearest(RoundNearest)
  ) u_narrow (
    .x_i     (wide),
    .amount_i(amount),
    .y_o     (t_o)
  );
endmodule
