// The PTM evaluator: one LRGB pixel, or one pass of an RGB map's pixel, a cycle. Wiring only.
//
//   D1 D2 |R1| D3 |R2| D4 |R3| D5 |R4| D6 |R5| D7 * |R6| D7 / |R7| assemble |FIFO of 2|
//
// Steps D1..D7 are those of docs/spec/datapath.md; ports, latency and occupancy are in
// docs/spec/evaluator.md, the handshake in docs/spec/handshake.md. What is accepted in cycle 0 is
// offered in cycle 8 if nothing stalls; blocked, the unit holds 7 + 2 beats.
//
// Ready. R7..R1 are ptm_stream_reg, whose ready is combinational: 7 AND-ORs in a row, and a bubble
// anywhere closes up under a stall. The chain starts at the FIFO's registered count, not at
// ready_i, so no combinational path leads from ready_i to ready_o, nor from valid_i to valid_o.
//
// Twin: ptm::reference::evaluate_lrgb() and evaluate_rgb() in model/reference/evaluate.h.
`include "ptm_assert.svh"
module ptm_evaluator #(
  // EvalConfig; ranges in docs/spec/datapath.md, defaults are the preset `base`
  parameter int CoefBits     = 8,   // 4..12
  parameter int DeltaBits    = 9,   // 5..13
  parameter int LightInt     = 2,   // 1..3
  parameter int LightFrac    = 8,   // 4..14
  parameter int BasisFrac    = 8,   // 4..2*LightFrac
  parameter int Guard        = 4,   // 0..12
  parameter int RoundNearest = 1,   // 0: truncate
  parameter int LumBits      = 10,  // 8..12
  parameter int LumFrac      = 0,   // 0..4
  parameter int ShiftMin     = -4,  // -8..0
  parameter int ShiftGroups  = 6,   // 3, 6
  parameter int FilterFrac   = 0,   // 0..4
  // What travels with the operands, untouched: a pixel's id
  parameter int SidebandBits = 32,  // 1 or more
  localparam int StoredW = ptm_pkg::stored_bits(CoefBits, FilterFrac),
  localparam int LightW  = ptm_pkg::light_bits(LightInt, LightFrac),
  localparam int RgbW    = ptm_pkg::rgb_bits(FilterFrac),
  localparam int LumW    = ptm_pkg::lum_bits(LumBits, LumFrac)
) (
  input  logic                            clk_i,
  input  logic                            rst_ni,
  // Operands; index 0 (a0, red) is lowest
  input  logic                            valid_i,
  output logic                            ready_o,
  input  logic [6*StoredW-1:0]            coef_i,     // unsigned
  input  logic [6*CoefBits-1:0]           bias_i,     // unsigned
  input  logic [6*ptm_pkg::ShiftBits-1:0] shift_i,    // signed, ShiftMin..15
  input  logic [3*RgbW-1:0]               rgb_i,      // unsigned; not looked at for an RGB map
  input  logic signed [LightW-1:0]        lu_i,
  input  logic signed [LightW-1:0]        lv_i,
  input  logic                            rgb_map_i,  // 0: an LRGB pixel, 1: a pass of an RGB map
  input  logic [1:0]                      channel_i,  // RGB map: 0, 1, 2 in successive beats
  input  logic [SidebandBits-1:0]         sideband_i,
  // Pixel
  output logic                            valid_o,
  input  logic                            ready_i,
  output logic [3*LumW-1:0]               lum_o,      // what channel c was made from
  output logic                            lum_saturated_o,
  output logic [23:0]                     rgb_o,
  output logic                            color_saturated_o,
  output logic [SidebandBits-1:0]         sideband_o  // of the pixel's last beat
);
  localparam int DeltaW = ptm_pkg::delta_bits(DeltaBits, FilterFrac);
  localparam int BasisW = ptm_pkg::basis_bits(LightInt, BasisFrac);
  localparam int TermW  = ptm_pkg::term_bits(DeltaBits, LightInt, LightFrac, BasisFrac, Guard,
                                             ShiftMin, FilterFrac);
  localparam int SumW   = ptm_pkg::sum_bits(DeltaBits, LightInt, LightFrac, BasisFrac, Guard,
                                            ShiftMin, FilterFrac);
  localparam int ProductW = ptm_pkg::color_product_bits(LumBits, LumFrac, FilterFrac);

  `PTM_ASSERT_INIT(CoefBitsInRange_A, CoefBits >= 4 && CoefBits <= 12)
  `PTM_ASSERT_INIT(DeltaBitsInRange_A, DeltaBits >= 5 && DeltaBits <= 13)
  `PTM_ASSERT_INIT(LightIntInRange_A, LightInt >= 1 && LightInt <= 3)
  `PTM_ASSERT_INIT(LightFracInRange_A, LightFrac >= 4 && LightFrac <= 14)
  `PTM_ASSERT_INIT(BasisFracInRange_A, BasisFrac >= 4 && BasisFrac <= 2 * LightFrac)
  `PTM_ASSERT_INIT(GuardInRange_A, Guard >= 0 && Guard <= 12)
  `PTM_ASSERT_INIT(LumBitsInRange_A, LumBits >= 8 && LumBits <= 12)
  `PTM_ASSERT_INIT(LumFracInRange_A, LumFrac >= 0 && LumFrac <= 4)
  `PTM_ASSERT_INIT(ShiftMinInRange_A, ShiftMin >= -8 && ShiftMin <= 0)
  `PTM_ASSERT_INIT(ShiftGroupsInRange_A, ShiftGroups == 3 || ShiftGroups == 6)
  `PTM_ASSERT_INIT(FilterFracInRange_A, FilterFrac >= 0 && FilterFrac <= 4)

  // What travels beside every stage
  typedef struct packed {
    logic                    rgb_map;
    logic [1:0]              channel;
    logic [SidebandBits-1:0] sideband;
  } tag_t;
  // Payloads of the stage registers
  typedef struct packed {
    tag_t                            tag;
    logic [3*RgbW-1:0]               rgb;
    logic [6*ptm_pkg::ShiftBits-1:0] shift;
    logic signed [LightW-1:0]        lu, lv;
    logic signed [BasisW-1:0]        uu, vv, uv;
    logic [6*DeltaW-1:0]             d;
  } r1_t;
  typedef struct packed {
    tag_t                            tag;
    logic [3*RgbW-1:0]               rgb;
    logic [6*ptm_pkg::ShiftBits-1:0] shift;
    logic signed [DeltaW+BasisW-1:0] p0, p1, p2;
    logic signed [DeltaW+LightW-1:0] p3, p4;
    logic signed [DeltaW-1:0]        p5;
  } r2_t;
  typedef struct packed {
    tag_t                    tag;
    logic [3*RgbW-1:0]       rgb;
    logic signed [TermW-1:0] t0, t1, t2, t3, t4, t5;
  } r3_t;
  typedef struct packed {
    tag_t                   tag;
    logic [3*RgbW-1:0]      rgb;
    logic signed [SumW-1:0] acc;
  } r4_t;
  typedef struct packed {
    tag_t              tag;
    logic [3*RgbW-1:0] rgb;
    logic              lum_saturated;
    logic [LumW-1:0]   lum;
  } r5_t;
  typedef struct packed {
    tag_t                  tag;
    logic                  lum_saturated;
    logic [LumW-1:0]       lum;
    logic [3*ProductW-1:0] product;
  } r6_t;
  typedef struct packed {
    tag_t            tag;
    logic            lum_saturated;
    logic [LumW-1:0] lum;
    logic            color_saturated;
    logic [23:0]     rgb;
  } r7_t;
  typedef struct packed {
    logic [SidebandBits-1:0] sideband;
    logic                    lum_saturated;
    logic [3*LumW-1:0]       lum;
    logic                    color_saturated;
    logic [23:0]             rgb;
  } pixel_t;

  r1_t r1_d, r1_q;
  r2_t r2_d, r2_q;
  r3_t r3_d, r3_q;
  r4_t r4_d, r4_q;
  r5_t r5_d, r5_q;
  r6_t r6_d, r6_q;
  r7_t r7_d, r7_q;
  pixel_t fifo_d, fifo_q;
  // valid[n], ready[n]: the handshake in front of register n+1
  logic [7:0] valid, ready;
  logic fifo_valid, fifo_ready;

  assign valid[0] = valid_i;
  assign ready_o  = ready[0];

  // D1, D2
  ptm_unpack #(
    .CoefBits  (CoefBits),
    .DeltaBits (DeltaBits),
    .FilterFrac(FilterFrac)
  ) u_unpack (
    .coef_i(coef_i),
    .bias_i(bias_i),
    .d_o   (r1_d.d)
  );

  ptm_basis #(
    .LightInt    (LightInt),
    .LightFrac   (LightFrac),
    .BasisFrac   (BasisFrac),
    .RoundNearest(RoundNearest)
  ) u_basis (
    .lu_i(lu_i),
    .lv_i(lv_i),
    .uu_o(r1_d.uu),
    .vv_o(r1_d.vv),
    .uv_o(r1_d.uv)
  );

  assign r1_d.lu           = lu_i;
  assign r1_d.lv           = lv_i;
  assign r1_d.shift        = shift_i;
  assign r1_d.rgb          = rgb_i;
  assign r1_d.tag.rgb_map  = rgb_map_i;
  assign r1_d.tag.channel  = channel_i;
  assign r1_d.tag.sideband = sideband_i;
  ptm_stream_reg #(
    .Width($bits(r1_d))
  ) u_r1 (
    .clk_i  (clk_i),
    .rst_ni (rst_ni),
    .valid_i(valid[0]),
    .ready_o(ready[0]),
    .data_i (r1_d),
    .valid_o(valid[1]),
    .ready_i(ready[1]),
    .data_o (r1_q)
  );

  // D3
  ptm_products #(
    .DeltaW(DeltaW),
    .LightW(LightW),
    .BasisW(BasisW)
  ) u_products (
    .d_i (r1_q.d),
    .uu_i(r1_q.uu),
    .vv_i(r1_q.vv),
    .uv_i(r1_q.uv),
    .lu_i(r1_q.lu),
    .lv_i(r1_q.lv),
    .p0_o(r2_d.p0),
    .p1_o(r2_d.p1),
    .p2_o(r2_d.p2),
    .p3_o(r2_d.p3),
    .p4_o(r2_d.p4),
    .p5_o(r2_d.p5)
  );
  assign r2_d.shift = r1_q.shift;
  assign r2_d.rgb   = r1_q.rgb;
  assign r2_d.tag   = r1_q.tag;
  ptm_stream_reg #(
    .Width($bits(r2_d))
  ) u_r2 (
    .clk_i  (clk_i),
    .rst_ni (rst_ni),
    .valid_i(valid[1]),
    .ready_o(ready[1]),
    .data_i (r2_d),
    .valid_o(valid[2]),
    .ready_i(ready[2]),
    .data_o (r2_q)
  );

  // D4
  ptm_align #(
    .DeltaBits   (DeltaBits),
    .LightInt    (LightInt),
    .LightFrac   (LightFrac),
    .BasisFrac   (BasisFrac),
    .Guard       (Guard),
    .RoundNearest(RoundNearest),
    .ShiftMin    (ShiftMin),
    .ShiftGroups (ShiftGroups),
    .FilterFrac  (FilterFrac)
  ) u_align (
    .p0_i   (r2_q.p0),
    .p1_i   (r2_q.p1),
    .p2_i   (r2_q.p2),
    .p3_i   (r2_q.p3),
    .p4_i   (r2_q.p4),
    .p5_i   (r2_q.p5),
    .shift_i(r2_q.shift),
    .t0_o   (r3_d.t0),
    .t1_o   (r3_d.t1),
    .t2_o   (r3_d.t2),
    .t3_o   (r3_d.t3),
    .t4_o   (r3_d.t4),
    .t5_o   (r3_d.t5)
  );
  assign r3_d.rgb = r2_q.rgb;
  assign r3_d.tag = r2_q.tag;
  ptm_stream_reg #(
    .Width($bits(r3_d))
  ) u_r3 (
    .clk_i  (clk_i),
    .rst_ni (rst_ni),
    .valid_i(valid[2]),
    .ready_o(ready[2]),
    .data_i (r3_d),
    .valid_o(valid[3]),
    .ready_i(ready[3]),
    .data_o (r3_q)
  );

  // D5
  ptm_sum #(
    .TermW(TermW),
    .SumW (SumW)
  ) u_sum (
    .t0_i (r3_q.t0),
    .t1_i (r3_q.t1),
    .t2_i (r3_q.t2),
    .t3_i (r3_q.t3),
    .t4_i (r3_q.t4),
    .t5_i (r3_q.t5),
    .acc_o(r4_d.acc)
  );
  assign r4_d.rgb = r3_q.rgb;
  assign r4_d.tag = r3_q.tag;
  ptm_stream_reg #(
    .Width($bits(r4_d))
  ) u_r4 (
    .clk_i  (clk_i),
    .rst_ni (rst_ni),
    .valid_i(valid[3]),
    .ready_o(ready[3]),
    .data_i (r4_d),
    .valid_o(valid[4]),
    .ready_i(ready[4]),
    .data_o (r4_q)
  );

  // D6
  ptm_luminance #(
    .SumW        (SumW),
    .Guard       (Guard),
    .LumBits     (LumBits),
    .LumFrac     (LumFrac),
    .RoundNearest(RoundNearest)
  ) u_luminance (
    .acc_i      (r4_q.acc),
    .lum_o      (r5_d.lum),
    .saturated_o(r5_d.lum_saturated)
  );
  assign r5_d.rgb = r4_q.rgb;
  assign r5_d.tag = r4_q.tag;
  ptm_stream_reg #(
    .Width($bits(r5_d))
  ) u_r5 (
    .clk_i  (clk_i),
    .rst_ni (rst_ni),
    .valid_i(valid[4]),
    .ready_o(ready[4]),
    .data_i (r5_d),
    .valid_o(valid[5]),
    .ready_i(ready[5]),
    .data_o (r5_q)
  );

  // D7, products
  ptm_color_products #(
    .LumW(LumW),
    .RgbW(RgbW)
  ) u_color_products (
    .lum_i    (r5_q.lum),
    .rgb_i    (r5_q.rgb),
    .product_o(r6_d.product)
  );
  assign r6_d.lum           = r5_q.lum;
  assign r6_d.lum_saturated = r5_q.lum_saturated;
  assign r6_d.tag           = r5_q.tag;
  ptm_stream_reg #(
    .Width($bits(r6_d))
  ) u_r6 (
    .clk_i  (clk_i),
    .rst_ni (rst_ni),
    .valid_i(valid[5]),
    .ready_o(ready[5]),
    .data_i (r6_d),
    .valid_o(valid[6]),
    .ready_i(ready[6]),
    .data_o (r6_q)
  );

  // D7, scale
  ptm_color_scale #(
    .LumBits     (LumBits),
    .LumFrac     (LumFrac),
    .FilterFrac  (FilterFrac),
    .RoundNearest(RoundNearest)
  ) u_color_scale (
    .product_i  (r6_q.product),
    .lum_i      (r6_q.lum),
    .rgb_map_i  (r6_q.tag.rgb_map),
    .rgb_o      (r7_d.rgb),
    .saturated_o(r7_d.color_saturated)
  );
  assign r7_d.lum           = r6_q.lum;
  assign r7_d.lum_saturated = r6_q.lum_saturated;
  assign r7_d.tag           = r6_q.tag;
  ptm_stream_reg #(
    .Width($bits(r7_d))
  ) u_r7 (
    .clk_i  (clk_i),
    .rst_ni (rst_ni),
    .valid_i(valid[6]),
    .ready_o(ready[6]),
    .data_i (r7_d),
    .valid_o(valid[7]),
    .ready_i(ready[7]),
    .data_o (r7_q)
  );

  // Pixel
  ptm_rgb_assemble #(
    .LumW(LumW)
  ) u_rgb_assemble (
    .clk_i            (clk_i),
    .rst_ni           (rst_ni),
    .valid_i          (valid[7]),
    .ready_o          (ready[7]),
    .rgb_map_i        (r7_q.tag.rgb_map),
    .channel_i        (r7_q.tag.channel),
    .lum_i            (r7_q.lum),
    .lum_saturated_i  (r7_q.lum_saturated),
    .rgb_i            (r7_q.rgb),
    .color_saturated_i(r7_q.color_saturated),
    .valid_o          (fifo_valid),
    .ready_i          (fifo_ready),
    .lum_o            (fifo_d.lum),
    .lum_saturated_o  (fifo_d.lum_saturated),
    .rgb_o            (fifo_d.rgb),
    .color_saturated_o(fifo_d.color_saturated)
  );
  assign fifo_d.sideband = r7_q.tag.sideband;
  ptm_stream_fifo2 #(
    .Width($bits(fifo_d))
  ) u_fifo (
    .clk_i  (clk_i),
    .rst_ni (rst_ni),
    .valid_i(fifo_valid),
    .ready_o(fifo_ready),
    .data_i (fifo_d),
    .valid_o(valid_o),
    .ready_i(ready_i),
    .data_o (fifo_q)
  );
  assign lum_o             = fifo_q.lum;
  assign lum_saturated_o   = fifo_q.lum_saturated;
  assign rgb_o             = fifo_q.rgb;
  assign color_saturated_o = fifo_q.color_saturated;
  assign sideband_o        = fifo_q.sideband;
endmodule
