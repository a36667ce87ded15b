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
  localparam int PlaneBits = ptm_unit_front_pkg::PlaneBits,
  localparam int TakenW   = ptm_unit_front_pkg::TakenW,
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
  input  logic [Tmus*PlaneBits-1:0] plane_i,
  // A rank to the miss ring: lines of the TMUs in miss_valid_o, all or none
  output logic [Tmus-1:0]          miss_valid_o,
  output logic [Tmus*LineBits-1:0] miss_line_o,
  output logic                     miss_push_o,
  input  logic                     miss_fits_i,  // as many slots are free
  // To the fragment FIFO
  output logic                   valid_o,
  input  logic                   ready_i,
  output ptm_unit_pkg::beat_t    beat_o,
  output logic [2*TakenW-1:0]    taken_o,   // taken_t of the map, of the colour texture
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
  localparam int SetBits    = ptm_unit_front_pkg::SetBits;
  localparam int PlaceBits  = ptm_unit_front_pkg::PlaceBits;
  localparam int LookUpBits = $clog2(Tmus * 4);
  localparam int Snoops     = Tmus == 1 ? 1 : Tmus - 1;

  // What the words of either texture look up
  ptm_unit_front_pkg::taken_t map_taken, color_taken;
  logic [3:0]            map_first, color_first, map_used, color_used;
  logic [4*SetBits-1:0]  map_hash, color_hash, map_low, color_low;
  logic [2*LineBits-1:0] map_row, color_row, map_column, color_column;
  ptm_unit_lookup #(
    .Sets(Sets), .Color(0)
  ) u_lookup_map (
    .enable_i((fetched_i & ~color_i) != '0), .texels_i(map_texels_i),
    .row_lines_i(map_row_lines_i), .column_lines_i(map_column_lines_i), .taps_i(taps_i),
    .taken_o(map_taken), .first_o(map_first), .used_o(map_used), .hash_o(map_hash),
    .low_o(map_low), .row_o(map_row), .column_o(map_column)
  );
  ptm_unit_lookup #(
    .Sets(Sets), .Color(1)
  ) u_lookup_color (
    .enable_i((fetched_i & color_i) != '0), .texels_i(color_texels_i),
    .row_lines_i(color_row_lines_i), .column_lines_i(color_column_lines_i), .taps_i(taps_i),
    .taken_o(color_taken), .first_o(color_first), .used_o(color_used), .hash_o(color_hash),
    .low_o(color_low), .row_o(color_row), .column_o(color_column)
  );

  // T
  logic                       t_valid, t_load, leaves;
  ptm_unit_pkg::beat_t        beat_q;
  ptm_unit_front_pkg::taken_t map_taken_q, color_taken_q;
  logic [3:0]                 map_first_q, color_first_q, map_used_q, color_used_q;
  logic [Tmus-1:0]            fetched_q, color_q;
  ptm_stream_reg u_t (
    .clk_i(clk_i), .rst_ni(rst_ni), .valid_i(valid_i), .ready_o(ready_o), .load_o(t_load),
    .valid_o(t_valid), .ready_i(leaves)
  );
  always_ff @(posedge clk_i) begin
    if (t_load) begin
      beat_q        <= beat_i;
      map_taken_q   <= map_taken;
      color_taken_q <= color_taken;
      map_first_q   <= map_first;
      color_first_q <= color_first;
      map_used_q    <= map_used;
      color_used_q  <= color_used;
      fetched_q     <= fetched_i;
      color_q       <= color_i;
    end
  end
  assign beat_o  = beat_q;
  assign draw_o  = beat_q.draw;
  assign color_o = color_q;
  assign taken_o = {color_taken_q, map_taken_q};

  logic first_q;  // the first cycle of the beat
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) first_q <= 1'b0;
    else first_q <= t_load;
  end
  assign looked_o = first_q;

  logic [SetBits-1:0]     set [Tmus*4];   // looked up, by TMU, then bank
  logic [LineBits-1:0]    line [Tmus*4];
  logic [Tmus-1:0]        more;
  logic [Tmus*4-1:0]      hit;
  logic [Tmus*Tmus*4-1:0] held;  // [holder][misser][bank]
  for (genvar t = 0; t < Tmus; t++) begin : gen_tmu
    // A word's look-ups are its texture's, moved by its plane
    logic [PlaneBits-1:0]  plane;
    logic [4*SetBits-1:0]  hash, low;
    logic [2*LineBits-1:0] row, column;
    assign plane  = plane_i[t*PlaneBits +: PlaneBits];
    assign hash   = color_i[t] ? color_hash : map_hash;
    assign low    = color_i[t] ? color_low : map_low;
    assign row    = color_i[t] ? color_row : map_row;
    assign column = color_i[t] ? color_column : map_column;

    logic [3:0] used, first;
    assign used  = !fetched_q[t] ? 4'd0 : color_q[t] ? color_used_q : map_used_q;
    assign first = !fetched_q[t] ? 4'd0 : color_q[t] ? color_first_q : map_first_q;

    logic [4*PlaceBits-1:0] place;
    for (genvar b = 0; b < 4; b++) begin : gen_bank
      localparam int At = t * 4 + b;
      logic [SetBits-1:0]  hashed, set_q;
      logic [LineBits-1:0] line_q;
      assign hashed = hash[b*SetBits +: SetBits] + SetBits'(plane);
      always_ff @(posedge clk_i) begin
        if (t_load) begin
          set_q  <= (low[b*SetBits +: SetBits] ^ hashed) & SetBits'(Sets - 1);
          line_q <= row[(b/2)*LineBits +: LineBits] + column[(b%2)*LineBits +: LineBits] +
                    LineBits'(plane);
        end
      end
      assign set[At]  = set_q;
      assign line[At] = line_q;
      // The other TMUs, in order; a single one has nobody to ask for
      logic [Snoops-1:0]          snoop, snoop_held;
      logic [Snoops*LineBits-1:0] snoop_line;
      logic [Snoops*SetBits-1:0]  snoop_set;
      for (genvar s = 0; s < Snoops; s++) begin : gen_snoop
        localparam int Other = Tmus == 1 ? 0 : s < t ? s : s + 1;
        assign snoop[s]                           = Tmus > 1 && first_q && misses_o[Other*4 + b];
        assign snoop_line[s*LineBits +: LineBits] = line[Other*4 + b];
        assign snoop_set[s*SetBits +: SetBits]    = set[Other*4 + b];
        assign held[(t*Tmus + Other)*4 + b]       = snoop_held[s];
      end
      if (Tmus > 1) begin : gen_self
        assign held[(t*Tmus + t)*4 + b] = 1'b0;
      end
      ptm_unit_tag_bank #(
        .Sets(Sets), .Ways(Ways), .Snoops(Snoops)
      ) u_bank (
        .clk_i(clk_i), .rst_ni(rst_ni), .invalidate_i(invalidate_i),
        .update_i(first_q && used[b]), .set_i(set_q), .line_i(line_q), .hit_o(hit[At]),
        .place_o(place[b*PlaceBits +: PlaceBits]), .snoop_i(snoop), .snoop_set_i(snoop_set),
        .snoop_line_i(snoop_line), .snoop_held_o(snoop_held)
      );
    end
    assign hits_o[t*4 +: 4]   = used & hit[t*4 +: 4];
    assign misses_o[t*4 +: 4] = used & ~hit[t*4 +: 4];

    logic [1:0] miss_bank;
    ptm_unit_tmu_tags u_tmu (
      .clk_i(clk_i), .valid_i(t_valid), .first_i(first_q), .push_i(miss_push_o),
      .fetched_i(fetched_q[t]), .color_i(color_q[t]),
      .taken_i(color_q[t] ? color_taken_q : map_taken_q), .first_taps_i(first),
      .misses_i(misses_o[t*4 +: 4]), .place_i(place), .miss_valid_o(miss_valid_o[t]),
      .miss_bank_o(miss_bank), .more_o(more[t]), .reads_o(reads_o[t*ReadsW +: ReadsW])
    );
    assign miss_line_o[t*LineBits +: LineBits] = line[LookUpBits'(t*4) + LookUpBits'(miss_bank)];
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
