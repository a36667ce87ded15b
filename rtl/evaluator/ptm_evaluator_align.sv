// D4. Brings all terms to Guard fraction bits, each by its own shift.
//
//   t[i] = narrow(p[i], frac[i] + shift[i] - Guard)                      docs/spec/datapath.md
//
// Requires ShiftMin <= shift[i] <= 15. With ShiftGroups = 3 (1998: a0 a1 a2, a3 a4, a5) the shifts
// of a group are equal by contract, and only those of a0, a3 and a5 are looked at.
// Twin: ptm::reference::align() in model/reference/luminance.h. Combinational.
module ptm_evaluator_align #(
  parameter int DeltaBits    = 9,
  parameter int LightInt     = 2,
  parameter int LightFrac    = 8,
  parameter int BasisFrac    = 8,
  parameter int Guard        = 4,
  parameter int RoundNearest = 1,
  parameter int ShiftMin     = -4,
  parameter int ShiftGroups  = 6,
  parameter int FilterFrac   = 0,
  localparam int BasisProductW =
      ptm_pkg::product_bits(0, DeltaBits, LightInt, LightFrac, BasisFrac, FilterFrac),
  localparam int LightProductW =
      ptm_pkg::product_bits(3, DeltaBits, LightInt, LightFrac, BasisFrac, FilterFrac),
  localparam int DeltaW = ptm_pkg::delta_bits(DeltaBits, FilterFrac),
  localparam int TermW = ptm_pkg::term_bits(DeltaBits, LightInt, LightFrac, BasisFrac, Guard,
                                            ShiftMin, FilterFrac)
) (
  input  logic signed [BasisProductW-1:0]          p0_i,
  input  logic signed [BasisProductW-1:0]          p1_i,
  input  logic signed [BasisProductW-1:0]          p2_i,
  input  logic signed [LightProductW-1:0]          p3_i,
  input  logic signed [LightProductW-1:0]          p4_i,
  input  logic signed [DeltaW-1:0]                 p5_i,
  input  logic        [6*ptm_pkg::ShiftBits-1:0]   shift_i,  // signed, shift0 lowest
  output logic signed [TermW-1:0]                  t0_o,
  output logic signed [TermW-1:0]                  t1_o,
  output logic signed [TermW-1:0]                  t2_o,
  output logic signed [TermW-1:0]                  t3_o,
  output logic signed [TermW-1:0]                  t4_o,
  output logic signed [TermW-1:0]                  t5_o
);
  // The term whose shift serves term i.
  localparam int S1 = ShiftGroups == 3 ? 0 : 1;
  localparam int S2 = ShiftGroups == 3 ? 0 : 2;
  localparam int S4 = ShiftGroups == 3 ? 3 : 4;

  // Terms 0, 1, 2 are alike, so are 3 and 4.
  localparam int Pre0 = ptm_pkg::pre_shift(0, LightFrac, BasisFrac, Guard, ShiftMin, FilterFrac);
  localparam int Pre3 = ptm_pkg::pre_shift(3, LightFrac, BasisFrac, Guard, ShiftMin, FilterFrac);
  localparam int Pre5 = ptm_pkg::pre_shift(5, LightFrac, BasisFrac, Guard, ShiftMin, FilterFrac);
  localparam int Max0 = ptm_pkg::amount_max(0, LightFrac, BasisFrac, Guard, ShiftMin, FilterFrac);
  localparam int Max3 = ptm_pkg::amount_max(3, LightFrac, BasisFrac, Guard, ShiftMin, FilterFrac);
  localparam int Max5 = ptm_pkg::amount_max(5, LightFrac, BasisFrac, Guard, ShiftMin, FilterFrac);

  ptm_evaluator_align_term #(
    .InBits      (BasisProductW),
    .PreShift    (Pre0),
    .Offset      (Max0 - ptm_pkg::ShiftMax),
    .AmountMax   (Max0),
    .OutBits     (TermW),
    .RoundNearest(RoundNearest)
  ) u_term0 (
    .p_i    (p0_i),
    .shift_i(shift_i[0*ptm_pkg::ShiftBits +: ptm_pkg::ShiftBits]),
    .t_o    (t0_o)
  );

  ptm_evaluator_align_term #(
    .InBits      (BasisProductW),
    .PreShift    (Pre0),
    .Offset      (Max0 - ptm_pkg::ShiftMax),
    .AmountMax   (Max0),
    .OutBits     (TermW),
    .RoundNearest(RoundNearest)
  ) u_term1 (
    .p_i    (p1_i),
    .shift_i(shift_i[S1*ptm_pkg::ShiftBits +: ptm_pkg::ShiftBits]),
    .t_o    (t1_o)
  );

  ptm_evaluator_align_term #(
    .InBits      (BasisProductW),
    .PreShift    (Pre0),
    .Offset      (Max0 - ptm_pkg::ShiftMax),
    .AmountMax   (Max0),
    .OutBits     (TermW),
    .RoundNearest(RoundNearest)
  ) u_term2 (
    .p_i    (p2_i),
    .shift_i(shift_i[S2*ptm_pkg::ShiftBits +: ptm_pkg::ShiftBits]),
    .t_o    (t2_o)
  );

  ptm_evaluator_align_term #(
    .InBits      (LightProductW),
    .PreShift    (Pre3),
    .Offset      (Max3 - ptm_pkg::ShiftMax),
    .AmountMax   (Max3),
    .OutBits     (TermW),
    .RoundNearest(RoundNearest)
  ) u_term3 (
    .p_i    (p3_i),
    .shift_i(shift_i[3*ptm_pkg::ShiftBits +: ptm_pkg::ShiftBits]),
    .t_o    (t3_o)
  );

  ptm_evaluator_align_term #(
    .InBits      (LightProductW),
    .PreShift    (Pre3),
    .Offset      (Max3 - ptm_pkg::ShiftMax),
    .AmountMax   (Max3),
    .OutBits     (TermW),
    .RoundNearest(RoundNearest)
  ) u_term4 (
    .p_i    (p4_i),
    .shift_i(shift_i[S4*ptm_pkg::ShiftBits +: ptm_pkg::ShiftBits]),
    .t_o    (t4_o)
  );

  ptm_evaluator_align_term #(
    .InBits      (DeltaW),
    .PreShift    (Pre5),
    .Offset      (Max5 - ptm_pkg::ShiftMax),
    .AmountMax   (Max5),
    .OutBits     (TermW),
    .RoundNearest(RoundNearest)
  ) u_term5 (
    .p_i    (p5_i),
    .shift_i(shift_i[5*ptm_pkg::ShiftBits +: ptm_pkg::ShiftBits]),
    .t_o    (t5_o)
  );

  if (ShiftGroups == 3) begin : gen_grouped
    logic unused_shifts;
    assign unused_shifts = ^{shift_i[4*ptm_pkg::ShiftBits +: ptm_pkg::ShiftBits],
                             shift_i[1*ptm_pkg::ShiftBits +: 2*ptm_pkg::ShiftBits]};
  end
endmodule
