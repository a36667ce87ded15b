// D1. Removes the bias.
//
//   d[i] = sat(coef[i] - (bias[i] << FilterFrac), DeltaBits + FilterFrac)    docs/spec/datapath.md
//
// Twin: ptm::reference::unpack() in model/reference/luminance.h. Combinational.
module ptm_evaluator_unpack #(
  parameter int CoefBits   = 8,
  parameter int DeltaBits  = 9,
  parameter int FilterFrac = 0
) (
  input  logic [6*ptm_pkg::stored_bits(CoefBits, FilterFrac)-1:0] coef_i,  // unsigned, a0 lowest
  input  logic [6*CoefBits-1:0]                                   bias_i,  // unsigned, a0's lowest
  output logic signed [ptm_pkg::delta_bits(DeltaBits, FilterFrac)-1:0] d0_o,
  output logic signed [ptm_pkg::delta_bits(DeltaBits, FilterFrac)-1:0] d1_o,
  output logic signed [ptm_pkg::delta_bits(DeltaBits, FilterFrac)-1:0] d2_o,
  output logic signed [ptm_pkg::delta_bits(DeltaBits, FilterFrac)-1:0] d3_o,
  output logic signed [ptm_pkg::delta_bits(DeltaBits, FilterFrac)-1:0] d4_o,
  output logic signed [ptm_pkg::delta_bits(DeltaBits, FilterFrac)-1:0] d5_o
);
  localparam int StoredW = ptm_pkg::stored_bits(CoefBits, FilterFrac);
  localparam int DeltaW  = ptm_pkg::delta_bits(DeltaBits, FilterFrac);

  // One bit wider than the stored value: the difference has a sign.
  logic [6*(StoredW+1)-1:0] difference;
  for (genvar i = 0; i < 6; i++) begin : gen_coef
    logic [StoredW:0] coef, bias;
    assign coef = (StoredW+1)'(coef_i[i*StoredW +: StoredW]);
    assign bias = (StoredW+1)'(bias_i[i*CoefBits +: CoefBits]) << FilterFrac;
    assign difference[i*(StoredW+1) +: StoredW+1] = coef - bias;
  end

  ptm_arith_saturate #(.InBits(StoredW + 1), .OutBits(DeltaW))
    u_saturate0 (.x_i(difference[0*(StoredW+1) +: StoredW+1]), .y_o(d0_o));
  ptm_arith_saturate #(.InBits(StoredW + 1), .OutBits(DeltaW))
    u_saturate1 (.x_i(difference[1*(StoredW+1) +: StoredW+1]), .y_o(d1_o));
  ptm_arith_saturate #(.InBits(StoredW + 1), .OutBits(DeltaW))
    u_saturate2 (.x_i(difference[2*(StoredW+1) +: StoredW+1]), .y_o(d2_o));
  ptm_arith_saturate #(.InBits(StoredW + 1), .OutBits(DeltaW))
    u_saturate3 (.x_i(difference[3*(StoredW+1) +: StoredW+1]), .y_o(d3_o));
  ptm_arith_saturate #(.InBits(StoredW + 1), .OutBits(DeltaW))
    u_saturate4 (.x_i(difference[4*(StoredW+1) +: StoredW+1]), .y_o(d4_o));
  ptm_arith_saturate #(.InBits(StoredW + 1), .OutBits(DeltaW))
    u_saturate5 (.x_i(difference[5*(StoredW+1) +: StoredW+1]), .y_o(d5_o));
endmodule
