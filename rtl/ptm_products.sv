// D3. Products, 5 multiplies, exact.
//
//   p0 = d0*uu, p1 = d1*vv, p2 = d2*uv, p3 = d3*lu, p4 = d4*lv, p5 = d5     docs/spec/datapath.md
//
// Twin: ptm::reference::products() in model/reference/luminance.h. Combinational.
module ptm_products #(
  parameter int DeltaW = 9,   // of a d[i], filter fraction included
  parameter int LightW = 10,
  parameter int BasisW = 11
) (
  input  logic        [6*DeltaW-1:0]      d_i,  // signed, d0 lowest
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
  logic signed [DeltaW-1:0] d0, d1, d2, d3, d4;
  assign {p5_o, d4, d3, d2, d1, d0} = d_i;

  // An n-bit times an m-bit number fits n + m bits.
  assign p0_o = (DeltaW+BasisW)'(d0) * (DeltaW+BasisW)'(uu_i);
  assign p1_o = (DeltaW+BasisW)'(d1) * (DeltaW+BasisW)'(vv_i);
  assign p2_o = (DeltaW+BasisW)'(d2) * (DeltaW+BasisW)'(uv_i);
  assign p3_o = (DeltaW+LightW)'(d3) * (DeltaW+LightW)'(lu_i);
  assign p4_o = (DeltaW+LightW)'(d4) * (DeltaW+LightW)'(lv_i);
endmodule
