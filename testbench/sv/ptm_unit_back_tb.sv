// The unit's registers and its back, with what the front does in between left to the caller: D's
// contents are pins. Pins have the same C++ types for every variant. No design logic.
//
// draw_i chooses the draw whose descriptor the draw_* pins show while view_i is high.
module ptm_unit_back_tb #(
  `include "contract/ptm_unit_back_parameters.svh"
) (
  input  logic        clk_i,
  input  logic        rst_ni,
  // Registers
  input  logic        reg_we_i,
  input  logic [15:0] reg_addr_i,
  input  logic [31:0] reg_wdata_i,
  output logic [31:0] reg_rdata_o,
  output logic        error_o,
  output logic        checking_o,
  output logic        irq_o,
  input  logic        busy_i,
  input  logic        accepted_i,
  input  logic        last_taken_i,
  output logic        invalidate_o,
  output logic        clear_o,
  input  logic        mem_error_i,
  input  logic [7:0]  mem_error_tag_i,
  input  logic        mem_failed_i,
  input  logic [31:0] capabilities_i [ptm_unit_pkg::CapabilityWords],
  input  logic [63:0] counters_i [ptm_unit_pkg::Counters],
  input  logic        view_i,
  input  logic [1:0]  draw_i,
  output logic [2:0]  draw_format_o,
  output logic        draw_bilinear_o,
  output logic [1:0]  draw_mip_o,
  output logic [1:0]  draw_wrap_u_o,
  output logic [1:0]  draw_wrap_v_o,
  output logic [2:0]  draw_combine_o,
  output logic        draw_color_o,
  output logic [31:0] draw_color_lod_o,
  output logic [15:0] draw_width_o [2],  // the map's, the colour texture's
  output logic [15:0] draw_height_o [2],
  output logic [3:0]  draw_levels_o [2],
  output logic [31:0] draw_base_o [2*ptm_unit_pkg::LevelsMax],
  output logic [15:0] draw_bias_o [6],
  output logic [31:0] draw_shift_o [6],
  output logic [1:0]  draw_palette_o,
  output logic [15:0] draw_ka_o,
  output logic [15:0] draw_kd_o,
  output logic [15:0] draw_ks_o,
  // D
  input  logic        d_valid_i,
  output logic        d_ready_o,
  input  logic [15:0] x_i,
  input  logic [15:0] y_i,
  input  logic [31:0] lu_i,
  input  logic [31:0] lv_i,
  input  logic        lit_i,
  input  logic [1:0]  beat_draw_i,
  input  logic [2:0]  probes_log2_i,
  input  logic        first_probe_i,
  input  logic        second_i,
  input  logic [ptm_unit_pkg::GroupBits-1:0] group_i,
  input  logic [7:0]  wu_i [2],
  input  logic [7:0]  wv_i [2],
  input  logic [7:0]  f_i [2],
  input  logic        fetched_i [2],
  input  logic        last_i,
  input  logic        sub_last_i,
  input  logic [3:0]  taps_i [3],
  input  logic [31:0] word_i [12],
  // Pixels
  output logic        pix_valid_o,
  input  logic        pix_ready_i,
  output logic [15:0] pix_x_o,
  output logic [15:0] pix_y_o,
  output logic [31:0] pix_rgb_o,
  output logic [7:0]  pix_alpha_o,
  output logic        pix_lum_saturated_o,
  output logic        pix_color_saturated_o,
  output logic [7:0]  inc_palette_o,
  output logic [7:0]  inc_filter_o,
  output logic [7:0]  inc_eval_o,
  output logic [7:0]  inc_combine_o
);
  localparam int DrawW = ptm_unit_pkg::DrawW;

  logic [ptm_unit_pkg::Draws*DrawW-1:0]    draws;
  logic [5:0]                              counter_number;
  logic [63:0]                             counter;
  logic                                    pal_lrgb_we, pal_rgb_we;
  logic [10:0]                             pal_lrgb_addr;
  logic [14:0]                             pal_rgb_addr;
  logic [31:0]                             pal_data;
  logic [3:0]                              pal_upper;
  assign counter = counter_number < 6'(ptm_unit_pkg::Counters) ? counters_i[counter_number] : '0;
  logic [32*ptm_unit_pkg::CapabilityWords-1:0] capabilities;
  for (genvar n = 0; n < ptm_unit_pkg::CapabilityWords; n++) begin : gen_capabilities
    assign capabilities[32*n +: 32] = capabilities_i[n];
  end
  // A back without effects
  logic [ptm_unit_pkg::Draws*ptm_unit_pkg::EffectW-1:0] effects;
  logic        table_we, leaves;
  logic [9:0]  table_addr;
  logic [11:0] table_data;
  logic [5:0]  inc_effects;
  logic [25:0] mem_base;
  ptm_registers #(
    .CoefBits(CoefBits)
  ) u_registers (
    .effects_o(effects), .table_we_o(table_we), .table_addr_o(table_addr),
    .table_data_o(table_data),
    .clk_i(clk_i), .rst_ni(rst_ni), .reg_we_i(reg_we_i), .reg_addr_i(reg_addr_i),
    .reg_wdata_i(reg_wdata_i), .reg_rdata_o(reg_rdata_o), .draws_o(draws), .error_o(error_o),
    .checking_o(checking_o), .irq_o(irq_o), .busy_i(busy_i), .accepted_i(accepted_i),
    .last_taken_i(last_taken_i), .invalidate_o(invalidate_o), .clear_o(clear_o),
    .mem_error_i(mem_error_i), .mem_error_tag_i(mem_error_tag_i), .mem_failed_i(mem_failed_i),
    .draining_i(1'b0), .mem_base_o(mem_base), .counter_number_o(counter_number),
    .counter_i(counter),
    .capabilities_i(capabilities), .pal_lrgb_we_o(pal_lrgb_we),
    .pal_lrgb_addr_o(pal_lrgb_addr), .pal_rgb_we_o(pal_rgb_we), .pal_rgb_addr_o(pal_rgb_addr),
    .pal_data_o(pal_data), .pal_upper_o(pal_upper)
  );

  ptm_unit_pkg::draw_t draw;
  always_comb begin
    draw = '0;
    {draw_format_o, draw_bilinear_o, draw_mip_o, draw_wrap_u_o, draw_wrap_v_o} = '0;
    {draw_combine_o, draw_color_o, draw_color_lod_o, draw_palette_o}           = '0;
    {draw_ka_o, draw_kd_o, draw_ks_o}                                          = '0;
    draw_width_o  = '{default: '0};
    draw_height_o = '{default: '0};
    draw_levels_o = '{default: '0};
    draw_base_o   = '{default: '0};
    draw_bias_o   = '{default: '0};
    draw_shift_o  = '{default: '0};
    if (view_i) begin
      draw = draws[draw_i*DrawW +: DrawW];
      draw_format_o    = draw.format;
      draw_bilinear_o  = draw.bilinear;
      draw_mip_o       = draw.mip;
      draw_wrap_u_o    = draw.wrap_u;
      draw_wrap_v_o    = draw.wrap_v;
      draw_combine_o   = draw.combine;
      draw_color_o     = draw.color;
      draw_color_lod_o = 32'(draw.color_lod);
      draw_width_o     = '{16'(draw.ptm.width), 16'(draw.color_texture.width)};
      draw_height_o    = '{16'(draw.ptm.height), 16'(draw.color_texture.height)};
      draw_levels_o    = '{draw.ptm.levels, draw.color_texture.levels};
      for (int l = 0; l < ptm_unit_pkg::LevelsMax; l++) begin
        draw_base_o[l]                           = 32'(draw.ptm.base[l]);
        draw_base_o[ptm_unit_pkg::LevelsMax + l] = 32'(draw.color_texture.base[l]);
      end
      for (int i = 0; i < 6; i++) begin
        draw_bias_o[i]  = 16'(draw.bias[i]);
        draw_shift_o[i] = 32'(signed'(draw.shift[i]));
      end
      draw_palette_o = draw.palette;
      draw_ka_o      = 16'(draw.ka);
      draw_kd_o      = 16'(draw.kd);
      draw_ks_o      = 16'(draw.ks);
    end
  end

  ptm_unit_pkg::beat_t beat;
  always_comb begin
    beat.x             = x_i[ptm_unit_pkg::PixelBits-1:0];
    beat.y             = y_i[ptm_unit_pkg::PixelBits-1:0];
    beat.lu            = lu_i[ptm_unit_pkg::LightMax-1:0];
    beat.lv            = lv_i[ptm_unit_pkg::LightMax-1:0];
    beat.lit           = lit_i;
    beat.draw          = beat_draw_i;
    beat.probes_log2   = probes_log2_i;
    beat.first_probe   = first_probe_i;
    beat.second        = second_i;
    beat.group         = group_i;
    beat.ptm.wu        = wu_i[0];
    beat.ptm.wv        = wv_i[0];
    beat.ptm.f         = f_i[0];
    beat.ptm.fetched   = fetched_i[0];
    beat.color.wu      = wu_i[1];
    beat.color.wv      = wv_i[1];
    beat.color.f       = f_i[1];
    beat.color.fetched = fetched_i[1];
    beat.last          = last_i;
    beat.sub_last      = sub_last_i;
  end
  logic [Tmus*ptm_unit_pkg::TapsW-1:0] taps;
  for (genvar t = 0; t < Tmus; t++) begin : gen_tmu
    assign taps[t*ptm_unit_pkg::TapsW +: ptm_unit_pkg::TapsW] =
        {taps_i[t], word_i[4*t+3], word_i[4*t+2], word_i[4*t+1], word_i[4*t]};
  end

  logic [23:0] pix_rgb;
  logic [2:0]  inc_palette, inc_combine;
  logic [5:0]  inc_eval;
  assign pix_rgb_o                = 32'(pix_rgb);
  assign {pix_x_o[15:14], pix_y_o[15:14]} = '0;
  assign inc_palette_o            = 8'(inc_palette);
  assign inc_combine_o            = 8'(inc_combine);
  assign inc_eval_o               = 8'(inc_eval);
  ptm_back #(
    `include "contract/ptm_unit_back_map.svh"
  ) u_dut (
    .effects_i(effects), .table_we_i(table_we), .table_addr_i(table_addr),
    .table_data_i(table_data), .hu_i('0), .hv_i('0), .o_leaves_o(leaves),
    .inc_effects_o(inc_effects),
    .clk_i(clk_i), .rst_ni(rst_ni), .draws_i(draws), .pal_lrgb_we_i(pal_lrgb_we),
    .pal_lrgb_addr_i(pal_lrgb_addr), .pal_rgb_we_i(pal_rgb_we), .pal_rgb_addr_i(pal_rgb_addr),
    .pal_data_i(pal_data), .pal_upper_i(pal_upper), .d_valid_i(d_valid_i), .d_ready_o(d_ready_o),
    .d_beat_i(beat), .d_taps_i(taps), .pix_valid_o(pix_valid_o), .pix_ready_i(pix_ready_i),
    .pix_x_o(pix_x_o[13:0]), .pix_y_o(pix_y_o[13:0]), .pix_rgb_o(pix_rgb),
    .pix_alpha_o(pix_alpha_o), .pix_lum_saturated_o(pix_lum_saturated_o),
    .pix_color_saturated_o(pix_color_saturated_o), .inc_palette_o(inc_palette),
    .inc_filter_o(inc_filter_o), .inc_eval_o(inc_eval), .inc_combine_o(inc_combine)
  );
endmodule
