// T: looks a beat's tiles up in the caches' tags, pushes its misses rank by rank to the miss ring,
// and sends the beat to the fragment FIFO with its last rank.
//
// Look-up happens in the beat's first cycle here, on the state that the beat before left. Rank r
// is the r-th miss of each TMU, in the order of TMUs; a rank is pushed whole or not at all. A beat
// without misses needs only the FIFO. docs/spec/unit-timing.md, Tags.
`include "ptm_assert.svh"
module ptm_unit_tags #(
  parameter int Tmus = 3,
  parameter int Sets = 32,  // of a bank
  parameter int Ways = 2,
  localparam int LineBits = ptm_unit_pkg::LineBits,
  localparam int ReadsW   = ptm_unit_front_pkg::ReadsW
) (
  input  logic                clk_i,
  input  logic                rst_ni,
  input  logic                invalidate_i,
  // Sub-beat
  input  logic                    valid_i,
  output logic                    ready_o,
  input  ptm_unit_pkg::beat_t     beat_i,
  input  ptm_unit_front_pkg::texels_t       map_texels_i,
  input  ptm_unit_front_pkg::row_lines_t    map_row_lines_i,
  input  ptm_unit_front_pkg::column_lines_t map_column_lines_i,
  input  ptm_unit_front_pkg::texels_t       color_texels_i,
  input  ptm_unit_front_pkg::row_lines_t    color_row_lines_i,
  input  ptm_unit_front_pkg::column_lines_t color_column_lines_i,
  input  logic [3:0]              taps_i,
  input  logic [Tmus-1:0]         fetched_i,
  input  logic [Tmus-1:0]         color_i,
  input  logic [3*Tmus-1:0]       plane_i,
  // A rank to the miss ring: lines of the TMUs in miss_valid_o, all or none
  output logic [Tmus-1:0]          miss_valid_o,
  output logic [Tmus*LineBits-1:0] miss_line_o,
  output logic                     miss_push_o,
  input  logic                     miss_fits_i,  // as many slots are free
  // To the fragment FIFO
  output logic                   valid_o,
  input  logic                   ready_i,
  output ptm_unit_pkg::beat_t    beat_o,
  output logic [Tmus*ReadsW-1:0] reads_o,
  // Counters
  output logic              waits_for_slots_o,
  output logic              looked_o,      // the rest counts in this cycle
  output logic [Tmus*4-1:0] hits_o,        // by TMU, then bank
  output logic [Tmus*4-1:0] misses_o,
  output logic [Tmus*4-1:0] duplicates_o,  // misses of lines that another TMU's cache holds
  output logic [Tmus-1:0]   color_o,       // texture of the TMU's word
  output logic [ptm_unit_pkg::DrawBits-1:0] draw_o
);
  localparam int SetBits = ptm_unit_front_pkg::SetBits;
  localparam int Snoops  = Tmus == 1 ? 1 : Tmus - 1;

  logic                t_valid, t_load, leaves;
  ptm_unit_pkg::beat_t beat_q;
  ptm_stream_reg u_t (
    .clk_i(clk_i), .rst_ni(rst_ni), .valid_i(valid_i), .ready_o(ready_o), .load_o(t_load),
    .valid_o(t_valid), .ready_i(leaves)
  );
  always_ff @(posedge clk_i) if (t_load) beat_q <= beat_i;
  assign beat_o = beat_q;
  assign draw_o = beat_q.draw;

  logic first_q;  // the first cycle of the beat
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) first_q <= 1'b0;
    else first_q <= t_load;
  end
  assign looked_o = first_q;

  logic [Tmus-1:0]            more;
  logic [Tmus*4*LineBits-1:0] line;  // looked up, by TMU, then bank
  logic [Tmus*4*SetBits-1:0]  set_index;
  logic [Tmus*Tmus*4-1:0]     held;  // [holder][misser][bank]
  for (genvar t = 0; t < Tmus; t++) begin : gen_tmu
    // The other TMUs, in order; a single one has nobody to ask for
    logic [Snoops*4-1:0]          snoop, snoop_held;
    logic [Snoops*4*LineBits-1:0] snoop_line;
    logic [Snoops*4*SetBits-1:0]  snoop_set;
    for (genvar s = 0; s < Snoops; s++) begin : gen_snoop
      localparam int Other = Tmus == 1 ? 0 : s < t ? s : s + 1;
      // In the many cycles without a miss nothing moves, and nothing is simulated.
      always_comb begin
        snoop[s*4 +: 4]                        = 4'd0;
        snoop_line[s*4*LineBits +: 4*LineBits] = '0;
        snoop_set[s*4*SetBits +: 4*SetBits]    = '0;
        if (Tmus > 1 && first_q && misses_o[Other*4 +: 4] != 4'd0) begin
          snoop[s*4 +: 4]                        = misses_o[Other*4 +: 4];
          snoop_line[s*4*LineBits +: 4*LineBits] = line[Other*4*LineBits +: 4*LineBits];
          snoop_set[s*4*SetBits +: 4*SetBits]    = set_index[Other*4*SetBits +: 4*SetBits];
        end
      end
      assign held[(t*Tmus + Other)*4 +: 4]          = snoop_held[s*4 +: 4];
    end
    if (Tmus > 1) begin : gen_self
      assign held[(t*Tmus + t)*4 +: 4] = 4'd0;
    end
    ptm_unit_tmu_tags #(
      .Sets(Sets), .Ways(Ways), .Snoops(Snoops)
    ) u_tmu (
      .clk_i(clk_i), .rst_ni(rst_ni), .invalidate_i(invalidate_i), .load_i(t_load),
      .texels_i(color_i[t] ? color_texels_i : map_texels_i),
      .row_lines_i(color_i[t] ? color_row_lines_i : map_row_lines_i),
      .column_lines_i(color_i[t] ? color_column_lines_i : map_column_lines_i),
      .color_i(color_i[t]), .fetched_i(fetched_i[t]), .plane_i(plane_i[t*3 +: 3]),
      .taps_i(taps_i), .valid_i(t_valid), .first_i(first_q), .push_i(miss_push_o),
      .miss_valid_o(miss_valid_o[t]),
      .miss_line_o(miss_line_o[t*LineBits +: LineBits]), .more_o(more[t]),
      .reads_o(reads_o[t*ReadsW +: ReadsW]), .hits_o(hits_o[t*4 +: 4]),
      .misses_o(misses_o[t*4 +: 4]), .color_o(color_o[t]),
      .line_o(line[t*4*LineBits +: 4*LineBits]), .set_o(set_index[t*4*SetBits +: 4*SetBits]),
      .snoop_i(snoop), .snoop_line_i(snoop_line), .snoop_set_i(snoop_set),
      .snoop_held_o(snoop_held)
    );
  end

  always_comb begin
    duplicates_o = '0;
    for (int holder = 0; holder < Tmus; holder++) begin
      duplicates_o = duplicates_o | held[holder*Tmus*4 +: Tmus*4];
    end
  end

  // Ranks and the way out. Whether the FIFO has a place is known at the cycle's start.
  logic last_rank;
  assign last_rank         = more == '0;
  assign valid_o           = t_valid && last_rank && miss_fits_i;
  assign leaves            = valid_o && ready_i;
  assign miss_push_o       = t_valid && miss_fits_i && (!last_rank || ready_i);
  assign waits_for_slots_o = t_valid && !miss_fits_i;

  `PTM_ASSERT(FirstOnlyOfABeat_A, !first_q || t_valid)
endmodule
