// A0 to A3: from a fragment to the look-ups of its beats. Wiring and the registers A1, A2, A3.
//
//   fragment |A0| beats, U1 U2 |A1| U3, U4's product |A2| U4 U5 U6 |A3| split -> T
//
// Timing: docs/spec/unit-timing.md, Address; values: docs/spec/unit.md, U1 to U6. All multiplies of
// a beat's address are here: two in U1, four in U4 and four in U6 (two textures).
module ptm_front_address #(
  parameter int CoefBits  = 8,
  parameter int Tmus      = 3,
  parameter int ExtraSets = 0,  // 0..4
  localparam int PlanesBits = ptm_format_pkg::PlanesBits,
  localparam int PlaneBits = ptm_front_pkg::PlaneBits
) (
  input  logic                      clk_i,
  input  logic                      rst_ni,
  input  logic [ptm_unit_pkg::Draws*ptm_unit_pkg::DrawW-1:0] draws_i,
  input  logic [ptm_unit_pkg::Draws*3-1:0] sets_i,
  input  logic                      valid_i,
  output logic                      ready_o,
  input  ptm_unit_pkg::fragment_t   fragment_i,
  // Sub-beat
  output logic                      valid_o,
  input  logic                      ready_i,
  output ptm_unit_pkg::beat_t       beat_o,
  output ptm_front_pkg::texels_t       map_texels_o,
  output ptm_front_pkg::row_lines_t    map_row_lines_o,
  output ptm_front_pkg::column_lines_t map_column_lines_o,
  output ptm_front_pkg::texels_t       color_texels_o,
  output ptm_front_pkg::row_lines_t    color_row_lines_o,
  output ptm_front_pkg::column_lines_t color_column_lines_o,
  output logic [3:0]                taps_o,     // of the sub-beat
  // By TMU: what its word is
  output logic [Tmus-1:0]           fetched_o,  // it has one, and its texture has taps
  output logic [Tmus-1:0]           color_o,    // of the colour texture
  output logic [Tmus*PlaneBits-1:0] plane_o,
  // Counters' increments
  output logic                      inc_conflicts_o,
  output logic [1:0]                inc_words_o,
  output logic [3:0]                inc_taps_o,
  output logic [3:0]                inc_multiplies_o
);
  // A0
  logic                a0_valid, a0_ready;
  ptm_unit_pkg::beat_t a0_beat;
  logic signed [33:0]  a0_u, a0_v;
  logic [1:0]          a0_wrap_u, a0_wrap_v;
  logic                a0_bilinear, a0_color;
  logic [PlanesBits-1:0] a0_planes;
  logic [2:0]          a0_sets;
  ptm_front_pkg::level_t a0_map, a0_colors;
  ptm_front_beats #(
    .CoefBits(CoefBits), .Tmus(Tmus), .ExtraSets(ExtraSets)
  ) u_beats (
    .clk_i(clk_i), .rst_ni(rst_ni), .draws_i(draws_i), .sets_i(sets_i), .valid_i(valid_i),
    .ready_o(ready_o), .fragment_i(fragment_i), .valid_o(a0_valid), .ready_i(a0_ready),
    .beat_o(a0_beat),
    .u_o(a0_u), .v_o(a0_v), .wrap_u_o(a0_wrap_u), .wrap_v_o(a0_wrap_v), .bilinear_o(a0_bilinear),
    .planes_o(a0_planes), .sets_o(a0_sets), .color_o(a0_color), .map_o(a0_map),
    .colors_o(a0_colors)
  );

  // A1
  logic                a1_valid, a1_ready, a1_load;
  ptm_unit_pkg::beat_t a1_beat_q;
  logic signed [33:0]  a1_u_q, a1_v_q;
  logic [1:0]          a1_wrap_u_q, a1_wrap_v_q;
  logic                a1_bilinear_q, a1_color_q;
  logic [PlanesBits-1:0] a1_planes_q;
  ptm_front_pkg::level_t a1_map_q, a1_colors_q;
  ptm_stream_reg u_a1 (
    .clk_i(clk_i), .rst_ni(rst_ni), .valid_i(a0_valid), .ready_o(a0_ready), .load_o(a1_load),
    .valid_o(a1_valid), .ready_i(a1_ready)
  );
  always_ff @(posedge clk_i) begin
    if (a1_load) begin
      a1_beat_q     <= a0_beat;
      a1_u_q        <= a0_u;
      a1_v_q        <= a0_v;
      a1_wrap_u_q   <= a0_wrap_u;
      a1_wrap_v_q   <= a0_wrap_v;
      a1_bilinear_q <= a0_bilinear;
      a1_planes_q   <= a0_planes;
      a1_color_q    <= a0_color;
      a1_map_q      <= a0_map;
      if (a0_color) a1_colors_q <= a0_colors;
    end
  end

  logic a2_load, a3_load;
  // Sets travel beside the map's planes, where they are built.
  logic [2:0] a2_sets, a3_sets;
  if (ExtraSets == 0) begin : gen_no_sets
    assign a2_sets = a0_sets;  // 0
    assign a3_sets = a0_sets;
  end else begin : gen_sets
    logic [2:0] a1_sets_q, a2_sets_q, a3_sets_q;
    always_ff @(posedge clk_i) begin
      if (a1_load) a1_sets_q <= a0_sets;
      if (a2_load) a2_sets_q <= a1_sets_q;
      if (a3_load) a3_sets_q <= a2_sets_q;
    end
    assign a2_sets = a2_sets_q;
    assign a3_sets = a3_sets_q;
  end

  // U3, U4's product | A2
  logic [19:0] fu, fv;
  ptm_front_wrap u_wrap_u (.wrap_i(a1_wrap_u_q), .u_i(a1_u_q), .u_o(fu));
  ptm_front_wrap u_wrap_v (.wrap_i(a1_wrap_v_q), .u_i(a1_v_q), .u_o(fv));

  logic                a2_valid, a2_ready;
  ptm_unit_pkg::beat_t a2_beat_q;
  logic                a2_repeat_u_q, a2_repeat_v_q, a2_bilinear_q, a2_color_q;
  logic [PlanesBits-1:0] a2_planes_q;
  ptm_front_pkg::level_t a2_map_q, a2_colors_q;
  logic [31:0]         a2_map_u_q, a2_map_v_q, a2_color_u_q, a2_color_v_q;  // products
  ptm_stream_reg u_a2 (
    .clk_i(clk_i), .rst_ni(rst_ni), .valid_i(a1_valid), .ready_o(a1_ready), .load_o(a2_load),
    .valid_o(a2_valid), .ready_i(a2_ready)
  );
  always_ff @(posedge clk_i) begin
    if (a2_load) begin
      a2_beat_q      <= a1_beat_q;
      a2_repeat_u_q  <= a1_wrap_u_q == ptm_unit_pkg::WrapRepeat;
      a2_repeat_v_q  <= a1_wrap_v_q == ptm_unit_pkg::WrapRepeat;
      a2_bilinear_q  <= a1_bilinear_q;
      a2_planes_q    <= a1_planes_q;
      a2_color_q     <= a1_color_q;
      a2_map_q       <= a1_map_q;
      a2_map_u_q     <= 32'(fu) * 32'(a1_map_q.width);
      a2_map_v_q     <= 32'(fv) * 32'(a1_map_q.height);
      if (a1_color_q) begin
        a2_colors_q  <= a1_colors_q;
        a2_color_u_q <= 32'(fu) * 32'(a1_colors_q.width);
        a2_color_v_q <= 32'(fv) * 32'(a1_colors_q.height);
      end
    end
  end

  // U4, U5, U6 | A3
  logic [7:0]                  map_wu, map_wv, color_wu, color_wv;
  ptm_front_pkg::texels_t       map_texels, color_texels;
  ptm_front_pkg::row_lines_t    map_row_lines, color_row_lines;
  ptm_front_pkg::column_lines_t map_column_lines, color_column_lines;
  ptm_front_tiles #(
    .CoefBits(CoefBits), .ExtraSets(ExtraSets)
  ) u_tiles_map (
    .enable_i(1'b1), .bilinear_i(a2_bilinear_q), .repeat_u_i(a2_repeat_u_q),
    .repeat_v_i(a2_repeat_v_q),
    .product_u_i(a2_map_u_q), .product_v_i(a2_map_v_q), .level_i(a2_map_q),
    .planes_i(a2_planes_q), .sets_i(a2_sets), .wu_o(map_wu), .wv_o(map_wv), .texels_o(map_texels),
    .row_lines_o(map_row_lines), .column_lines_o(map_column_lines)
  );
  ptm_front_tiles u_tiles_color (
    .enable_i(a2_color_q), .bilinear_i(a2_bilinear_q), .repeat_u_i(a2_repeat_u_q),
    .repeat_v_i(a2_repeat_v_q),
    .product_u_i(a2_color_u_q), .product_v_i(a2_color_v_q), .level_i(a2_colors_q),
    .planes_i(PlanesBits'(1)), .sets_i(3'd0), .wu_o(color_wu), .wv_o(color_wv),
    .texels_o(color_texels), .row_lines_o(color_row_lines), .column_lines_o(color_column_lines)
  );
  ptm_unit_pkg::beat_t weighted;
  always_comb begin
    weighted          = a2_beat_q;
    weighted.ptm.wu   = map_wu;
    weighted.ptm.wv   = map_wv;
    weighted.color.wu = color_wu;
    weighted.color.wv = color_wv;
  end

  logic                        a3_ready;
  ptm_unit_pkg::beat_t         a3_beat_q;
  logic                        a3_color_q;
  logic [PlanesBits-1:0]       a3_planes_q;
  ptm_front_pkg::texels_t       a3_map_texels_q, a3_color_texels_q;
  ptm_front_pkg::row_lines_t    a3_map_row_lines_q, a3_color_row_lines_q;
  ptm_front_pkg::column_lines_t a3_map_column_lines_q, a3_color_column_lines_q;
  ptm_stream_reg u_a3 (
    .clk_i(clk_i), .rst_ni(rst_ni), .valid_i(a2_valid), .ready_o(a2_ready), .load_o(a3_load),
    .valid_o(valid_o), .ready_i(a3_ready)
  );
  always_ff @(posedge clk_i) begin
    if (a3_load) begin
      a3_beat_q               <= weighted;
      a3_planes_q             <= a2_planes_q;
      a3_color_q              <= a2_color_q;
      a3_map_texels_q         <= map_texels;
      a3_map_row_lines_q      <= map_row_lines;
      a3_map_column_lines_q   <= map_column_lines;
      if (a2_color_q) begin
        a3_color_texels_q       <= color_texels;
        a3_color_row_lines_q    <= color_row_lines;
        a3_color_column_lines_q <= color_column_lines;
      end
    end
  end
  assign map_texels_o         = a3_map_texels_q;
  assign map_row_lines_o      = a3_map_row_lines_q;
  assign map_column_lines_o   = a3_map_column_lines_q;
  assign color_texels_o       = a3_color_texels_q;
  assign color_row_lines_o    = a3_color_row_lines_q;
  assign color_column_lines_o = a3_color_column_lines_q;

  ptm_front_split #(
    .CoefBits(CoefBits), .Tmus(Tmus), .ExtraSets(ExtraSets)
  ) u_split (
    .clk_i(clk_i), .rst_ni(rst_ni), .valid_i(valid_o), .ready_o(a3_ready), .beat_i(a3_beat_q),
    .planes_i(a3_planes_q), .sets_i(a3_sets), .color_i(a3_color_q), .map_i(a3_map_texels_q),
    .color_texels_i(a3_color_texels_q), .ready_i(ready_i), .beat_o(beat_o), .taps_o(taps_o),
    .fetched_o(fetched_o), .color_o(color_o), .plane_o(plane_o),
    .inc_conflicts_o(inc_conflicts_o), .inc_words_o(inc_words_o), .inc_taps_o(inc_taps_o),
    .inc_multiplies_o(inc_multiplies_o)
  );
endmodule
