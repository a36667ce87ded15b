// D2. The quadratic basis, 3 multiplies.
//
//   uu = sat(narrow(lu * lu, 2 LightFrac - BasisFrac), basis_bits), likewise vv, uv
//                                                                        docs/spec/datapath.md
// Every code is accepted, the most negative included. Its square saturates; of a coarse basis the
// squares next to it round up to it, and do as well.
// Twin: ptm::reference::basis() in model/reference/luminance.h. Combinational.
module ptm_evaluator_basis #(
  parameter int LightInt     = 2,
  parameter int LightFrac    = 8,
  parameter int BasisFrac    = 8,
  parameter int RoundNearest = 1
) (
  input  logic signed [ptm_pkg::light_bits(LightInt, LightFrac)-1:0] lu_i,
  input  logic signed [ptm_pkg::light_bits(LightInt, LightFrac)-1:0] lv_i,
  output logic signed [ptm_pkg::basis_bits(LightInt, BasisFrac)-1:0] uu_o,
  output logic signed [ptm_pkg::basis_bits(LightInt, BasisFrac)-1:0] vv_o,
  output logic signed [ptm_pkg::basis_bits(LightInt, BasisFrac)-1:0] uv_o
);
  localparam int LightW  = ptm_pkg::light_bits(LightInt, LightFrac);
  localparam int SquareW = 2 * LightW;
  localparam int BasisW  = ptm_pkg::basis_bits(LightInt, BasisFrac);
  // The square of the most negative code needs one bit more than the basis keeps.
  localparam int NarrowW = BasisW + 1;
  localparam int Drop    = 2 * LightFrac - BasisFrac;

  logic signed [SquareW-1:0] lu, lv, uu, vv, uv;
  assign lu = SquareW'(lu_i);
  assign lv = SquareW'(lv_i);
  assign uu = lu * lu;
  assign vv = lv * lv;
  assign uv = lu * lv;

  logic signed [NarrowW-1:0] uu_narrow, vv_narrow, uv_narrow;
  ptm_arith_narrow #(.InBits(SquareW), .AmountBits(5), .OutBits(NarrowW),
                     .RoundNearest(RoundNearest))
    u_narrow_uu (.x_i(uu), .amount_i(5'(Drop)), .y_o(uu_narrow));
  ptm_arith_narrow #(.InBits(SquareW), .AmountBits(5), .OutBits(NarrowW),
                     .RoundNearest(RoundNearest))
    u_narrow_vv (.x_i(vv), .amount_i(5'(Drop)), .y_o(vv_narrow));
  ptm_arith_narrow #(.InBits(SquareW), .AmountBits(5), .OutBits(NarrowW),
                     .RoundNearest(RoundNearest))
    u_narrow_uv (.x_i(uv), .amount_i(5'(Drop)), .y_o(uv_narrow));

  ptm_arith_saturate #(.InBits(NarrowW), .OutBits(BasisW))
    u_saturate_uu (.x_i(uu_narrow), .y_o(uu_o));
  ptm_arith_saturate #(.InBits(NarrowW), .OutBits(BasisW))
    u_saturate_vv (.x_i(vv_narrow), .y_o(vv_o));
  ptm_arith_saturate #(.InBits(NarrowW), .OutBits(BasisW))
    u_saturate_uv (.x_i(uv_narrow), .y_o(uv_o));
endmodule
