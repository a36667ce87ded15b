// D3. Products, 5 multiplies, exact.
//
//   p0 = d0*uu, p1 = d1*vv, p2 = d2*uv, p3 = d3*lu, p4 = d4*lv, p5 = d5     docs/spec/datapath.md
//
// Twin: ptm::reference::products() in model/reference/luminance.h. Combinational.
module ptm_evaluator_products #(
  parameter int DeltaW = 9,   // of a d[i], filter fraction included
  parameter int LightW = 10,
  parameter int BasisW = 11
) (
  input  logic signed [DeltaW-1:0]        d0_i,
  input  logic signed [DeltaW-1:0]        d1_i,
  input  logic signed [DeltaW-1:0]        d2_i,
  input  logic signed [DeltaW-1:0]        d3_i,
  input  logic signed [DeltaW-1:0]        d4_i,
  input  logic signed [DeltaW-1:0]        d5_i,
  input  logic signed [BasisW-1:0]        uu_i,
  input  logic signed [BasisW-1:0]        vv_i,
  input  logic signed [BasisW-1:0]        uv_i,
  input  logic signed [LightW-1:0]        lu_i,
  input  logic signed [LightW-1:0]        lv_i,
  output logic signed [DeltaW+BasisW-1:0] p0_o,
  output logic signed [DeltaW+BasisW-1:0] p1_o,
  output logic signed [DeltaW+BasisW-1:0] p2_o,
  output logic signed [DeltaW+LightW-1:0] p3_o,
  output logic signed [DeltaW+LightW-1:0] p4_o,
  output logic signed [DeltaW-1:0]        p5_o
);
  // An n-bit times an m-bit number fits n + m bits.
  assign p0_o = (DeltaW+BasisW)'(d0_i) * (DeltaW+BasisW)'(uu_i);
  assign p1_o = (DeltaW+BasisW)'(d1_i) * (DeltaW+BasisW)'(vv_i);
  assign p2_o = (DeltaW+BasisW)'(d2_i) * (DeltaW+BasisW)'(uv_i);
  assign p3_o = (DeltaW+LightW)'(d3_i) * (DeltaW+LightW)'(lu_i);
  assign p4_o = (DeltaW+LightW)'(d4_i) * (DeltaW+LightW)'(lv_i);
  assign p5_o = d5_i;
endmodule
