// Steps D1..D7 one behind the other, without a register: what ptm_evaluator must make of a beat.
//
// The same modules as in ptm_evaluator, each proved equal to its C++ function for every input
// (testbench/prove/evaluator_claims.h); this module says which output goes where.
module ptm_evaluator_steps #(
  `include "contract/ptm_evaluator_parameters.svh"
  ,
  localparam int StoredW = ptm_pkg::stored_bits(CoefBits, FilterFrac),
  localparam int LightW  = ptm_pkg::light_bits(LightInt, LightFrac),
  localparam int RgbW    = ptm_pkg::rgb_bits(FilterFrac),
  localparam int LumW    = ptm_pkg::lum_bits(LumBits, LumFrac)
) (
  input  logic [6*StoredW-1:0]            coef_i,
  input  logic [6*CoefBits-1:0]           bias_i,
  input  logic [6*ptm_pkg::ShiftBits-1:0] shift_i,
  input  logic [3*RgbW-1:0]               rgb_i,
  input  logic signed [LightW-1:0]        lu_i,
  input  logic signed [LightW-1:0]        lv_i,
  input  logic                            rgb_map_i,
  output logic [LumW-1:0]                 lum_o,
  output logic                            lum_saturated_o,
  output logic [23:0]                     rgb_o,
  output logic                            color_saturated_o
);
  localparam int DeltaW = ptm_pkg::delta_bits(DeltaBits, FilterFrac);
  localparam int BasisW = ptm_pkg::basis_bits(LightInt, BasisFrac);
  localparam int TermW  = ptm_pkg::term_bits(DeltaBits, LightInt, LightFrac, BasisFrac, Guard,
                                             ShiftMin, FilterFrac);
  localparam int SumW   = ptm_pkg::sum_bits(DeltaBits, LightInt, LightFrac, BasisFrac, Guard,
                                            ShiftMin, FilterFrac);
  localparam int ProductW = ptm_pkg::color_product_bits(LumBits, LumFrac, FilterFrac);

  logic signed [DeltaW-1:0] d0, d1, d2, d3, d4, d5;
  ptm_evaluator_unpack #(
    .CoefBits(CoefBits), .DeltaBits(DeltaBits), .FilterFrac(FilterFrac)
  ) u_unpack (
    .coef_i(coef_i), .bias_i(bias_i), .d0_o(d0), .d1_o(d1), .d2_o(d2), .d3_o(d3), .d4_o(d4),
    .d5_o(d5)
  );

  logic signed [BasisW-1:0] uu, vv, uv;
  ptm_evaluator_basis #(
    .LightInt(LightInt), .LightFrac(LightFrac), .BasisFrac(BasisFrac), .RoundNearest(RoundNearest)
  ) u_basis (
    .lu_i(lu_i), .lv_i(lv_i), .uu_o(uu), .vv_o(vv), .uv_o(uv)
  );

  logic signed [DeltaW+BasisW-1:0] p0, p1, p2;
  logic signed [DeltaW+LightW-1:0] p3, p4;
  logic signed [DeltaW-1:0]        p5;
  ptm_evaluator_products #(
    .DeltaW(DeltaW), .LightW(LightW), .BasisW(BasisW)
  ) u_products (
    .d0_i(d0), .d1_i(d1), .d2_i(d2), .d3_i(d3), .d4_i(d4), .d5_i(d5), .uu_i(uu), .vv_i(vv),
    .uv_i(uv), .lu_i(lu_i), .lv_i(lv_i), .p0_o(p0), .p1_o(p1), .p2_o(p2), .p3_o(p3), .p4_o(p4),
    .p5_o(p5)
  );

  logic signed [TermW-1:0] t0, t1, t2, t3, t4, t5;
  ptm_evaluator_align #(
    .DeltaBits(DeltaBits), .LightInt(LightInt), .LightFrac(LightFrac), .BasisFrac(BasisFrac),
    .Guard(Guard), .RoundNearest(RoundNearest), .ShiftMin(ShiftMin), .ShiftGroups(ShiftGroups),
    .FilterFrac(FilterFrac)
  ) u_align (
    .p0_i(p0), .p1_i(p1), .p2_i(p2), .p3_i(p3), .p4_i(p4), .p5_i(p5), .shift_i(shift_i),
    .t0_o(t0), .t1_o(t1), .t2_o(t2), .t3_o(t3), .t4_o(t4), .t5_o(t5)
  );

  logic signed [SumW-1:0] acc;
  ptm_evaluator_sum #(
    .TermW(TermW), .SumW(SumW)
  ) u_sum (
    .t0_i(t0), .t1_i(t1), .t2_i(t2), .t3_i(t3), .t4_i(t4), .t5_i(t5), .acc_o(acc)
  );

  ptm_evaluator_luminance #(
    .SumW(SumW), .Guard(Guard), .LumBits(LumBits), .LumFrac(LumFrac), .RoundNearest(RoundNearest)
  ) u_luminance (
    .acc_i(acc), .lum_o(lum_o), .saturated_o(lum_saturated_o)
  );

  logic [ProductW-1:0] red, green, blue;
  ptm_evaluator_color_products #(
    .LumW(LumW), .RgbW(RgbW)
  ) u_color_products (
    .lum_i(lum_o), .rgb_i(rgb_i), .red_o(red), .green_o(green), .blue_o(blue)
  );

  ptm_evaluator_color_scale #(
    .LumBits(LumBits), .LumFrac(LumFrac), .FilterFrac(FilterFrac), .RoundNearest(RoundNearest)
  ) u_color_scale (
    .red_i(red), .green_i(green), .blue_i(blue), .lum_i(lum_o), .rgb_map_i(rgb_map_i),
    .rgb_o(rgb_o), .saturated_o(color_saturated_o)
  );
endmodule
