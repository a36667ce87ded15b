// D5. The sum, 5 adds, in order of the coefficients.
//
//   acc = t0 + t1 + t2 + t3 + t4 + t5                                    docs/spec/datapath.md
//
// SumW = TermW + 2 holds six terms of magnitude at most 2^(TermW-2).
// Twin: ptm::reference::sum() in model/reference/luminance.h. Combinational.
module ptm_evaluator_sum #(
  parameter int TermW = 20,
  parameter int SumW  = 22
) (
  input  logic signed [TermW-1:0] t0_i,
  input  logic signed [TermW-1:0] t1_i,
  input  logic signed [TermW-1:0] t2_i,
  input  logic signed [TermW-1:0] t3_i,
  input  logic signed [TermW-1:0] t4_i,
  input  logic signed [TermW-1:0] t5_i,
  output logic signed [SumW-1:0]  acc_o
);
  assign acc_o = SumW'(t0_i) + SumW'(t1_i) + SumW'(t2_i) + SumW'(t3_i) + SumW'(t4_i) + SumW'(t5_i);
endmodule
