// From the taps of a beat in D to the operands of a fragment in O. Wiring and control.
//
//   D look-up |Q| taps |P| U7 u |L1| U7 v |L2| U8 |L3| U9, U10 |O| -> evaluator
//
// Values are those of docs/spec/unit.md, cycles those of docs/spec/unit-timing.md (Palette,
// Filter). Everything is beat-parallel: up to L2 a lane for each field that a TMU's word may have
// (three or two coefficients, or four bytes; TMU 0's also a palette's eighteen), then one for each
// of the 26 fields of a fragment. Word w of a draw comes by TMU w mod Tmus in beat (group) w /
// Tmus.
//
// An extra pass of docs/spec/effects.md takes its operands from what O holds as well; passes are
// sent in order, extra ones first.
//
// Multiplies: 3 a lane (Tmus * 4 + 14), 1 a field (26, and 6 a coefficient set of effects).
`include "ptm_assert.svh"
module ptm_filter #(
  parameter int CoefBits         = 8,
  parameter int RoundNearest     = 1,
  parameter int FilterFrac       = 0,
  parameter int Tmus             = 3,
  parameter int PaletteLrgbPorts = 4,
  parameter int PaletteRgbPorts  = 1,
  parameter int EvalLanes        = 1,  // passes that O sends a cycle; 1, 3
  parameter int HalfVector       = 0,  // as ptm_unit
  parameter int ExtraSets        = 0,
  parameter int ExtraPasses      = 0,
  localparam int FieldW = ptm_pkg::larger(8, CoefBits),  // in memory
  localparam int ValueW = FieldW + FilterFrac,           // on the way
  localparam int StoredW = ptm_pkg::stored_bits(CoefBits, FilterFrac),
  localparam int RgbW    = ptm_pkg::rgb_bits(FilterFrac)
) (
  input  logic        clk_i,
  input  logic        rst_ni,
  input  logic [ptm_unit_pkg::Draws*ptm_unit_pkg::DrawW-1:0] draws_i,
  input  logic [ptm_unit_pkg::Draws*ptm_unit_pkg::EffectW-1:0] effects_i,  // effect_t
  input  logic        pal_lrgb_we_i,
  input  logic [10:0] pal_lrgb_addr_i,
  input  logic        pal_rgb_we_i,
  input  logic [14:0] pal_rgb_addr_i,
  input  logic [31:0] pal_data_i,
  input  logic [3:0]  pal_upper_i,  // above it; CoefBits above 10 only
  // D
  input  logic                                valid_i,
  output logic                                ready_o,
  input  ptm_unit_pkg::beat_t                 beat_i,
  input  logic [Tmus*ptm_unit_pkg::TapsW-1:0] taps_i,
  output logic                                load_q_o,  // a whole beat leaves D
  output logic [2:0]                          palette_taps_o,  // looked up of what leaves D
  // Passes of the fragment in O
  output logic                                    valid_o,
  input  logic                                    ready_i,
  output logic                                    last_pass_o,
  output logic                                    extra_o,      // an extra pass; its luminance counts
  output logic [1:0]                              number_o,     // which one
  output logic [2:0]                              passes_o,     // extra ones of the fragment
  input  logic signed [ptm_unit_pkg::LightMax-1:0] hu_i,        // of the fragment
  input  logic signed [ptm_unit_pkg::LightMax-1:0] hv_i,
  output logic [EvalLanes*6*StoredW-1:0]          coef_o,       // lane 0 lowest
  output logic [6*CoefBits-1:0]                   bias_o,
  output logic [6*ptm_pkg::ShiftBits-1:0]         shift_o,
  output logic [3*RgbW-1:0]                       rgb_o,
  output logic signed [ptm_unit_pkg::LightMax-1:0] lu_o,
  output logic signed [ptm_unit_pkg::LightMax-1:0] lv_o,
  output logic                                    rgb_map_o,
  output logic [1:0]                              channel_o,
  output logic [ptm_unit_pkg::PixelBits-1:0]      x_o,
  output logic [ptm_unit_pkg::PixelBits-1:0]      y_o,
  output logic [ptm_unit_pkg::DrawBits-1:0]       draw_o,
  output logic [7:0]                              map_alpha_o,
  output logic [31:0]                             color_o     // R G B A, R lowest
);
  localparam int WordW  = 3 * FieldW;      // of a palette's entry
  localparam int Lanes  = 4 * Tmus + 14;
  localparam int Lanes0 = 18;              // of TMU 0
  localparam int AWord  = ptm_pkg::coefficients_a_word(CoefBits);
  localparam int LrgbColor = 6 / AWord;    // the word of LRGB that holds the colour
  localparam int GroupBits = ptm_unit_pkg::GroupBits;

  `include "filter/ptm_filter_words.svh"

  // D: palette look-ups, a few taps a cycle. A taps_t has its four words below `fetched`.
  logic [2:0]   d_format;
  logic [1:0]   d_palette;
  logic [3:0]   d_fetched;
  logic [127:0] d_words;
  logic         q_ready, d_last, d_leaves, load_q;
  /* verilator lint_off PINCONNECTEMPTY */
  ptm_registers_draw_select u_d_draw (
    .draws_i(draws_i), .draw_i(beat_i.draw), .format_o(d_format), .palette_o(d_palette),
    .color_o(d_color), .bilinear_o(), .bias_o(), .shift_o(), .combine_o(), .ka_o(), .kd_o()
  );
  /* verilator lint_on PINCONNECTEMPTY */
  assign {d_fetched, d_words} = taps_i[ptm_unit_pkg::TapsW-1:0];

  logic [PaletteLrgbPorts-1:0]    lrgb_read;
  logic [PaletteLrgbPorts*10-1:0] lrgb_index;
  logic [PaletteRgbPorts-1:0]     rgb_read;
  logic [PaletteRgbPorts*12-1:0]  rgb_index;
  logic                           shown_rgb, hold;
  logic [3:0]                     shown;
  logic [7:0]                     lrgb_port, rgb_port;
  ptm_filter_palette_control #(
    .LrgbPorts(PaletteLrgbPorts), .RgbPorts(PaletteRgbPorts)
  ) u_palette_control (
    .clk_i(clk_i), .rst_ni(rst_ni), .valid_i(valid_i), .accept_i(q_ready),
    .sub_last_i(beat_i.sub_last), .format_i(d_format), .palette_i(d_palette),
    .group_i(beat_i.group), .fetched_i(d_fetched), .words_i(d_words), .last_o(d_last),
    .taps_o(palette_taps_o), .lrgb_read_o(lrgb_read), .lrgb_index_o(lrgb_index),
    .rgb_read_o(rgb_read), .rgb_index_o(rgb_index), .shown_rgb_o(shown_rgb), .shown_o(shown),
    .lrgb_port_o(lrgb_port), .rgb_port_o(rgb_port), .hold_o(hold)
  );
  // Q's registers are what sub-beats leave D for, so none of them leaves while Q refuses.
  assign ready_o  = d_last && q_ready;
  assign d_leaves = valid_i && ready_o;
  assign load_q_o = load_q;

  // Registers: Q P L1 L2 L3 O
  logic p_ready, l1_ready, l2_ready, l3_ready, o_ready, o_done;
  logic q_valid, p_valid, l1_valid, l2_valid, l3_valid, o_valid;
  logic load_p, load_l1, load_l2, load_l3, load_o;
  logic [1:0] pass_q;  // of the map's own
  ptm_stream_reg u_q (
    .clk_i(clk_i), .rst_ni(rst_ni), .valid_i(valid_i && d_last && beat_i.sub_last),
    .ready_o(q_ready), .load_o(load_q), .valid_o(q_valid), .ready_i(p_ready)
  );
  ptm_stream_reg u_p (
    .clk_i(clk_i), .rst_ni(rst_ni), .valid_i(q_valid), .ready_o(p_ready), .load_o(load_p),
    .valid_o(p_valid), .ready_i(l1_ready)
  );
  ptm_stream_reg u_l1 (
    .clk_i(clk_i), .rst_ni(rst_ni), .valid_i(p_valid), .ready_o(l1_ready), .load_o(load_l1),
    .valid_o(l1_valid), .ready_i(l2_ready)
  );
  ptm_stream_reg u_l2 (
    .clk_i(clk_i), .rst_ni(rst_ni), .valid_i(l1_valid), .ready_o(l2_ready), .load_o(load_l2),
    .valid_o(l2_valid), .ready_i(l3_ready)
  );
  // A beat that is not its fragment's last leaves L3 at once.
  ptm_stream_reg u_l3 (
    .clk_i(clk_i), .rst_ni(rst_ni), .valid_i(l2_valid), .ready_o(l3_ready), .load_o(load_l3),
    .valid_o(l3_valid), .ready_i(!l3_step_q.last || o_ready)
  );
  ptm_stream_reg u_o (
    .clk_i(clk_i), .rst_ni(rst_ni), .valid_i(l3_valid && l3_step_q.last), .ready_o(o_ready),
    .load_o(load_o), .valid_o(o_valid), .ready_i(o_done)
  );

  // What travels beside the lanes
  typedef struct packed {
    logic [ptm_unit_pkg::PixelBits-1:0] x;
    logic [ptm_unit_pkg::PixelBits-1:0] y;
    logic [ptm_unit_pkg::LightMax-1:0]  lu;
    logic [ptm_unit_pkg::LightMax-1:0]  lv;
  } spot_t;
  typedef struct packed {
    logic [2:0]                        format;
    logic [GroupBits-1:0]              group;
    logic                              second;
    logic [7:0]                        map_f;
    logic [7:0]                        color_f;
    logic                              last;
    logic                              first_probe;
    logic [2:0]                        probes_log2;
    logic                              lit;
    logic [ptm_unit_pkg::DrawBits-1:0] draw;
  } step_t;
  spot_t d_spot, q_spot_q, p_spot_q, l1_spot_q, l2_spot_q, l3_spot_q, o_spot_q;
  step_t d_step, q_step_q, p_step_q, l1_step_q, l2_step_q, l3_step_q, o_step_q;
  logic [7:0] q_map_wu_q, q_color_wu_q, q_map_wv_q, q_color_wv_q;
  logic [7:0] p_map_wu_q, p_color_wu_q, p_map_wv_q, p_color_wv_q, l1_map_wv_q, l1_color_wv_q;
  assign d_spot = {beat_i.x, beat_i.y, beat_i.lu, beat_i.lv};
  assign d_step = {d_format, beat_i.group, beat_i.second, beat_i.ptm.f, beat_i.color.f,
                   beat_i.last, beat_i.first_probe, beat_i.probes_log2, beat_i.lit, beat_i.draw};
  always_ff @(posedge clk_i) begin
    if (load_q) begin
      q_spot_q     <= d_spot;
      q_step_q     <= d_step;
      q_map_wu_q   <= beat_i.ptm.wu;
      q_map_wv_q   <= beat_i.ptm.wv;
      q_color_wu_q <= beat_i.color.wu;
      q_color_wv_q <= beat_i.color.wv;
    end
    if (load_p) begin
      p_spot_q     <= q_spot_q;
      p_step_q     <= q_step_q;
      p_map_wu_q   <= q_map_wu_q;
      p_map_wv_q   <= q_map_wv_q;
      p_color_wu_q <= q_color_wu_q;
      p_color_wv_q <= q_color_wv_q;
    end
    if (load_l1) begin
      l1_spot_q     <= p_spot_q;
      l1_step_q     <= p_step_q;
      l1_map_wv_q   <= p_map_wv_q;
      l1_color_wv_q <= p_color_wv_q;
    end
    if (load_l2) begin
      l2_spot_q <= l1_spot_q;
      l2_step_q <= l1_step_q;
    end
    if (load_l3) begin
      l3_spot_q <= l2_spot_q;
      l3_step_q <= l2_step_q;
    end
    if (load_o) begin
      o_spot_q <= l3_spot_q;
      o_step_q <= l3_step_q;
    end
  end

  // Behind the map's planes lies a set's word if the draw has no colour texture.
  logic d_color, p_has_color, l1_has_color, l2_has_color;
  if (ExtraSets == 0) begin : gen_no_sets
    assign {p_has_color, l1_has_color, l2_has_color} = '1;
    logic unused_color;
    assign unused_color = ^{d_color, p_has_color, l1_has_color, l2_has_color};
  end else begin : gen_has_color
    logic q_q, p_q, l1_q, l2_q;
    always_ff @(posedge clk_i) begin
      if (load_q) q_q <= d_color;
      if (load_p) p_q <= q_q;
      if (load_l1) l1_q <= p_q;
      if (load_l2) l2_q <= l1_q;
    end
    assign {p_has_color, l1_has_color, l2_has_color} = {p_q, l1_q, l2_q};
  end

  // Q and P: the words of each TMU, and the palette entries of TMU 0's
  logic [31:0]      p_word [4*Tmus];
  logic [WordW-1:0] p_entry [4*6];
  for (genvar n = 0; n < 4 * Tmus; n++) begin : gen_word
    localparam int At = (n / 4) * ptm_unit_pkg::TapsW;
    ptm_filter_tap_word u_word (
      .clk_i(clk_i), .rst_ni(rst_ni), .load_q_i(d_leaves && taps_i[At+128+n%4]),
      .load_p_i(load_p), .data_i(taps_i[At+32*(n%4) +: 32]), .p_o(p_word[n])
    );
  end
  logic [WordW-1:0] pal_word;  // of an entry, as it is written
  assign pal_word = WordW'({pal_upper_i, pal_data_i});
  logic q_palette;  // TMU 0's word of the beat in Q is an index
  assign q_palette = (q_step_q.format == ptm_unit_pkg::FormatPaletteLrgb ||
                      q_step_q.format == ptm_unit_pkg::FormatPaletteRgb) && q_step_q.group == '0;
  for (genvar w = 0; w < 6; w++) begin : gen_palette
    logic [PaletteRgbPorts*WordW-1:0]  rgb_data;
    logic [PaletteLrgbPorts*WordW-1:0] lrgb_data;
    ptm_filter_palette_word #(.IndexBits(12), .Width(WordW), .Ports(PaletteRgbPorts)) u_rgb (
      .clk_i(clk_i), .we_i(pal_rgb_we_i && pal_rgb_addr_i[2:0] == 3'(w)),
      .write_index_i(pal_rgb_addr_i[14:3]), .write_data_i(pal_word),
      .read_i(rgb_read), .index_i(rgb_index), .data_o(rgb_data)
    );
    if (w < 2) begin : gen_lrgb
      ptm_filter_palette_word #(.IndexBits(10), .Width(WordW), .Ports(PaletteLrgbPorts)) u_lrgb (
        .clk_i(clk_i), .we_i(pal_lrgb_we_i && pal_lrgb_addr_i[0] == 1'(w)),
        .write_index_i(pal_lrgb_addr_i[10:1]), .write_data_i(pal_word),
        .read_i(lrgb_read), .index_i(lrgb_index), .data_o(lrgb_data)
      );
    end else begin : gen_rgb_only
      assign lrgb_data = '0;  // never chosen
    end
    for (genvar k = 0; k < 4; k++) begin : gen_tap
      logic [WordW-1:0] rgb_entry, lrgb_entry;
      ptm_filter_port_select #(.Ports(PaletteRgbPorts), .Width(WordW), .Tap(k)) u_rgb_port (
        .data_i(rgb_data), .port_i(rgb_port[2*k +: 2]), .data_o(rgb_entry)
      );
      ptm_filter_port_select #(.Ports(PaletteLrgbPorts), .Width(WordW), .Tap(k)) u_lrgb_port (
        .data_i(lrgb_data), .port_i(lrgb_port[2*k +: 2]), .data_o(lrgb_entry)
      );
      ptm_filter_tap_hold #(.Width(WordW)) u_hold (
        .clk_i(clk_i), .rst_ni(rst_ni), .shown_i(shown[k]), .hold_i(hold),
        .load_p_i(load_p && q_palette), .data_i(w >= 2 || shown_rgb ? rgb_entry : lrgb_entry),
        .p_o(p_entry[4*w+k])
      );
    end
  end

  // U7, P to L2
  logic                    p_lrgb, p_rgb;  // palettised
  logic [Lanes*ValueW-1:0] l2;
  assign p_lrgb = p_step_q.format == ptm_unit_pkg::FormatPaletteLrgb && p_step_q.group == '0;
  assign p_rgb  = p_step_q.format == ptm_unit_pkg::FormatPaletteRgb && p_step_q.group == '0;
  for (genvar t = 0; t < Tmus; t++) begin : gen_tmu
    logic       p_color, p_bytes, l1_color;
    logic [7:0] wu, wv;
    if (ExtraSets == 0) begin : gen_behind_map
      assign p_color  = brings_color(p_step_q.format, p_step_q.group, t);
      assign l1_color = brings_color(l1_step_q.format, l1_step_q.group, t);
    end else begin : gen_if_any
      assign p_color  = p_has_color && brings_color(p_step_q.format, p_step_q.group, t);
      assign l1_color = l1_has_color && brings_color(l1_step_q.format, l1_step_q.group, t);
    end
    assign p_bytes  = p_color || (p_step_q.format == ptm_unit_pkg::FormatLrgb &&
                                  brings(p_step_q.group, LrgbColor, t));
    assign wu       = p_color ? p_color_wu_q : p_map_wu_q;
    assign wv       = l1_color ? l1_color_wv_q : l1_map_wv_q;
    // Lanes of a palette's fields stand still for other words.
    logic l1_lrgb, l1_rgb;
    assign l1_lrgb = l1_step_q.format == ptm_unit_pkg::FormatPaletteLrgb &&
                     l1_step_q.group == '0;
    assign l1_rgb  = l1_step_q.format == ptm_unit_pkg::FormatPaletteRgb && l1_step_q.group == '0;
    for (genvar i = 0; i < (t == 0 ? Lanes0 : 4); i++) begin : gen_lane
      logic [ValueW-1:0] tap [4];
      for (genvar k = 0; k < 4; k++) begin : gen_tap
        ptm_filter_lane_tap #(
          .FieldW(FieldW), .FilterFrac(FilterFrac), .Field(i), .Indexed(t == 0 ? 1 : 0)
        ) u_tap (
          .word_i(p_word[4*t+k]), .entry_i(p_entry[4*(i/3)+k]), .bytes_i(p_bytes),
          .lrgb_i(p_lrgb), .rgb_i(p_rgb), .value_o(tap[k])
        );
      end
      ptm_filter_lane #(.Width(ValueW), .RoundNearest(RoundNearest)) u_lane (
        .clk_i(clk_i), .load_l1_i(load_l1 && (i < 4 || p_rgb || (p_lrgb && i < 9))),
        .load_l2_i(load_l2 && (i < 4 || l1_rgb || (l1_lrgb && i < 9))), .t00_i(tap[0]),
        .t10_i(tap[1]), .t01_i(tap[2]), .t11_i(tap[3]), .wu_i(wu), .wv_i(wv),
        .l2_o(l2[ValueW*lane(t, i) +: ValueW])
      );
    end
  end

  // U8 to U10, L2 to O
  logic            leave_l3, l3_color;
  logic [6*12-1:0] l3_bias;
  assign leave_l3 = l3_valid && (!l3_step_q.last || o_ready);
  /* verilator lint_off PINCONNECTEMPTY */
  ptm_registers_draw_select u_l3_draw (
    .draws_i(draws_i), .draw_i(l3_step_q.draw), .bias_o(l3_bias), .color_o(l3_color),
    .format_o(), .bilinear_o(), .palette_o(), .shift_o(), .combine_o(), .ka_o(),
    .kd_o()
  );
  /* verilator lint_on PINCONNECTEMPTY */
  logic [EvalLanes*6*StoredW-1:0] own_coef;
  ptm_filter_fields #(
    .CoefBits(CoefBits), .RoundNearest(RoundNearest), .FilterFrac(FilterFrac), .Tmus(Tmus),
    .EvalLanes(EvalLanes)
  ) u_fields (
    .clk_i(clk_i), .load_l3_i(load_l3), .l2_i(l2), .l2_format_i(l2_step_q.format),
    .l2_group_i(l2_step_q.group), .l2_second_i(l2_step_q.second), .l2_map_f_i(l2_step_q.map_f),
    .l2_color_f_i(l2_step_q.color_f), .leave_l3_i(leave_l3), .l3_format_i(l3_step_q.format),
    .l3_color_i(l3_color), .l3_first_probe_i(l3_step_q.first_probe),
    .l3_probes_log2_i(l3_step_q.probes_log2), .l3_lit_i(l3_step_q.lit), .l3_bias_i(l3_bias),
    .load_o_i(load_o), .pass_i(pass_q), .coef_o(own_coef), .rgb_o(rgb_o),
    .map_alpha_o(map_alpha_o), .color_o(color_o)
  );

  // O: one pass a cycle, or with three lanes all of the map's own
  logic            o_none, o_rgb;
  logic [6*12-1:0] o_bias, own_bias;
  logic [6*ptm_pkg::ShiftBits-1:0] o_shift, own_shift;
  assign o_none      = o_step_q.format == ptm_unit_pkg::FormatNone;
  assign o_rgb       = o_step_q.format == ptm_unit_pkg::FormatRgb ||
                       o_step_q.format == ptm_unit_pkg::FormatPaletteRgb;
  assign valid_o     = o_valid;
  assign o_done      = ready_i && last_pass_o;
  assign channel_o   = pass_q;
  /* verilator lint_off PINCONNECTEMPTY */
  ptm_registers_draw_select u_o_draw (
    .draws_i(draws_i), .draw_i(o_step_q.draw), .bias_o(own_bias), .shift_o(own_shift),
    .format_o(), .bilinear_o(), .color_o(), .palette_o(), .combine_o(), .ka_o(), .kd_o()
  );
  /* verilator lint_on PINCONNECTEMPTY */
  for (genvar i = 0; i < 6; i++) begin : gen_bias
    assign bias_o[CoefBits*i +: CoefBits] = o_none ? '0 : o_bias[12*i +: CoefBits];
  end
  assign shift_o = o_none ? '0 : o_shift;
  assign x_o     = o_spot_q.x;
  assign y_o     = o_spot_q.y;
  assign draw_o  = o_step_q.draw;

  if (ExtraPasses == 0) begin : gen_own_passes
    assign rgb_map_o   = o_rgb;
    assign last_pass_o = !rgb_map_o || EvalLanes == 3 || pass_q == 2'd2;
    assign coef_o      = own_coef;
    assign o_bias      = own_bias;
    assign o_shift     = own_shift;
    assign lu_o        = o_spot_q.lu;
    assign lv_o        = o_spot_q.lv;
    assign extra_o     = 1'b0;
    assign number_o    = 2'd0;
    assign passes_o    = 3'd0;
    always_ff @(posedge clk_i or negedge rst_ni) begin
      if (!rst_ni) pass_q <= 2'd0;
      else if (o_valid && ready_i) pass_q <= last_pass_o ? 2'd0 : pass_q + 2'd1;
    end
    logic unused_effects;
    assign unused_effects = ^{effects_i, hu_i, hv_i, l2_has_color};
  end else begin : gen_extra_passes
    logic [2:0]                      set;
    logic                            half;
    logic [6*12-1:0]                 set_bias;
    logic [6*ptm_pkg::ShiftBits-1:0] set_shift;
    ptm_filter_extra_passes #(
      .HalfVector(HalfVector), .ExtraSets(ExtraSets)
    ) u_extra_passes (
      .clk_i(clk_i), .rst_ni(rst_ni), .effects_i(effects_i), .draw_i(o_step_q.draw),
      .sent_i(o_valid && ready_i), .last_i(last_pass_o), .extra_o(extra_o), .number_o(number_o),
      .passes_o(passes_o), .set_o(set), .half_o(half), .bias_o(set_bias), .shift_o(set_shift)
    );
    assign rgb_map_o   = o_rgb && !extra_o;
    assign last_pass_o = !extra_o && (!o_rgb || EvalLanes == 3 || pass_q == 2'd2);
    always_ff @(posedge clk_i or negedge rst_ni) begin
      if (!rst_ni) pass_q <= 2'd0;
      else if (o_valid && ready_i && !extra_o) pass_q <= last_pass_o ? 2'd0 : pass_q + 2'd1;
    end
    assign lu_o = half ? hu_i : o_spot_q.lu;
    assign lv_o = half ? hv_i : o_spot_q.lv;

    // Set 0 is what the map's own first pass takes.
    if (ExtraSets == 0) begin : gen_map_only
      assign coef_o  = own_coef;
      assign o_bias  = own_bias;
      assign o_shift = own_shift;
      logic unused_sets;
      assign unused_sets = ^{set, set_bias, set_shift, l2_has_color};
    end else begin : gen_sets
      localparam int EffectW = ptm_unit_pkg::EffectW, BiasAt = ptm_unit_pkg::EffectBiasAt;
      localparam int BiasW = ExtraSets * 6 * 12;
      logic [ptm_unit_pkg::Draws*BiasW-1:0] biases;
      logic [BiasW-1:0]                     l3_set_bias;
      logic [6*StoredW-1:0]      set_coef;
      for (genvar d = 0; d < ptm_unit_pkg::Draws; d++) begin : gen_biases
        assign biases[d*BiasW +: BiasW] = effects_i[d*EffectW+BiasAt +: BiasW];
      end
      ptm_registers_by_draw #(.Width(BiasW)) u_l3_bias (
        .values_i(biases), .draw_i(l3_step_q.draw), .value_o(l3_set_bias)
      );
      ptm_filter_sets #(
        .CoefBits(CoefBits), .RoundNearest(RoundNearest), .FilterFrac(FilterFrac), .Tmus(Tmus),
        .ExtraSets(ExtraSets)
      ) u_sets (
        .clk_i(clk_i), .load_l3_i(load_l3), .l2_i(l2), .l2_format_i(l2_step_q.format),
        .l2_color_i(l2_has_color), .l2_group_i(l2_step_q.group),
        .l2_second_i(l2_step_q.second), .l2_map_f_i(l2_step_q.map_f), .leave_l3_i(leave_l3),
        .l3_first_probe_i(l3_step_q.first_probe), .l3_probes_log2_i(l3_step_q.probes_log2),
        .l3_lit_i(l3_step_q.lit), .l3_bias_i(l3_set_bias), .load_o_i(load_o), .set_i(set),
        .coef_o(set_coef)
      );
      assign coef_o[6*StoredW-1:0] = set == 3'd0 ? own_coef[6*StoredW-1:0] : set_coef;
      if (EvalLanes > 1) begin : gen_others
        assign coef_o[EvalLanes*6*StoredW-1:6*StoredW] =
            own_coef[EvalLanes*6*StoredW-1:6*StoredW];
      end
      assign o_bias  = set == 3'd0 ? own_bias : set_bias;
      assign o_shift = set == 3'd0 ? own_shift : set_shift;
    end
  end
endmodule
