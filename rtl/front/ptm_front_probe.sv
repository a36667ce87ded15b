// U1, one direction: where probe k of N = 2^probes_log2 lies along the axis.
//
//   pu = u + (((2k + 1 - N) * axis_u) >> 1)                        docs/spec/unit.md, U1
//
// One multiply; of no effect (0) for a single probe.
// Twin: ptm::reference::probe_coordinate() in model/reference/unit/beats.h. Combinational.
module ptm_front_probe #(
  localparam int CoordBits = ptm_unit_pkg::CoordBits,
  localparam int OutBits   = 34
) (
  input  logic signed [CoordBits-1:0] u_i,     // Q8.20
  input  logic signed [CoordBits-1:0] axis_i,  // Q8.20, from one probe to the next
  input  logic [3:0]                  probe_i,
  input  logic [2:0]                  probes_log2_i,  // 0..4
  output logic signed [OutBits-1:0]   u_o
);
  // 2k + 1 - N lies within -15 .. 15; the product takes 29 + 5 bits.
  logic [4:0]                count;
  logic signed [5:0]         steps;
  logic signed [OutBits:0]   product;
  assign count   = 5'd1 << probes_log2_i;
  assign steps   = signed'({1'b0, probe_i, 1'b1}) - signed'({1'b0, count});
  assign product = (OutBits+1)'(steps) * (OutBits+1)'(axis_i);
  assign u_o     = OutBits'(u_i) + product[OutBits:1];

  logic unused_half;
  assign unused_half = product[0];
endmodule
