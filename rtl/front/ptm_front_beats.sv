// A0: holds a fragment and sends its beats, one a cycle: for probe, for footprint, for beat of
// ceil(words / Tmus); emptied with the last. U1 and U2 are between here and A1.
//
// A beat carries what later stages need of its draw, so that A0 alone looks at the descriptor's
// address half. Timing: docs/spec/unit-timing.md, Address.
`include "ptm_assert.svh"
module ptm_front_beats #(
  parameter int CoefBits  = 8,
  parameter int Tmus      = 3,
  parameter int ExtraSets = 0,  // 0..4
  localparam int AWord = ptm_pkg::coefficients_a_word(CoefBits),
  localparam int DrawW = ptm_unit_pkg::DrawW
) (
  input  logic                      clk_i,
  input  logic                      rst_ni,
  input  logic [ptm_unit_pkg::Draws*DrawW-1:0] draws_i,
  input  logic [ptm_unit_pkg::Draws*3-1:0]     sets_i,
  input  logic                      valid_i,
  output logic                      ready_o,
  input  ptm_unit_pkg::fragment_t   fragment_i,
  // Beat, without wu and wv
  output logic                      valid_o,
  input  logic                      ready_i,
  output ptm_unit_pkg::beat_t       beat_o,
  output logic signed [33:0]        u_o,         // of the probe, 20 fraction bits
  output logic signed [33:0]        v_o,
  output logic [1:0]                wrap_u_o,
  output logic [1:0]                wrap_v_o,
  output logic                      bilinear_o,
  output logic [ptm_format_pkg::PlanesBits-1:0] planes_o,  // of the map's own words
  output logic [2:0]                sets_o,      // coefficient sets beyond it
  output logic                      color_o,     // the draw has a colour texture
  output ptm_front_pkg::level_t map_o,      // of the footprint
  output ptm_front_pkg::level_t colors_o
);
  logic                    load;
  logic                    last;
  ptm_unit_pkg::fragment_t fragment_q;
  ptm_stream_reg u_a0 (
    .clk_i(clk_i), .rst_ni(rst_ni), .valid_i(valid_i), .ready_o(ready_o), .load_o(load),
    .valid_o(valid_o), .ready_i(ready_i && last)
  );
  always_ff @(posedge clk_i) if (load) fragment_q <= fragment_i;

  ptm_unit_pkg::draw_t draw;
  always_comb begin
    unique case (fragment_q.draw)
      2'd0:    draw = draws_i[0*DrawW +: DrawW];
      2'd1:    draw = draws_i[1*DrawW +: DrawW];
      2'd2:    draw = draws_i[2*DrawW +: DrawW];
      default: draw = draws_i[3*DrawW +: DrawW];
    endcase
  end

  // Words: the map's planes, the colour texture, the sets' planes
  assign planes_o = ptm_format_pkg::planes(AWord, draw.format);
  localparam int WordsMax = ptm_format_pkg::words_max(AWord) + 1 + 6 / AWord * ExtraSets;
  localparam int GroupW   = $clog2(WordsMax + 1);
  logic [GroupW-1:0] words, groups_less_1;
  if (ExtraSets == 0) begin : gen_own
    assign sets_o = 3'd0;
    assign words  = GroupW'(planes_o) + GroupW'(draw.color);
    logic unused_sets;
    assign unused_sets = ^sets_i;
  end else begin : gen_sets
    ptm_registers_by_draw #(.Width(3)) u_sets (
      .values_i(sets_i), .draw_i(fragment_q.draw), .value_o(sets_o)
    );
    logic [GroupW-1:0] sets;
    assign sets   = GroupW'(sets_o);
    assign words  = GroupW'(planes_o) + GroupW'(draw.color) + (sets << 1) +
                    (AWord == 3 ? '0 : sets);
  end
  always_comb begin  // (words - 1) / Tmus
    groups_less_1 = '0;
    for (int n = 1; n < WordsMax; n++) begin
      if (32'(words) > 32'(n * Tmus)) groups_less_1 = GroupW'(n);
    end
  end

  // U2
  logic signed [13:0] color_sum;
  logic [11:0]        color_lod;
  assign color_sum = signed'({2'b0, fragment_q.lod}) + 14'(draw.color_lod);
  assign color_lod = color_sum[13] ? 12'd0 : color_sum[12] ? 12'hfff : color_sum[11:0];
  logic       second_q;
  logic [7:0] weight_map, weight_color;
  logic       fetched_map, fetched_color;
  ptm_front_footprint u_map (
    .texture_i(draw.ptm), .has_i(draw.format != ptm_unit_pkg::FormatNone), .mip_i(draw.mip),
    .lod_i(fragment_q.lod), .second_i(second_q), .weight_o(weight_map), .fetched_o(fetched_map),
    .level_o(map_o)
  );
  ptm_front_footprint u_color (
    .texture_i(draw.color_texture), .has_i(draw.color), .mip_i(draw.mip), .lod_i(color_lod),
    .second_i(second_q), .weight_o(weight_color), .fetched_o(fetched_color),
    .level_o(colors_o)
  );
  logic two_footprints;
  assign two_footprints = weight_map != 8'd0 || weight_color != 8'd0;

  // Where the fragment stands
  logic [3:0] probe_q;
  logic [GroupW-1:0] group_q;
  logic       last_group, last_footprint, last_probe;
  assign last_group     = group_q == groups_less_1;
  assign last_footprint = second_q == two_footprints;
  assign last_probe     = probe_q == 4'((5'd1 << fragment_q.probes_log2) - 5'd1);
  assign last           = last_group && last_footprint && last_probe;
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      probe_q  <= '0;
      second_q <= 1'b0;
      group_q  <= '0;
    end else if (valid_o && ready_i) begin
      group_q <= last_group ? '0 : group_q + GroupW'(1);
      if (last_group) second_q <= !last_footprint;
      if (last_group && last_footprint) probe_q <= last_probe ? '0 : probe_q + 4'd1;
    end
  end

  // U1
  ptm_front_probe u_probe_u (
    .u_i(fragment_q.u), .axis_i(fragment_q.axis_u), .probe_i(probe_q),
    .probes_log2_i(fragment_q.probes_log2), .u_o(u_o)
  );
  ptm_front_probe u_probe_v (
    .u_i(fragment_q.v), .axis_i(fragment_q.axis_v), .probe_i(probe_q),
    .probes_log2_i(fragment_q.probes_log2), .u_o(v_o)
  );

  assign wrap_u_o   = draw.wrap_u;
  assign wrap_v_o   = draw.wrap_v;
  assign bilinear_o = draw.bilinear;
  assign color_o    = draw.color;

  always_comb begin
    beat_o               = '0;
    beat_o.x             = fragment_q.x;
    beat_o.y             = fragment_q.y;
    beat_o.lu            = fragment_q.lu;
    beat_o.lv            = fragment_q.lv;
    beat_o.lit           = fragment_q.lit;
    beat_o.draw          = fragment_q.draw;
    beat_o.probes_log2   = fragment_q.probes_log2;
    beat_o.first_probe   = probe_q == 4'd0;
    beat_o.second        = second_q;
    beat_o.group         = ptm_unit_pkg::GroupBits'(group_q);
    beat_o.ptm.f         = weight_map;
    beat_o.ptm.fetched   = fetched_map;
    beat_o.color.f       = weight_color;
    beat_o.color.fetched = fetched_color;
    beat_o.last          = last;
  end

  `PTM_ASSERT(ADrawHasWords_A, !valid_o || words != '0)
endmodule
