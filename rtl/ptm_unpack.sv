// D1. Removes the bias.
//
//   d[i] = sat(coef[i] - (bias[i] << FilterFrac), DeltaBits + FilterFrac)      docs/spec/datapath.md
//
// Twin: ptm::reference::unpack() in model/reference/luminance.h. Combinational.
module ptm_unpack #(
  parameter int CoefBits   = 8,
  parameter int DeltaBits  = 9,
  parameter int FilterFrac = 0
) (
  input  logic [6*ptm_pkg::stored_bits(CoefBits, FilterFrac)-1:0] coef_i,  // unsigned, a0 lowest
  input  logic [6*CoefBits-1:0]                                   bias_i,  // unsigned
  output logic [6*ptm_pkg::delta_bits(DeltaBits, FilterFrac)-1:0] d_o      // signed
);
  localparam int StoredW = ptm_pkg::stored_bits(CoefBits, FilterFrac);
  localparam int DeltaW  = ptm_pkg::delta_bits(DeltaBits, FilterFrac);

  for (genvar i = 0; i < 6; i++) begin : gen_coef
    // One bit wider than the stored value: the difference has a sign.
    logic [StoredW:0] coef, bias, difference;
    assign coef       = (StoredW+1)'(coef_i[i*StoredW +: StoredW]);
    assign bias       = (StoredW+1)'(bias_i[i*CoefBits +: CoefBits]) << FilterFrac;
    assign difference = coef - bias;
    ptm_saturate #(
      .InBits (StoredW + 1),
      .OutBits(DeltaW)
    ) u_saturate (
      .x_i(difference),
      .y_o(d_o[i*DeltaW +: DeltaW])
    );
  end
endmodule
