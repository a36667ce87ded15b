// The texture unit: from fragments to pixels. Wiring only.
//
//   fragments -> ptm_front (address, tags, miss ring, fetch) -> D
//             -> ptm_back (palette, filter, evaluator, combine) -> pixels
//   registers -> ptm_registers (descriptors, palettes, counters, status)
//
// What it computes is docs/spec/unit.md, when it moves what docs/spec/unit-timing.md, the handshake
// docs/spec/handshake.md. An all-hit fragment of one beat that is accepted in cycle c is offered as
// a pixel in c + 25. No combinational path leads from an input to an output, but for the register
// port's read.
//
// Twins: ptm::reference::shade() for values, the timing `exact` of model/pipeline for cycles.
module ptm_unit #(
  `include "contract/ptm_unit_parameters.svh"
) (
  input  logic         clk_i,
  // Both fall at any time and must rise between two rising edges of clk_i, as a synchroniser of the
  // system's gives them (docs/spec/handshake.md, Reset). rst_ni resets the unit; mem_rst_ni, low
  // only while rst_ni is, says that the memory forgets the requests it has not answered. Tie both
  // together where the memory is always reset with the unit; where it is not, rst_ni falls in step
  // with clk_i too.
  input  logic         rst_ni,
  input  logic         mem_rst_ni,
  // Registers: a write takes its cycle and never waits, reading is combinational
  // (docs/spec/unit.md, Registers)
  input  logic         reg_we_i,
  input  logic [15:0]  reg_addr_i,
  input  logic [31:0]  reg_wdata_i,
  output logic [31:0]  reg_rdata_o,
  output logic         irq_o,  // high while an enabled event bit is set
  // Fragments; refused while a draw is illegal or being checked
  input  logic                                      frag_valid_i,
  output logic                                      frag_ready_o,
  input  logic [ptm_unit_pkg::PixelBits-1:0]        frag_x_i,
  input  logic [ptm_unit_pkg::PixelBits-1:0]        frag_y_i,
  input  logic signed [ptm_unit_pkg::CoordBits-1:0] frag_u_i,
  input  logic signed [ptm_unit_pkg::CoordBits-1:0] frag_v_i,
  input  logic [ptm_unit_pkg::LodBits-1:0]          frag_lod_i,
  input  logic signed [ptm_unit_pkg::CoordBits-1:0] frag_axis_u_i,
  input  logic signed [ptm_unit_pkg::CoordBits-1:0] frag_axis_v_i,
  input  logic [2:0]                                frag_probes_log2_i,  // 0..4
  input  logic signed [ptm_unit_pkg::LightMax-1:0]  frag_lu_i,
  input  logic signed [ptm_unit_pkg::LightMax-1:0]  frag_lv_i,
  input  logic signed [ptm_unit_pkg::LightMax-1:0]  frag_hu_i,           // HalfVector only
  input  logic signed [ptm_unit_pkg::LightMax-1:0]  frag_hv_i,
  input  logic                                      frag_lit_i,
  input  logic [ptm_unit_pkg::DrawBits-1:0]         frag_draw_i,         // one that was written
  // Memory: responses in any order, never refused, in the cycle in which their request is taken at
  // the earliest
  output logic         mem_req_valid_o,
  input  logic         mem_req_ready_i,
  output logic [25:0]  mem_req_line_o,
  output logic [7:0]   mem_req_tag_o,
  input  logic         mem_rsp_valid_i,
  input  logic [7:0]   mem_rsp_tag_i,
  input  logic [511:0] mem_rsp_line_i,
  input  logic         mem_rsp_error_i,  // the line could not be read: whatever the line then is
  // Pixels, in the order of their fragments
  output logic                               pix_valid_o,
  input  logic                               pix_ready_i,
  output logic [ptm_unit_pkg::PixelBits-1:0] pix_x_o,
  output logic [ptm_unit_pkg::PixelBits-1:0] pix_y_o,
  output logic [23:0]                        pix_rgb_o,  // red lowest
  output logic [7:0]                         pix_alpha_o,
  output logic                               pix_lum_saturated_o,
  output logic                               pix_color_saturated_o,
  output logic                               pix_mem_error_o  // of a line that could not be read
);
  ptm_unit_parameters #(
    `include "contract/ptm_unit_map.svh"
  ) u_parameters ();

  // Registers
  logic [ptm_unit_pkg::Draws*ptm_unit_pkg::DrawW-1:0] draws;
  logic [5:0]  counter_number;
  logic [63:0] counter;
  logic        error, checking, busy, last_taken, invalidate, clear, mem_error, draining;
  logic        pal_lrgb_we, pal_rgb_we;
  logic [10:0] pal_lrgb_addr;
  logic [14:0] pal_rgb_addr;
  logic [31:0] pal_data;
  logic [3:0]  pal_upper;
  logic [ptm_unit_pkg::Draws*ptm_unit_pkg::EffectW-1:0] effects;
  logic        table_we;
  logic [9:0]  table_addr;
  logic [11:0] table_data;
  logic [32*ptm_unit_pkg::CapabilityWords-1:0] capabilities;
  ptm_registers_capabilities #(
    `include "contract/ptm_unit_map.svh"
  ) u_capabilities (
    .words_o(capabilities)
  );
  logic        mem_failed;
  logic [25:0] mem_base;
  ptm_registers #(
    .CoefBits(CoefBits), .HalfVector(HalfVector), .ExtraSets(ExtraSets),
    .ExtraPasses(ExtraPasses), .Stages(Stages)
  ) u_registers (
    .clk_i(clk_i), .rst_ni(rst_ni), .reg_we_i(reg_we_i), .reg_addr_i(reg_addr_i),
    .reg_wdata_i(reg_wdata_i), .reg_rdata_o(reg_rdata_o), .draws_o(draws), .effects_o(effects),
    .table_we_o(table_we), .table_addr_o(table_addr), .table_data_o(table_data), .error_o(error),
    .checking_o(checking), .irq_o(irq_o), .busy_i(busy),
    .accepted_i(frag_valid_i && frag_ready_o), .last_taken_i(last_taken),
    .invalidate_o(invalidate), .clear_o(clear), .mem_error_i(mem_error),
    .mem_error_tag_i(mem_rsp_tag_i), .mem_failed_i(mem_failed), .mem_base_o(mem_base),
    .draining_i(draining),
    .counter_number_o(counter_number), .counter_i(counter), .capabilities_i(capabilities),
    .pal_lrgb_we_o(pal_lrgb_we), .pal_lrgb_addr_o(pal_lrgb_addr), .pal_rgb_we_o(pal_rgb_we),
    .pal_rgb_addr_o(pal_rgb_addr), .pal_data_o(pal_data),
    .pal_upper_o(pal_upper)
  );

  // Fragments
  ptm_unit_pkg::fragment_t fragment;
  always_comb begin
    fragment             = '0;
    fragment.x           = frag_x_i;
    fragment.y           = frag_y_i;
    fragment.u           = frag_u_i;
    fragment.v           = frag_v_i;
    fragment.lod         = frag_lod_i;
    fragment.axis_u      = frag_axis_u_i;
    fragment.axis_v      = frag_axis_v_i;
    fragment.probes_log2 = frag_probes_log2_i;
    fragment.lu          = frag_lu_i;
    fragment.lv          = frag_lv_i;
    fragment.lit         = frag_lit_i;
    fragment.draw        = frag_draw_i;
  end
  logic open, front_ready;
  assign open         = !error && !checking;
  assign frag_ready_o = open && front_ready;

  // Half-vectors go from here to O beside all else.
  logic signed [ptm_unit_pkg::LightMax-1:0] o_hu, o_hv;
  logic                                     o_leaves;
  if (HalfVector == 0) begin : gen_no_half
    assign {o_hu, o_hv} = '0;
    logic unused_half;
    assign unused_half = ^{frag_hu_i, frag_hv_i, o_leaves};
  end else begin : gen_half
    localparam int LightW = ptm_pkg::light_bits(LightInt, LightFrac);
    logic signed [LightW-1:0] hu, hv;
    ptm_back_half_vector_fifo #(
      .Depth(FragmentFifo + 14), .Width(LightW)  // A0 to A3, T, K, F, D, Q, P, L1, L2, L3, O
    ) u_half_fifo (
      .clk_i(clk_i), .rst_ni(rst_ni), .push_i(frag_valid_i && frag_ready_o),
      .hu_i(frag_hu_i[LightW-1:0]), .hv_i(frag_hv_i[LightW-1:0]), .pop_i(o_leaves), .hu_o(hu),
      .hv_o(hv)
    );
    assign o_hu = ptm_unit_pkg::LightMax'(hu);
    assign o_hv = ptm_unit_pkg::LightMax'(hv);
    logic unused_half;
    assign unused_half = ^{frag_hu_i, frag_hv_i};
  end

  // The front looks at the number of sets alone.
  logic [ptm_unit_pkg::Draws*3-1:0] sets;
  for (genvar d = 0; d < ptm_unit_pkg::Draws; d++) begin : gen_sets
    assign sets[3*d +: 3] = effects[d*ptm_unit_pkg::EffectW + ptm_unit_pkg::EffectSetsAt +: 3];
  end

  // D
  logic                                d_valid, d_ready, d_error;
  ptm_unit_pkg::beat_t                 d_beat;
  logic [Tmus*ptm_unit_pkg::TapsW-1:0] d_taps;
  logic [2:0] inc_palette, inc_combine;
  logic [7:0] inc_filter;
  logic [5:0] inc_eval, inc_effects;
  ptm_front #(
    `include "contract/ptm_unit_front_map.svh"
  ) u_front (
    .clk_i(clk_i), .rst_ni(rst_ni), .mem_rst_ni(mem_rst_ni), .draining_o(draining),
    .draws_i(draws), .sets_i(sets),
    .invalidate_i(invalidate), .clear_i(clear),
    .busy_o(busy), .last_taken_o(last_taken), .counter_number_i(counter_number),
    .counter_o(counter),
    .valid_i(frag_valid_i && open), .ready_o(front_ready),
    .fragment_i(fragment), .mem_base_i(mem_base), .mem_req_valid_o(mem_req_valid_o),
    .mem_req_ready_i(mem_req_ready_i), .mem_req_line_o(mem_req_line_o),
    .mem_req_tag_o(mem_req_tag_o),
    .mem_rsp_valid_i(mem_rsp_valid_i), .mem_rsp_tag_i(mem_rsp_tag_i),
    .mem_rsp_line_i(mem_rsp_line_i), .mem_rsp_error_i(mem_rsp_error_i), .mem_error_o(mem_error),
    .mem_failed_o(mem_failed), .d_valid_o(d_valid), .d_ready_i(d_ready), .d_beat_o(d_beat),
    .d_taps_o(d_taps), .d_error_o(d_error),
    .pixel_taken_i(pix_valid_o && pix_ready_i), .inc_palette_i(inc_palette),
    .inc_filter_i(inc_filter), .inc_eval_i(inc_eval), .inc_combine_i(inc_combine),
    .inc_effects_i(inc_effects)
  );

  ptm_back #(
    `include "contract/ptm_unit_back_map.svh"
  ) u_back (
    .clk_i(clk_i), .rst_ni(rst_ni), .draws_i(draws), .effects_i(effects),
    .table_we_i(table_we), .table_addr_i(table_addr), .table_data_i(table_data), .hu_i(o_hu),
    .hv_i(o_hv), .o_leaves_o(o_leaves), .pal_lrgb_we_i(pal_lrgb_we),
    .pal_lrgb_addr_i(pal_lrgb_addr), .pal_rgb_we_i(pal_rgb_we), .pal_rgb_addr_i(pal_rgb_addr),
    .pal_data_i(pal_data), .pal_upper_i(pal_upper), .d_valid_i(d_valid), .d_ready_o(d_ready),
    .d_beat_i(d_beat), .d_taps_i(d_taps), .pix_valid_o(pix_valid_o), .pix_ready_i(pix_ready_i),
    .pix_x_o(pix_x_o), .pix_y_o(pix_y_o), .pix_rgb_o(pix_rgb_o), .pix_alpha_o(pix_alpha_o),
    .pix_lum_saturated_o(pix_lum_saturated_o), .pix_color_saturated_o(pix_color_saturated_o),
    .inc_palette_o(inc_palette), .inc_filter_o(inc_filter), .inc_eval_o(inc_eval),
    .inc_combine_o(inc_combine), .inc_effects_o(inc_effects)
  );

  ptm_registers_failures u_failures (
    .clk_i(clk_i), .rst_ni(rst_ni), .leaves_i(d_valid && d_ready), .failed_i(d_error),
    .last_i(d_beat.last && d_beat.sub_last), .taken_i(pix_valid_o && pix_ready_i),
    .failed_o(pix_mem_error_o)
  );
endmodule
