// The texture unit up to the words of the taps: A0 to D, the miss ring and the counters. Wiring.
//
//   fragments -> A0 | A1 | A2 | A3 | T [fragment FIFO] K | F | D -> ptm_back
//                                    |                 ^
//                                    [miss ring] -> memory
//
// Timing of every register: docs/spec/unit-timing.md. ready_o, the requests and everything towards
// memory depend on registers alone; D's ready reaches back to the fragment FIFO's exit.
module ptm_front #(
  `include "contract/ptm_unit_front_parameters.svh"
  ,
  localparam int LineBits    = ptm_unit_pkg::LineBits,
  localparam int LineWidth   = ptm_front_pkg::LineWidth
) (
  input  logic                      clk_i,
  input  logic                      rst_ni,
  input  logic                      mem_rst_ni,
  input  logic [ptm_unit_pkg::Draws*ptm_unit_pkg::DrawW-1:0] draws_i,
  input  logic [ptm_unit_pkg::Draws*3-1:0] sets_i,  // coefficient sets beyond the map's, by draw
  input  logic                      invalidate_i,  // only while nothing is inside
  input  logic                      clear_i,
  output logic                      busy_o,
  output logic                      last_taken_o,  // the last pixel of what is inside is taken
  input  logic [5:0]                counter_number_i,
  output logic [63:0]               counter_o,
  // Fragments
  input  logic                      valid_i,
  output logic                      ready_o,
  input  ptm_unit_pkg::fragment_t   fragment_i,
  // Memory
  input  logic [LineBits-1:0]       mem_base_i,  // is added to the line of every request
  output logic                      mem_req_valid_o,
  input  logic                      mem_req_ready_i,
  output logic [LineBits-1:0]       mem_req_line_o,
  output logic [7:0]                mem_req_tag_o,
  input  logic                      mem_rsp_valid_i,
  input  logic [7:0]                mem_rsp_tag_i,
  input  logic [LineWidth-1:0]      mem_rsp_line_i,
  input  logic                      mem_rsp_error_i,  // the line could not be read
  output logic                      mem_error_o,   // with the response that nobody waits for
  output logic                      mem_failed_o,  // with the response of a line that failed
  output logic                      draining_o,    // answers from before the reset are awaited
  // D
  output logic                      d_valid_o,
  input  logic                      d_ready_i,
  output ptm_unit_pkg::beat_t       d_beat_o,
  output logic [Tmus*ptm_unit_pkg::TapsW-1:0] d_taps_o,  // taps_t, TMU 0 lowest
  output logic                      d_error_o,  // one of the taps is of a line that failed
  // From behind D: a pixel is taken, counters' increments
  input  logic                      pixel_taken_i,
  input  logic [2:0]                inc_palette_i,
  input  logic [7:0]                inc_filter_i,
  input  logic [5:0]                inc_eval_i,
  input  logic [2:0]                inc_combine_i,
  input  logic [5:0]                inc_effects_i
);
  localparam int Sets = CacheKib * 4 / Ways;  // of a tag bank
  localparam int Rows = CacheKib * 16;        // of a data bank
  localparam int PlaneBits = ptm_front_pkg::PlaneBits;
  localparam int TakenW = ptm_front_pkg::TakenW;
  localparam int ReadsW = ptm_front_pkg::ReadsW;

  // A0 to A3
  logic                a_valid, a_ready;
  ptm_unit_pkg::beat_t a_beat;
  ptm_front_pkg::texels_t       a_map_texels, a_color_texels;
  ptm_front_pkg::row_lines_t    a_map_row_lines, a_color_row_lines;
  ptm_front_pkg::column_lines_t a_map_column_lines, a_color_column_lines;
  logic [3:0]          a_taps;
  logic [Tmus-1:0]     a_fetched, a_color;
  logic [Tmus*PlaneBits-1:0] a_plane;
  logic                inc_conflicts;
  logic [1:0]          inc_words;
  logic [3:0]          inc_taps, inc_address;
  ptm_front_address #(
    .CoefBits(CoefBits), .Tmus(Tmus), .ExtraSets(ExtraSets)
  ) u_address (
    .clk_i(clk_i), .rst_ni(rst_ni), .draws_i(draws_i), .sets_i(sets_i), .valid_i(valid_i),
    .ready_o(ready_o), .fragment_i(fragment_i), .valid_o(a_valid), .ready_i(a_ready),
    .beat_o(a_beat),
    .map_texels_o(a_map_texels), .map_row_lines_o(a_map_row_lines),
    .map_column_lines_o(a_map_column_lines), .color_texels_o(a_color_texels),
    .color_row_lines_o(a_color_row_lines), .color_column_lines_o(a_color_column_lines),
    .taps_o(a_taps), .fetched_o(a_fetched), .color_o(a_color), .plane_o(a_plane),
    .inc_conflicts_o(inc_conflicts), .inc_words_o(inc_words),
    .inc_taps_o(inc_taps), .inc_multiplies_o(inc_address)
  );

  // T
  logic [Tmus-1:0]               miss_valid;
  logic [Tmus*LineBits-1:0]      miss_line;
  logic                          miss_push, miss_fits;
  logic                t_valid, t_ready;
  ptm_unit_pkg::beat_t t_beat;
  logic [2*TakenW-1:0]    t_taken;
  logic [Tmus*ReadsW-1:0] t_reads;
  logic                t_waits, looked;
  logic [Tmus*4-1:0]   hits, misses, duplicates;
  logic [Tmus-1:0]      looked_color;
  logic [ptm_unit_pkg::DrawBits-1:0] looked_draw;
  ptm_front_tags #(
    .Tmus(Tmus), .Sets(Sets), .Ways(Ways), .DuplicateLines(DuplicateLines)
  ) u_tags (
    .clk_i(clk_i), .rst_ni(rst_ni), .invalidate_i(invalidate_i), .valid_i(a_valid),
    .ready_o(a_ready), .beat_i(a_beat),
    .map_texels_i(a_map_texels), .map_row_lines_i(a_map_row_lines),
    .map_column_lines_i(a_map_column_lines), .color_texels_i(a_color_texels),
    .color_row_lines_i(a_color_row_lines), .color_column_lines_i(a_color_column_lines),
    .taps_i(a_taps), .fetched_i(a_fetched), .color_i(a_color), .plane_i(a_plane),
    .miss_valid_o(miss_valid),
    .miss_line_o(miss_line), .miss_push_o(miss_push), .miss_fits_i(miss_fits), .valid_o(t_valid),
    .ready_i(t_ready), .beat_o(t_beat), .taken_o(t_taken), .reads_o(t_reads),
    .waits_for_slots_o(t_waits), .looked_o(looked), .hits_o(hits), .misses_o(misses),
    .duplicates_o(duplicates), .color_o(looked_color), .draw_o(looked_draw)
  );

  // Fragment FIFO
  logic                q_valid, q_ready;
  ptm_unit_pkg::beat_t q_beat;
  logic [2*TakenW-1:0]    q_taken;
  logic [Tmus*ReadsW-1:0] q_reads;
  ptm_front_beat_fifo #(
    .Tmus(Tmus), .Depth(FragmentFifo)
  ) u_fragment_fifo (
    .clk_i(clk_i), .rst_ni(rst_ni), .valid_i(t_valid), .ready_o(t_ready), .beat_i(t_beat),
    .taken_i(t_taken), .reads_i(t_reads), .valid_o(q_valid), .ready_i(q_ready), .beat_o(q_beat),
    .taken_o(q_taken), .reads_o(q_reads)
  );

  // K
  logic [Tmus-1:0]     rank;
  logic                usable, commit, give_back;
  logic [Tmus*ptm_front_pkg::RowBits-1:0] rank_row;
  logic [Tmus*LineWidth-1:0]                   rank_line;
  logic [Tmus-1:0]     rank_failed;
  logic                k_valid, k_holds, f_ready;
  ptm_unit_pkg::beat_t k_beat;
  logic [2*TakenW-1:0]    k_taken;
  logic [Tmus*ReadsW-1:0] k_reads;
  ptm_front_commit #(
    .Tmus(Tmus), .Rows(Rows)
  ) u_commit (
    .clk_i(clk_i), .rst_ni(rst_ni), .valid_i(q_valid), .ready_o(q_ready), .beat_i(q_beat),
    .taken_i(q_taken), .reads_i(q_reads), .rank_o(rank), .usable_i(usable), .commit_o(commit),
    .release_o(give_back), .row_o(rank_row), .valid_o(k_valid), .ready_i(f_ready),
    .beat_o(k_beat), .taken_o(k_taken), .reads_o(k_reads), .holds_o(k_holds)
  );

  logic [LineBits-1:0] req_line;
  assign mem_req_line_o = req_line + mem_base_i;
  ptm_front_miss_ring #(
    .Tmus(Tmus), .MissFifo(MissFifo)
  ) u_miss_ring (
    .clk_i(clk_i), .rst_ni(rst_ni), .mem_rst_ni(mem_rst_ni), .draining_o(draining_o),
    .miss_valid_i(miss_valid), .miss_line_i(miss_line), .miss_push_i(miss_push),
    .miss_fits_o(miss_fits), .req_valid_o(mem_req_valid_o),
    .req_ready_i(mem_req_ready_i), .req_line_o(req_line), .req_tag_o(mem_req_tag_o),
    .rsp_valid_i(mem_rsp_valid_i), .rsp_tag_i(mem_rsp_tag_i), .rsp_line_i(mem_rsp_line_i),
    .rsp_failed_i(mem_rsp_error_i), .rsp_error_o(mem_error_o), .line_failed_o(mem_failed_o),
    .rank_i(rank), .usable_o(usable), .commit_i(commit), .release_i(give_back),
    .line_o(rank_line), .failed_o(rank_failed)
  );

  // F, D
  ptm_front_fetch #(
    .Tmus(Tmus), .Rows(Rows)
  ) u_fetch (
    .clk_i(clk_i), .rst_ni(rst_ni), .commit_i(commit), .rank_i(rank), .row_i(rank_row),
    .line_i(rank_line), .failed_i(rank_failed), .valid_i(k_valid), .ready_o(f_ready),
    .beat_i(k_beat),
    .taken_i(k_taken), .reads_i(k_reads), .valid_o(d_valid_o), .ready_i(d_ready_i),
    .beat_o(d_beat_o), .taps_o(d_taps_o), .failed_o(d_error_o)
  );

  ptm_front_inside u_inside (
    .clk_i(clk_i), .rst_ni(rst_ni), .accepted_i(valid_i && ready_o), .taken_i(pixel_taken_i),
    .busy_o(busy_o), .last_taken_o(last_taken_o)
  );

  if (Counters == 0) begin : gen_no_counters
    assign counter_o = '0;
    logic unused_counts;
    assign unused_counts = ^{clear_i, counter_number_i, inc_palette_i, inc_filter_i, inc_eval_i,
                             inc_combine_i, inc_effects_i, inc_conflicts, inc_words, inc_taps,
                             inc_address, k_holds, t_waits, looked, hits, misses, duplicates,
                             looked_color, looked_draw};
  end else begin : gen_counters
    ptm_registers_counters #(
      .Tmus(Tmus), .Stages(Stages)
    ) u_counters (
      .clk_i(clk_i), .rst_ni(rst_ni), .clear_i(clear_i), .accepted_i(valid_i && ready_o),
      .taken_i(pixel_taken_i), .inside_i(busy_o), .k_leaves_i(k_valid && f_ready),
      .k_holds_i(k_holds), .f_accepts_i(f_ready), .t_waits_for_slots_i(t_waits),
      .inc_conflicts_i(inc_conflicts), .inc_words_i(inc_words), .inc_taps_i(inc_taps),
      .inc_lines_i(mem_req_valid_o && mem_req_ready_i), .inc_palette_i(inc_palette_i),
      .inc_multiplies_address_i(inc_address), .inc_multiplies_filter_i(inc_filter_i),
      .inc_multiplies_eval_i(inc_eval_i), .inc_multiplies_combine_i(inc_combine_i),
      .inc_multiplies_effects_i(inc_effects_i),
      .looked_i(looked), .hits_i(hits), .misses_i(misses),
      .duplicates_i(DuplicateLines == 0 ? '0 : duplicates), .color_i(looked_color),
      .draw_i(looked_draw), .number_i(counter_number_i), .value_o(counter_o)
    );
  end
endmodule
