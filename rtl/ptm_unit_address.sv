// A0 to A3: from a fragment to the look-ups of its beats. Wiring and the registers A1, A2, A3.
//
//   fragment |A0| beats, U1 U2 |A1| U3, U4's product |A2| U4 U5 U6 |A3| split -> T
//
// Timing: docs/spec/unit-timing.md, Address; values: docs/spec/unit.md, U1 to U6. All multiplies of
// a beat's address are here: two in U1, four in U4 and four in U6 (two textures).
module ptm_unit_address #(
  parameter int Tmus = 3,
  parameter int Sets = 32  // of a tag bank
) (
  input  logic                      clk_i,
  input  logic                      rst_ni,
  input  ptm_unit_pkg::draw_t [ptm_unit_pkg::Draws-1:0] draws_i,
  input  logic                      valid_i,
  output logic                      ready_o,
  input  ptm_unit_pkg::fragment_t   fragment_i,
  // Sub-beat
  output logic                      valid_o,
  input  logic                      ready_i,
  output ptm_unit_pkg::beat_t       beat_o,
  output ptm_unit_front_pkg::lookup_t [Tmus-1:0] lookup_o,
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
  logic [2:0]          a0_planes;
  logic [1:0][3:0]     a0_level;
  logic [1:0][12:0]    a0_width, a0_height;
  logic [1:0][25:0]    a0_base;
  ptm_unit_beats #(
    .Tmus(Tmus)
  ) u_beats (
    .clk_i(clk_i), .rst_ni(rst_ni), .draws_i(draws_i), .valid_i(valid_i), .ready_o(ready_o),
    .fragment_i(fragment_i), .valid_o(a0_valid), .ready_i(a0_ready), .beat_o(a0_beat),
    .u_o(a0_u), .v_o(a0_v), .wrap_u_o(a0_wrap_u), .wrap_v_o(a0_wrap_v), .bilinear_o(a0_bilinear),
    .planes_o(a0_planes), .color_o(a0_color), .level_o(a0_level), .width_o(a0_width),
    .height_o(a0_height), .base_o(a0_base)
  );

  // A1
  logic                a1_valid, a1_ready, a1_load;
  ptm_unit_pkg::beat_t a1_beat_q;
  logic signed [33:0]  a1_u_q, a1_v_q;
  logic [1:0]          a1_wrap_u_q, a1_wrap_v_q;
  logic                a1_bilinear_q, a1_color_q;
  logic [2:0]          a1_planes_q;
  logic [1:0][3:0]     a1_level_q;
  logic [1:0][12:0]    a1_width_q, a1_height_q;
  logic [1:0][25:0]    a1_base_q;
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
      a1_level_q    <= a0_level;
      a1_width_q    <= a0_width;
      a1_height_q   <= a0_height;
      a1_base_q     <= a0_base;
    end
  end

  // U3, U4's product | A2
  logic [19:0]      fu, fv;
  logic [1:0][31:0] product_u, product_v;
  ptm_unit_wrap u_wrap_u (.wrap_i(a1_wrap_u_q), .u_i(a1_u_q), .u_o(fu));
  ptm_unit_wrap u_wrap_v (.wrap_i(a1_wrap_v_q), .u_i(a1_v_q), .u_o(fv));
  for (genvar t = 0; t < 2; t++) begin : gen_product
    assign product_u[t] = 32'(fu) * 32'(a1_width_q[t]);
    assign product_v[t] = 32'(fv) * 32'(a1_height_q[t]);
  end

  logic                a2_valid, a2_ready, a2_load;
  ptm_unit_pkg::beat_t a2_beat_q;
  logic                a2_repeat_u_q, a2_repeat_v_q, a2_bilinear_q, a2_color_q;
  logic [2:0]          a2_planes_q;
  logic [1:0][3:0]     a2_level_q;
  logic [1:0][12:0]    a2_width_q, a2_height_q;
  logic [1:0][25:0]    a2_base_q;
  logic [1:0][31:0]    a2_product_u_q, a2_product_v_q;
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
      a2_level_q     <= a1_level_q;
      a2_width_q     <= a1_width_q;
      a2_height_q    <= a1_height_q;
      a2_base_q      <= a1_base_q;
      a2_product_u_q <= product_u;
      a2_product_v_q <= product_v;
    end
  end

  // U4, U5, U6 | A3
  logic [1:0][7:0]             wu, wv;
  ptm_unit_front_pkg::texels_t texels [2];
  for (genvar t = 0; t < 2; t++) begin : gen_texels
    logic [11:0] i0, i1, j0, j1;
    ptm_unit_scale u_scale_u (
      .bilinear_i(a2_bilinear_q), .repeat_i(a2_repeat_u_q), .product_i(a2_product_u_q[t]),
      .side_i(a2_width_q[t]), .i0_o(i0), .i1_o(i1), .weight_o(wu[t])
    );
    ptm_unit_scale u_scale_v (
      .bilinear_i(a2_bilinear_q), .repeat_i(a2_repeat_v_q), .product_i(a2_product_v_q[t]),
      .side_i(a2_height_q[t]), .i0_o(j0), .i1_o(j1), .weight_o(wv[t])
    );
    ptm_unit_tiles u_tiles (
      .width_i(a2_width_q[t]), .base_i(a2_base_q[t]), .planes_i(t == 0 ? a2_planes_q : 3'd1),
      .level_i(a2_level_q[t]), .columns_i(wu[t] != 8'd0), .rows_i(wv[t] != 8'd0),
      .i_i({i1, i0}), .j_i({j1, j0}), .texels_o(texels[t])
    );
  end
  ptm_unit_pkg::beat_t weighted;
  always_comb begin
    weighted          = a2_beat_q;
    weighted.ptm.wu   = wu[0];
    weighted.ptm.wv   = wv[0];
    weighted.color.wu = wu[1];
    weighted.color.wv = wv[1];
  end

  logic                        a3_ready, a3_load;
  ptm_unit_pkg::beat_t         a3_beat_q;
  logic                        a3_color_q;
  logic [2:0]                  a3_planes_q;
  ptm_unit_front_pkg::texels_t a3_map_q, a3_color_texels_q;
  ptm_stream_reg u_a3 (
    .clk_i(clk_i), .rst_ni(rst_ni), .valid_i(a2_valid), .ready_o(a2_ready), .load_o(a3_load),
    .valid_o(valid_o), .ready_i(a3_ready)
  );
  always_ff @(posedge clk_i) begin
    if (a3_load) begin
      a3_beat_q         <= weighted;
      a3_planes_q       <= a2_planes_q;
      a3_color_q        <= a2_color_q;
      a3_map_q          <= texels[0];
      a3_color_texels_q <= texels[1];
    end
  end

  ptm_unit_split #(
    .Tmus(Tmus), .Sets(Sets)
  ) u_split (
    .clk_i(clk_i), .rst_ni(rst_ni), .valid_i(valid_o), .ready_o(a3_ready), .beat_i(a3_beat_q),
    .planes_i(a3_planes_q), .color_i(a3_color_q), .map_i(a3_map_q),
    .color_texels_i(a3_color_texels_q), .ready_i(ready_i), .beat_o(beat_o), .lookup_o(lookup_o),
    .inc_conflicts_o(inc_conflicts_o), .inc_words_o(inc_words_o), .inc_taps_o(inc_taps_o),
    .inc_multiplies_o(inc_multiplies_o)
  );
endmodule
