// The back of the texture unit: from the taps of a beat in D to the pixel. Wiring only.
//
//   D |Q|P| U7 |L1| U7 |L2| U8 |L3| U9 U10 |O| D1..D7 (evaluator) | U11 products |C1| result |C2|
//
// With effects (docs/spec/effects.md) extra passes go before a fragment's own; what they give is
// kept behind the evaluator and travels beside the pixel to the effect chain behind C2.
//
// Values: docs/spec/unit.md. Cycles: docs/spec/unit-timing.md; what leaves D in cycle c as a
// fragment's only beat is offered as a pixel in cycle c + 16 if nothing stalls. D itself belongs to
// the front, with what stands in it, until d_valid_i and d_ready_o are high together.
//
// Twin: shade() in model/reference/unit/shade.h.
`include "ptm_assert.svh"
module ptm_back #(
  `include "contract/ptm_unit_back_parameters.svh"
) (
  input  logic        clk_i,
  input  logic        rst_ni,
  input  logic [ptm_unit_pkg::Draws*ptm_unit_pkg::DrawW-1:0] draws_i,  // draw_t, draw 0 lowest
  input  logic [ptm_unit_pkg::Draws*ptm_unit_pkg::EffectW-1:0] effects_i,  // effect_t
  // Tables of effects: the address is an offset from 0x3000
  input  logic        table_we_i,
  input  logic [9:0]  table_addr_i,
  input  logic [11:0] table_data_i,
  // Palettes: addresses are offsets from 0x4000 and 0x8000
  input  logic        pal_lrgb_we_i,
  input  logic [10:0] pal_lrgb_addr_i,
  input  logic        pal_rgb_we_i,
  input  logic [14:0] pal_rgb_addr_i,
  input  logic [31:0] pal_data_i,
  input  logic [3:0]  pal_upper_i,  // above it; CoefBits above 10 only
  // What stands in D; it leaves in a cycle in which d_valid_i and d_ready_o are high
  input  logic                                d_valid_i,
  output logic                                d_ready_o,
  input  ptm_unit_pkg::beat_t                 d_beat_i,
  input  logic [Tmus*ptm_unit_pkg::TapsW-1:0] d_taps_i,  // taps_t, TMU 0 lowest
  // The half-vector of the fragment that is next to leave O
  input  logic signed [ptm_unit_pkg::LightMax-1:0] hu_i,
  input  logic signed [ptm_unit_pkg::LightMax-1:0] hv_i,
  output logic                                     o_leaves_o,  // it leaves
  // Pixels
  output logic                               pix_valid_o,
  input  logic                               pix_ready_i,
  output logic [ptm_unit_pkg::PixelBits-1:0] pix_x_o,
  output logic [ptm_unit_pkg::PixelBits-1:0] pix_y_o,
  output logic [23:0]                        pix_rgb_o,  // red lowest
  output logic [7:0]                         pix_alpha_o,
  output logic                               pix_lum_saturated_o,
  output logic                               pix_color_saturated_o,
  // What counters grow by, each in the cycle of the event
  output logic [2:0] inc_palette_o,
  output logic [7:0] inc_filter_o,
  output logic [5:0] inc_eval_o,
  output logic [2:0] inc_combine_o,
  output logic [5:0] inc_effects_o
);
  localparam int StoredW  = ptm_pkg::stored_bits(CoefBits, FilterFrac);
  localparam int LightW   = ptm_pkg::light_bits(LightInt, LightFrac);
  localparam int RgbW     = ptm_pkg::rgb_bits(FilterFrac);
  localparam int LumW     = ptm_pkg::lum_bits(LumBits, LumFrac);
  localparam int PixelW   = ptm_unit_pkg::PixelBits;
  localparam int DrawNumW = ptm_unit_pkg::DrawBits;

  // D to O
  logic                            load_q, o_valid, o_ready, o_last_pass, o_rgb_map;
  logic [EvalLanes*6*StoredW-1:0]  o_coef;
  logic [6*CoefBits-1:0]           o_bias;
  logic [6*ptm_pkg::ShiftBits-1:0] o_shift;
  logic [3*RgbW-1:0]               o_rgb;
  logic signed [ptm_unit_pkg::LightMax-1:0] o_lu, o_lv;
  logic [1:0]                      o_channel;
  logic [PixelW-1:0]               o_x, o_y;
  logic [DrawNumW-1:0]             o_draw;
  logic [7:0]                      o_map_alpha;
  logic [31:0]                     o_color;
  logic [2:0]                      d_palette_taps, o_passes;
  logic                            o_extra;
  logic [1:0]                      o_number;
  ptm_filter #(
    .CoefBits(CoefBits), .RoundNearest(RoundNearest), .FilterFrac(FilterFrac), .Tmus(Tmus),
    .PaletteLrgbPorts(PaletteLrgbPorts), .PaletteRgbPorts(PaletteRgbPorts),
    .EvalLanes(EvalLanes), .HalfVector(HalfVector), .ExtraSets(ExtraSets),
    .ExtraPasses(ExtraPasses)
  ) u_filter (
    .clk_i(clk_i), .rst_ni(rst_ni), .draws_i(draws_i), .effects_i(effects_i),
    .pal_lrgb_we_i(pal_lrgb_we_i),
    .pal_lrgb_addr_i(pal_lrgb_addr_i), .pal_rgb_we_i(pal_rgb_we_i),
    .pal_rgb_addr_i(pal_rgb_addr_i), .pal_data_i(pal_data_i), .pal_upper_i(pal_upper_i),
    .valid_i(d_valid_i), .ready_o(d_ready_o), .beat_i(d_beat_i), .taps_i(d_taps_i),
    .load_q_o(load_q), .palette_taps_o(d_palette_taps), .valid_o(o_valid), .ready_i(o_ready),
    .last_pass_o(o_last_pass), .extra_o(o_extra), .number_o(o_number), .passes_o(o_passes),
    .hu_i(hu_i), .hv_i(hv_i), .coef_o(o_coef), .bias_o(o_bias), .shift_o(o_shift),
    .rgb_o(o_rgb), .lu_o(o_lu), .lv_o(o_lv), .rgb_map_o(o_rgb_map), .channel_o(o_channel),
    .x_o(o_x), .y_o(o_y), .draw_o(o_draw), .map_alpha_o(o_map_alpha), .color_o(o_color)
  );

  // D1 to D7; what U11 needs travels in lane 0's sideband. With three lanes a pass of an RGB map
  // enters each in the same cycle and leaves each in the same cycle; all else takes lane 0 alone.
  // The other lanes hold a part of what lane 0 holds, so they never refuse what it accepts.
  // A unit with extra passes has three bits more there: that it is one, and which.
  localparam int ExtraW    = ExtraPasses == 0 ? 0 : 3;
  localparam int SidebandW = 1 + 2 * PixelW + DrawNumW + 8 + 32 + ExtraW;
  logic [EvalLanes-1:0] lane_in_ready, lane_valid;
  logic                 e_valid, e_ready, e_rgb_map;
  logic [EvalLanes-1:0] e_lum_flags, e_color_flags;
  logic [23:0]          e_rgb;
  logic [SidebandW-1:0] e_sideband;
  logic [EvalLanes*24-1:0] lane_rgb;
  logic [LumW-1:0]         e_lum;
  assign o_ready = lane_in_ready[0];
  assign e_valid = lane_valid[0];
  `PTM_ASSERT(LanesAcceptTogether_A, !(o_valid && o_ready && o_rgb_map) || &lane_in_ready)
  `PTM_ASSERT(LanesOfferTogether_A, !(e_valid && e_rgb_map) || &lane_valid)
  for (genvar e = 0; e < EvalLanes; e++) begin : gen_lane
    // What goes in and out of this lane now
    logic                   in, out;
    logic [SidebandW-1:0]   in_sideband, out_sideband;
    logic [3*LumW-1:0]      lum;
    if (e == 0) begin : gen_first
      assign in          = o_valid;
      assign out         = e_ready;
      if (ExtraPasses == 0) begin : gen_own_passes
        assign in_sideband = {o_rgb_map, o_x, o_y, o_draw, o_map_alpha, o_color};
      end else begin : gen_extra_passes
        assign in_sideband = {o_extra, o_number, o_rgb_map, o_x, o_y, o_draw, o_map_alpha,
                              o_color};
      end
      assign e_sideband  = out_sideband;
      assign e_lum       = lum[LumW-1:0];
    end else begin : gen_other
      assign in          = o_valid && o_ready && o_rgb_map;
      assign out         = e_ready && e_valid && e_rgb_map;
      assign in_sideband = '0;
    end
    ptm_evaluator #(
      `include "contract/ptm_evaluator_map.svh"
      ,
      .Assemble(EvalLanes == 1 ? 1 : 0), .SidebandBits(SidebandW)
    ) u_evaluator (
      .clk_i(clk_i), .rst_ni(rst_ni), .valid_i(in), .ready_o(lane_in_ready[e]),
      .coef_i(o_coef[6*StoredW*e +: 6*StoredW]), .bias_i(o_bias), .shift_i(o_shift),
      .rgb_i(o_rgb), .lu_i(o_lu[LightW-1:0]), .lv_i(o_lv[LightW-1:0]), .rgb_map_i(o_rgb_map),
      .channel_i(o_channel), .sideband_i(in_sideband), .valid_o(lane_valid[e]), .ready_i(out),
      .lum_o(lum), .lum_saturated_o(e_lum_flags[e]), .rgb_o(lane_rgb[24*e +: 24]),
      .color_saturated_o(e_color_flags[e]), .sideband_o(out_sideband)
    );
    logic unused_lane;
    assign unused_lane = ^{lum, out_sideband, lane_rgb[24*e +: 24]};
  end
  logic e_lum_saturated, e_color_saturated;
  if (EvalLanes == 1) begin : gen_assembled
    assign e_rgb             = lane_rgb;
    assign e_lum_saturated   = e_lum_flags[0];
    assign e_color_saturated = e_color_flags[0];
  end else begin : gen_side_by_side
    assign e_rgb             = e_rgb_map ? {lane_rgb[71:64], lane_rgb[39:32], lane_rgb[7:0]} :
                                           lane_rgb[23:0];
    assign e_lum_saturated   = e_rgb_map ? |e_lum_flags : e_lum_flags[0];
    assign e_color_saturated = e_rgb_map ? |e_color_flags : e_color_flags[0];
  end

  // U11
  logic [PixelW-1:0]   e_x, e_y;
  logic [DrawNumW-1:0] e_draw;
  logic [7:0]          e_map_alpha, e_color_alpha;
  logic [23:0]         e_color;
  logic [2:0]          e_combine;
  logic [8:0]          e_ka, e_kd;
  assign {e_rgb_map, e_x, e_y, e_draw, e_map_alpha, e_color_alpha, e_color} =
      e_sideband[SidebandW-ExtraW-1:0];
  /* verilator lint_off PINCONNECTEMPTY */
  ptm_registers_draw_select u_e_draw (
    .draws_i(draws_i), .draw_i(e_draw), .combine_o(e_combine), .ka_o(e_ka), .kd_o(e_kd),
    .format_o(), .bilinear_o(), .color_o(), .palette_o(), .bias_o(), .shift_o()
  );
  /* verilator lint_on PINCONNECTEMPTY */
  // An extra pass goes no further than its value, which is taken when it is offered.
  logic       e_extra, e_pixel, c1_ready, load_c1, load_c2;
  logic [1:0] e_number;
  if (ExtraPasses == 0) begin : gen_pixels_only
    assign {e_extra, e_number} = '0;
    assign e_pixel             = e_valid;
    assign e_ready             = c1_ready;
  end else begin : gen_take_extra
    assign {e_extra, e_number} = e_sideband[SidebandW-1 -: 3];
    assign e_pixel             = e_valid && !e_extra;
    assign e_ready             = c1_ready || e_extra;
  end

  ptm_unit_pkg::pixel_t c2_pixel;
  logic                 c2_valid, c2_ready;
  logic [DrawNumW-1:0]  c2_draw;
  assign c2_pixel.draw = c2_draw;
  ptm_back_combine #(
    .RoundNearest(RoundNearest)
  ) u_combine (
    .clk_i(clk_i), .rst_ni(rst_ni), .valid_i(e_pixel), .ready_o(c1_ready), .x_i(e_x), .y_i(e_y),
    .combine_i(e_combine), .ka_i(e_ka), .kd_i(e_kd), .lit_i(e_rgb), .color_i(e_color),
    .color_alpha_i(e_color_alpha), .map_alpha_i(e_map_alpha),
    .flags_i({e_lum_saturated, e_color_saturated}), .valid_o(c2_valid), .ready_i(c2_ready),
    .x_o(c2_pixel.x), .y_o(c2_pixel.y), .rgb_o(c2_pixel.rgb), .alpha_o(c2_pixel.alpha),
    .flags_o(c2_pixel.flags), .load_c1_o(load_c1), .load_c2_o(load_c2)
  );

  // Effects behind C2
  ptm_unit_pkg::pixel_t pixel;
  if (Stages == 0) begin : gen_no_stages
    assign c2_draw       = '0;
    assign pixel         = c2_pixel;
    assign pix_valid_o   = c2_valid;
    assign c2_ready      = pix_ready_i;
    assign inc_effects_o = '0;
    logic unused_effects;
    assign unused_effects = ^{e_lum, e_extra, e_number, load_c1, load_c2, table_we_i,
                              table_addr_i, table_data_i};
  end else begin : gen_stages
    ptm_back_effects #(
      .LumBits(LumBits), .LumFrac(LumFrac), .RoundNearest(RoundNearest),
      .ExtraPasses(ExtraPasses), .Stages(Stages)
    ) u_effects (
      .clk_i(clk_i), .rst_ni(rst_ni), .draws_i(draws_i), .effects_i(effects_i),
      .table_we_i(table_we_i), .table_addr_i(table_addr_i), .table_data_i(table_data_i),
      .take_i(e_valid && e_extra), .number_i(e_number), .lum_i(e_lum), .draw_i(e_draw),
      .load_c1_i(load_c1), .load_c2_i(load_c2), .c2_draw_o(c2_draw), .valid_i(c2_valid),
      .ready_o(c2_ready), .pixel_i(c2_pixel), .valid_o(pix_valid_o), .ready_i(pix_ready_i),
      .pixel_o(pixel), .inc_o(inc_effects_o)
    );
  end
  assign pix_x_o               = pixel.x;
  assign pix_y_o               = pixel.y;
  assign pix_rgb_o             = pixel.rgb;
  assign pix_alpha_o           = pixel.alpha;
  assign pix_lum_saturated_o   = pixel.flags[1];
  assign pix_color_saturated_o = pixel.flags[0];

  // What counters grow by: a beat as it leaves D, a fragment as its last pass leaves O
  logic [2:0] d_format, o_format, o_combine, combine_multiplies;
  logic       d_bilinear, d_color;
  logic [2:0] d_sets;
  if (ExtraSets == 0) begin : gen_no_sets
    assign d_sets = 3'd0;
  end else begin : gen_sets
    logic [ptm_unit_pkg::Draws*3-1:0] sets;
    for (genvar d = 0; d < ptm_unit_pkg::Draws; d++) begin : gen_of_draw
      assign sets[3*d +: 3] =
          effects_i[d*ptm_unit_pkg::EffectW+ptm_unit_pkg::EffectSetsAt +: 3];
    end
    ptm_registers_by_draw #(.Width(3)) u_sets (
      .values_i(sets), .draw_i(d_beat_i.draw), .value_o(d_sets)
    );
  end
  logic [5:0] eval_multiplies;
  logic [7:0] filter_multiplies;
  /* verilator lint_off PINCONNECTEMPTY */
  ptm_registers_draw_select u_d_draw (
    .draws_i(draws_i), .draw_i(d_beat_i.draw), .format_o(d_format), .bilinear_o(d_bilinear),
    .color_o(d_color), .palette_o(), .bias_o(), .shift_o(), .combine_o(), .ka_o(), .kd_o()
  );
  ptm_registers_draw_select u_o_draw (
    .draws_i(draws_i), .draw_i(o_draw), .format_o(o_format), .combine_o(o_combine),
    .bilinear_o(), .color_o(), .palette_o(), .bias_o(), .shift_o(), .ka_o(), .kd_o()
  );
  /* verilator lint_on PINCONNECTEMPTY */
  ptm_back_multiply_count #(
    .CoefBits(CoefBits), .Tmus(Tmus), .ExtraSets(ExtraSets), .ExtraPasses(ExtraPasses)
  ) u_multiply_count (
    .format_i(d_format), .bilinear_i(d_bilinear), .color_i(d_color), .group_i(d_beat_i.group),
    .sets_i(d_sets), .o_passes_i(o_passes),
    .second_i(d_beat_i.second), .map_fetched_i(d_beat_i.ptm.fetched),
    .color_fetched_i(d_beat_i.color.fetched), .filter_o(filter_multiplies),
    .o_format_i(o_format), .o_combine_i(o_combine), .eval_o(eval_multiplies),
    .combine_o(combine_multiplies)
  );
  logic o_leaves;
  assign o_leaves      = o_valid && o_ready && o_last_pass;
  assign o_leaves_o    = o_leaves;
  assign inc_palette_o = d_valid_i && d_ready_o ? d_palette_taps : '0;
  assign inc_filter_o  = load_q ? filter_multiplies : '0;
  assign inc_eval_o    = o_leaves ? eval_multiplies : '0;
  assign inc_combine_o = o_leaves ? combine_multiplies : '0;

  logic unused;
  assign unused = ^{o_lu, o_lv, effects_i, pixel.draw, o_extra, o_number};
endmodule
