// A0: holds a fragment and sends its beats, one a cycle: for probe, for footprint, for beat of
// ceil(words / Tmus); emptied with the last. U1 and U2 are between here and A1.
//
// A beat carries what later stages need of its draw, so that A0 alone looks at the descriptor's
// address half. Timing: docs/spec/unit-timing.md, Address.
`include "ptm_assert.svh"
module ptm_unit_beats #(
  parameter int Tmus = 3
) (
  input  logic                      clk_i,
  input  logic                      rst_ni,
  input  ptm_unit_pkg::draw_t [ptm_unit_pkg::Draws-1:0] draws_i,
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
  output logic [2:0]                planes_o,    // of the map: 0, 1, 3, 6
  output logic                      color_o,     // the draw has a colour texture
  // By texture (0 map, 1 colour), of the footprint's level
  output logic [1:0][3:0]           level_o,
  output logic [1:0][12:0]          width_o,
  output logic [1:0][12:0]          height_o,
  output logic [1:0][25:0]          base_o
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
  assign draw = draws_i[fragment_q.draw];

  // Words: the map's planes, then the colour texture
  always_comb begin
    unique case (draw.format)
      ptm_unit_pkg::FormatLrgb: planes_o = 3'd3;
      ptm_unit_pkg::FormatRgb: planes_o = 3'd6;
      ptm_unit_pkg::FormatPaletteLrgb, ptm_unit_pkg::FormatPaletteRgb: planes_o = 3'd1;
      default: planes_o = 3'd0;
    endcase
  end
  assign color_o = draw.color;
  logic [2:0] words, groups_less_1;
  assign words         = planes_o + 3'(draw.color);
  assign groups_less_1 = 3'((4'(words) - 4'd1) / 4'(Tmus));

  // U2
  logic signed [13:0] color_sum;
  logic [11:0]        color_lod;
  assign color_sum = signed'({2'b0, fragment_q.lod}) + 14'(draw.color_lod);
  assign color_lod = color_sum[13] ? 12'd0 : color_sum[12] ? 12'hfff : color_sum[11:0];
  logic [1:0]      has;
  logic [1:0][3:0] level;
  logic [1:0][7:0] weight, weight_any;
  assign has = {draw.color, draw.format != ptm_unit_pkg::FormatNone};
  ptm_unit_level u_level_map (
    .mip_i(draw.mip), .lod_i(fragment_q.lod), .levels_i(draw.ptm.levels), .level_o(level[0]),
    .weight_o(weight_any[0])
  );
  ptm_unit_level u_level_color (
    .mip_i(draw.mip), .lod_i(color_lod), .levels_i(draw.color_texture.levels),
    .level_o(level[1]), .weight_o(weight_any[1])
  );
  assign weight[0] = has[0] ? weight_any[0] : 8'd0;
  assign weight[1] = has[1] ? weight_any[1] : 8'd0;
  logic two_footprints;
  assign two_footprints = weight != '0;

  // Where the fragment stands
  logic [3:0] probe_q;
  logic       second_q;
  logic [2:0] group_q;
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
      group_q <= last_group ? '0 : group_q + 3'd1;
      if (last_group) second_q <= !last_footprint;
      if (last_group && last_footprint) probe_q <= last_probe ? '0 : probe_q + 4'd1;
    end
  end

  // U1
  ptm_unit_probe u_probe_u (
    .u_i(fragment_q.u), .axis_i(fragment_q.axis_u), .probe_i(probe_q),
    .probes_log2_i(fragment_q.probes_log2), .u_o(u_o)
  );
  ptm_unit_probe u_probe_v (
    .u_i(fragment_q.v), .axis_i(fragment_q.axis_v), .probe_i(probe_q),
    .probes_log2_i(fragment_q.probes_log2), .u_o(v_o)
  );

  // Level l has max(1, W >> l) columns
  logic [1:0][12:0] width, height;
  assign width  = {draw.color_texture.width, draw.ptm.width};
  assign height = {draw.color_texture.height, draw.ptm.height};
  for (genvar t = 0; t < 2; t++) begin : gen_texture
    logic [12:0] width_l, height_l;
    assign level_o[t]  = level[t] + 4'(second_q && weight[t] != 8'd0);
    assign width_l     = width[t] >> level_o[t];
    assign height_l    = height[t] >> level_o[t];
    assign width_o[t]  = width_l == 13'd0 ? 13'd1 : width_l;
    assign height_o[t] = height_l == 13'd0 ? 13'd1 : height_l;
  end
  assign base_o[0] = draw.ptm.base[level_o[0]];
  assign base_o[1] = draw.color_texture.base[level_o[1]];

  assign wrap_u_o   = draw.wrap_u;
  assign wrap_v_o   = draw.wrap_v;
  assign bilinear_o = draw.bilinear;

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
    beat_o.group         = group_q;
    beat_o.ptm.f         = weight[0];
    beat_o.ptm.fetched   = has[0] && (!second_q || weight[0] != 8'd0);
    beat_o.color.f       = weight[1];
    beat_o.color.fetched = has[1] && (!second_q || weight[1] != 8'd0);
    beat_o.last          = last;
  end

  `PTM_ASSERT(ADrawHasWords_A, !valid_o || words != 3'd0)
endmodule
