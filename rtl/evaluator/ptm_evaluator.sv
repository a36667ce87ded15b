// The PTM evaluator: one LRGB pixel, or one pass of an RGB map's pixel, a cycle. Wiring only.
//
//   D1 D2 |R1| D3 |R2| D4 |R3| D5 |R4| D6 |R5| D7 * |R6| D7 / |R7| assemble |FIFO of 2|
//
// Steps D1..D7 are those of docs/spec/datapath.md; ports, latency and occupancy are in
// docs/spec/evaluator.md, the handshake in docs/spec/handshake.md. What is accepted in cycle 0 is
// offered in cycle 8 if nothing stalls; blocked, the unit holds 7 + 2 beats.
//
// Ready. R1..R7 are a ptm_stream_chain, whose ready is combinational: a carry through 7 bits, and a
// bubble anywhere closes up under a stall. The carry starts at the FIFO's registered count, not at
// ready_i, so no combinational path leads from ready_i to ready_o, nor from valid_i to valid_o.
//
// Twin: ptm::reference::evaluate_lrgb() and evaluate_rgb() in model/reference/evaluate.h.
`include "ptm_assert.svh"
module ptm_evaluator #(
  `include "contract/ptm_evaluator_parameters.svh"
  ,
  // 1: an RGB map's three passes leave as one pixel; 0: every pass leaves as it comes, its
  // channel's value in all three places (evaluators side by side, one a channel)
  parameter int Assemble     = 1,
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

  ptm_evaluator_parameters #(
    `include "contract/ptm_evaluator_map.svh"
    ,
    .Assemble(Assemble), .SidebandBits(SidebandBits)
  ) u_parameters ();

  // What travels beside every stage
  typedef struct packed {
    logic                    rgb_map;
    logic [1:0]              channel;
    logic [SidebandBits-1:0] sideband;
  } tag_t;

  logic [1:7] load;  // register n takes over what stands in front of it
  logic r7_valid, r7_ready;
  ptm_stream_chain #(
    .Stages(7)
  ) u_chain (
    .clk_i(clk_i), .rst_ni(rst_ni), .valid_i(valid_i), .ready_o(ready_o), .load_o(load),
    .valid_o(r7_valid), .ready_i(r7_ready)
  );

  // D1, D2 | R1
  tag_t                     tag;
  logic signed [DeltaW-1:0] d0, d1, d2, d3, d4, d5;
  logic signed [BasisW-1:0] uu, vv, uv;
  assign tag.rgb_map  = rgb_map_i;
  assign tag.channel  = channel_i;
  assign tag.sideband = sideband_i;
  ptm_evaluator_unpack #(
    .CoefBits(CoefBits), .DeltaBits(DeltaBits), .FilterFrac(FilterFrac)
  ) u_unpack (
    .coef_i(coef_i), .bias_i(bias_i), .d0_o(d0), .d1_o(d1), .d2_o(d2), .d3_o(d3), .d4_o(d4),
    .d5_o(d5)
  );
  ptm_evaluator_basis #(
    .LightInt(LightInt), .LightFrac(LightFrac), .BasisFrac(BasisFrac), .RoundNearest(RoundNearest)
  ) u_basis (
    .lu_i(lu_i), .lv_i(lv_i), .uu_o(uu), .vv_o(vv), .uv_o(uv)
  );

  tag_t                            r1_tag_q;
  logic [3*RgbW-1:0]               r1_rgb_q;
  logic [6*ptm_pkg::ShiftBits-1:0] r1_shift_q;
  logic signed [LightW-1:0]        r1_lu_q, r1_lv_q;
  logic signed [BasisW-1:0]        r1_uu_q, r1_vv_q, r1_uv_q;
  logic signed [DeltaW-1:0]        r1_d0_q, r1_d1_q, r1_d2_q, r1_d3_q, r1_d4_q, r1_d5_q;
  always_ff @(posedge clk_i) begin
    if (load[1]) begin
      r1_tag_q   <= tag;
      r1_rgb_q   <= rgb_i;
      r1_shift_q <= shift_i;
      r1_lu_q    <= lu_i;
      r1_lv_q    <= lv_i;
      r1_uu_q    <= uu;
      r1_vv_q    <= vv;
      r1_uv_q    <= uv;
      r1_d0_q    <= d0;
      r1_d1_q    <= d1;
      r1_d2_q    <= d2;
      r1_d3_q    <= d3;
      r1_d4_q    <= d4;
      r1_d5_q    <= d5;
    end
  end

  // D3 | R2
  logic signed [DeltaW+BasisW-1:0] p0, p1, p2;
  logic signed [DeltaW+LightW-1:0] p3, p4;
  logic signed [DeltaW-1:0]        p5;
  ptm_evaluator_products #(
    .DeltaW(DeltaW), .LightW(LightW), .BasisW(BasisW)
  ) u_products (
    .d0_i(r1_d0_q), .d1_i(r1_d1_q), .d2_i(r1_d2_q), .d3_i(r1_d3_q), .d4_i(r1_d4_q), .d5_i(r1_d5_q),
    .uu_i(r1_uu_q), .vv_i(r1_vv_q), .uv_i(r1_uv_q), .lu_i(r1_lu_q), .lv_i(r1_lv_q), .p0_o(p0),
    .p1_o(p1), .p2_o(p2), .p3_o(p3), .p4_o(p4), .p5_o(p5)
  );

  tag_t                            r2_tag_q;
  logic [3*RgbW-1:0]               r2_rgb_q;
  logic [6*ptm_pkg::ShiftBits-1:0] r2_shift_q;
  logic signed [DeltaW+BasisW-1:0] r2_p0_q, r2_p1_q, r2_p2_q;
  logic signed [DeltaW+LightW-1:0] r2_p3_q, r2_p4_q;
  logic signed [DeltaW-1:0]        r2_p5_q;
  always_ff @(posedge clk_i) begin
    if (load[2]) begin
      r2_tag_q   <= r1_tag_q;
      r2_rgb_q   <= r1_rgb_q;
      r2_shift_q <= r1_shift_q;
      r2_p0_q    <= p0;
      r2_p1_q    <= p1;
      r2_p2_q    <= p2;
      r2_p3_q    <= p3;
      r2_p4_q    <= p4;
      r2_p5_q    <= p5;
    end
  end

  // D4 | R3
  logic signed [TermW-1:0] t0, t1, t2, t3, t4, t5;
  ptm_evaluator_align #(
    .DeltaBits(DeltaBits), .LightInt(LightInt), .LightFrac(LightFrac), .BasisFrac(BasisFrac),
    .Guard(Guard), .RoundNearest(RoundNearest), .ShiftMin(ShiftMin), .ShiftGroups(ShiftGroups),
    .FilterFrac(FilterFrac)
  ) u_align (
    .p0_i(r2_p0_q), .p1_i(r2_p1_q), .p2_i(r2_p2_q), .p3_i(r2_p3_q), .p4_i(r2_p4_q), .p5_i(r2_p5_q),
    .shift_i(r2_shift_q), .t0_o(t0), .t1_o(t1), .t2_o(t2), .t3_o(t3), .t4_o(t4), .t5_o(t5)
  );

  tag_t                    r3_tag_q;
  logic [3*RgbW-1:0]       r3_rgb_q;
  logic signed [TermW-1:0] r3_t0_q, r3_t1_q, r3_t2_q, r3_t3_q, r3_t4_q, r3_t5_q;
  always_ff @(posedge clk_i) begin
    if (load[3]) begin
      r3_tag_q <= r2_tag_q;
      r3_rgb_q <= r2_rgb_q;
      r3_t0_q  <= t0;
      r3_t1_q  <= t1;
      r3_t2_q  <= t2;
      r3_t3_q  <= t3;
      r3_t4_q  <= t4;
      r3_t5_q  <= t5;
    end
  end

  // D5 | R4
  logic signed [SumW-1:0] acc;
  ptm_evaluator_sum #(
    .TermW(TermW), .SumW(SumW)
  ) u_sum (
    .t0_i(r3_t0_q), .t1_i(r3_t1_q), .t2_i(r3_t2_q), .t3_i(r3_t3_q), .t4_i(r3_t4_q), .t5_i(r3_t5_q),
    .acc_o(acc)
  );

  tag_t                   r4_tag_q;
  logic [3*RgbW-1:0]      r4_rgb_q;
  logic signed [SumW-1:0] r4_acc_q;
  always_ff @(posedge clk_i) begin
    if (load[4]) begin
      r4_tag_q <= r3_tag_q;
      r4_rgb_q <= r3_rgb_q;
      r4_acc_q <= acc;
    end
  end

  // D6 | R5
  logic [LumW-1:0] lum;
  logic            lum_saturated;
  ptm_evaluator_luminance #(
    .SumW(SumW), .Guard(Guard), .LumBits(LumBits), .LumFrac(LumFrac), .RoundNearest(RoundNearest)
  ) u_luminance (
    .acc_i(r4_acc_q), .lum_o(lum), .saturated_o(lum_saturated)
  );

  tag_t              r5_tag_q;
  logic [3*RgbW-1:0] r5_rgb_q;
  logic [LumW-1:0]   r5_lum_q;
  logic              r5_lum_saturated_q;
  always_ff @(posedge clk_i) begin
    if (load[5]) begin
      r5_tag_q           <= r4_tag_q;
      r5_rgb_q           <= r4_rgb_q;
      r5_lum_q           <= lum;
      r5_lum_saturated_q <= lum_saturated;
    end
  end

  // D7 products | R6
  logic [ProductW-1:0] red, green, blue;
  ptm_evaluator_color_products #(
    .LumW(LumW), .RgbW(RgbW)
  ) u_color_products (
    .lum_i(r5_lum_q), .rgb_i(r5_rgb_q), .red_o(red), .green_o(green), .blue_o(blue)
  );

  tag_t                r6_tag_q;
  logic [ProductW-1:0] r6_red_q, r6_green_q, r6_blue_q;
  logic [LumW-1:0]     r6_lum_q;
  logic                r6_lum_saturated_q;
  always_ff @(posedge clk_i) begin
    if (load[6]) begin
      r6_tag_q           <= r5_tag_q;
      r6_red_q           <= red;
      r6_green_q         <= green;
      r6_blue_q          <= blue;
      r6_lum_q           <= r5_lum_q;
      r6_lum_saturated_q <= r5_lum_saturated_q;
    end
  end

  // D7 scale | R7
  logic [23:0] rgb;
  logic        color_saturated;
  ptm_evaluator_color_scale #(
    .LumBits(LumBits), .LumFrac(LumFrac), .FilterFrac(FilterFrac), .RoundNearest(RoundNearest)
  ) u_color_scale (
    .red_i(r6_red_q), .green_i(r6_green_q), .blue_i(r6_blue_q), .lum_i(r6_lum_q),
    .rgb_map_i(r6_tag_q.rgb_map), .rgb_o(rgb), .saturated_o(color_saturated)
  );

  tag_t            r7_tag_q;
  logic [23:0]     r7_rgb_q;
  logic [LumW-1:0] r7_lum_q;
  logic            r7_color_saturated_q, r7_lum_saturated_q;
  always_ff @(posedge clk_i) begin
    if (load[7]) begin
      r7_tag_q             <= r6_tag_q;
      r7_rgb_q             <= rgb;
      r7_lum_q             <= r6_lum_q;
      r7_color_saturated_q <= color_saturated;
      r7_lum_saturated_q   <= r6_lum_saturated_q;
    end
  end

  // Assembly
  logic pixel_valid, pixel_ready;
  logic [3*LumW-1:0] pixel_lum;
  logic [23:0]       pixel_rgb;
  logic [1:0]        pixel_flags;  // lum_saturated, color_saturated
  if (Assemble != 0) begin : gen_assemble
    ptm_evaluator_assemble #(
      .LumW(LumW)
    ) u_rgb_assemble (
      .clk_i(clk_i), .rst_ni(rst_ni), .valid_i(r7_valid), .ready_o(r7_ready),
      .rgb_map_i(r7_tag_q.rgb_map), .channel_i(r7_tag_q.channel), .lum_i(r7_lum_q),
      .lum_saturated_i(r7_lum_saturated_q), .rgb_i(r7_rgb_q),
      .color_saturated_i(r7_color_saturated_q), .valid_o(pixel_valid), .ready_i(pixel_ready),
      .lum_o(pixel_lum), .lum_saturated_o(pixel_flags[1]), .rgb_o(pixel_rgb),
      .color_saturated_o(pixel_flags[0])
    );
  end else begin : gen_passes
    assign pixel_valid = r7_valid;
    assign r7_ready    = pixel_ready;
    assign pixel_lum   = {3{r7_lum_q}};
    assign pixel_rgb   = r7_rgb_q;
    assign pixel_flags = {r7_lum_saturated_q, r7_color_saturated_q};
    logic unused;
    assign unused = ^{r7_tag_q.rgb_map, r7_tag_q.channel};
  end

  // FIFO: the head is the output
  logic load_head, load_tail, advance;
  ptm_stream_fifo2 u_fifo (
    .clk_i(clk_i), .rst_ni(rst_ni), .valid_i(pixel_valid), .ready_o(pixel_ready),
    .load_head_o(load_head), .load_tail_o(load_tail), .advance_o(advance), .valid_o(valid_o),
    .ready_i(ready_i)
  );

  logic [3*LumW-1:0]       head_lum_q, tail_lum_q;
  logic [23:0]             head_rgb_q, tail_rgb_q;
  logic [1:0]              head_flags_q, tail_flags_q;
  logic [SidebandBits-1:0] head_sideband_q, tail_sideband_q;
  always_ff @(posedge clk_i) begin
    if (load_head) begin
      head_lum_q      <= pixel_lum;
      head_rgb_q      <= pixel_rgb;
      head_flags_q    <= pixel_flags;
      head_sideband_q <= r7_tag_q.sideband;
    end else if (advance) begin
      head_lum_q      <= tail_lum_q;
      head_rgb_q      <= tail_rgb_q;
      head_flags_q    <= tail_flags_q;
      head_sideband_q <= tail_sideband_q;
    end
    if (load_tail) begin
      tail_lum_q      <= pixel_lum;
      tail_rgb_q      <= pixel_rgb;
      tail_flags_q    <= pixel_flags;
      tail_sideband_q <= r7_tag_q.sideband;
    end
  end
  assign lum_o                                = head_lum_q;
  assign rgb_o                                = head_rgb_q;
  assign {lum_saturated_o, color_saturated_o} = head_flags_q;
  assign sideband_o                           = head_sideband_q;
endmodule
