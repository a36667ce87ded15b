// T: looks a beat's tiles up in the caches' tags, pushes its misses rank by rank to the miss ring,
// and sends the beat to the fragment FIFO with its last rank.
//
// Tags are read as the beat enters; look-up happens in its first cycle here, on the state that the
// beat before left. Rank r
// is the r-th miss of each TMU, in the order of TMUs; a rank is pushed whole or not at all. A beat
// without misses needs only the FIFO. docs/spec/unit-timing.md, Tags.
`include "ptm_assert.svh"
module ptm_front_tags #(
  parameter int Tmus = 3,
  parameter int Sets = 32,  // of a bank
  parameter int Ways = 2,
  parameter int DuplicateLines = 1,  // 0: duplicates_o is 0
  localparam int LineBits = ptm_unit_pkg::LineBits,
  localparam int PlaneBits = ptm_front_pkg::PlaneBits,
  localparam int TakenW   = ptm_front_pkg::TakenW,
  localparam int ReadsW   = ptm_front_pkg::ReadsW
) (
  input  logic                clk_i,
  input  logic                rst_ni,
  input  logic                invalidate_i,
  // Sub-beat
  input  logic                    valid_i,
  output logic                    ready_o,
  input  ptm_unit_pkg::beat_t     beat_i,
  input  ptm_front_pkg::texels_t       map_texels_i,
  input  ptm_front_pkg::row_lines_t    map_row_lines_i,
  input  ptm_front_pkg::column_lines_t map_column_lines_i,
  input  ptm_front_pkg::texels_t       color_texels_i,
  input  ptm_front_pkg::row_lines_t    color_row_lines_i,
  input  ptm_front_pkg::column_lines_t color_column_lines_i,
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
  output logic [Tmus*4-1:0] duplicates_o,  // a cycle later: lines that another TMU's cache held
  output logic [Tmus-1:0]   color_o,       // texture of the TMU's word
  output logic [ptm_unit_pkg::DrawBits-1:0] draw_o
);
  localparam int SetBits   = ptm_front_pkg::SetBits;
  localparam int PlaceBits = ptm_front_pkg::PlaceBits;

  // What the words of either texture look up
  ptm_front_pkg::taken_t map_taken, color_taken;
  logic [1:0]            map_new_rows, map_new_columns, color_new_rows, color_new_columns;
  logic [3:0]            map_used, color_used;
  logic [2*SetBits-1:0]  map_hash_x, map_hash_y, map_low_x, map_low_y;
  logic [2*SetBits-1:0]  color_hash_x, color_hash_y, color_low_x, color_low_y;
  logic [2*LineBits-1:0] map_row, color_row, map_column, color_column;
  ptm_front_lookup #(
    .Sets(Sets), .Color(0)
  ) u_lookup_map (
    .enable_i((fetched_i & ~color_i) != '0), .texels_i(map_texels_i),
    .row_lines_i(map_row_lines_i), .column_lines_i(map_column_lines_i), .taps_i(taps_i),
    .taken_o(map_taken), .new_rows_o(map_new_rows), .new_columns_o(map_new_columns),
    .used_o(map_used), .hash_x_o(map_hash_x), .hash_y_o(map_hash_y),
    .low_x_o(map_low_x), .low_y_o(map_low_y), .row_o(map_row), .column_o(map_column)
  );
  ptm_front_lookup #(
    .Sets(Sets), .Color(1)
  ) u_lookup_color (
    .enable_i((fetched_i & color_i) != '0), .texels_i(color_texels_i),
    .row_lines_i(color_row_lines_i), .column_lines_i(color_column_lines_i), .taps_i(taps_i),
    .taken_o(color_taken), .new_rows_o(color_new_rows), .new_columns_o(color_new_columns),
    .used_o(color_used), .hash_x_o(color_hash_x), .hash_y_o(color_hash_y),
    .low_x_o(color_low_x), .low_y_o(color_low_y), .row_o(color_row), .column_o(color_column)
  );

  // T
  logic                       t_valid, t_load, leaves;
  ptm_unit_pkg::beat_t        beat_q;
  ptm_front_pkg::taken_t map_taken_q, color_taken_q;
  logic [1:0]                 map_new_rows_q, map_new_columns_q;
  logic [1:0]                 color_new_rows_q, color_new_columns_q;
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
      {map_new_rows_q, map_new_columns_q}     <= {map_new_rows, map_new_columns};
      {color_new_rows_q, color_new_columns_q} <= {color_new_rows, color_new_columns};
      fetched_q     <= fetched_i;
      color_q       <= color_i;
    end
  end
  assign beat_o  = beat_q;
  assign draw_o  = beat_q.draw;
  assign color_o = color_q;
  assign taken_o = {color_taken_q, map_taken_q};

  // In the first cycle of the beat: the banks with a look-up, by TMU
  logic              first_q;
  logic [Tmus*4-1:0] look_up, look_up_q;
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      first_q   <= 1'b0;
      look_up_q <= '0;
    end else begin
      first_q   <= t_load;
      look_up_q <= t_load ? look_up : '0;
    end
  end
  assign looked_o = first_q;

  logic [Tmus-1:0]            more;
  logic [4*Tmus*SetBits-1:0]  sets;   // looked up, by bank, then TMU
  logic [4*Tmus*LineBits-1:0] lines;
  assign misses_o = look_up_q & ~hits_o;

  // In a cycle with a miss, every look-up is looked for in the other TMUs' caches, and what was
  // missed is counted a cycle later. (One condition for all: a bit a look-up costs the simulation
  // more.)
  logic                       any_miss, any_missed;
  logic [4*Tmus*SetBits-1:0]  miss_set;
  logic [4*Tmus*LineBits-1:0] missed_line;  // a cycle later
  logic [4*Tmus*Tmus-1:0]     held;         // likewise; by bank, then holder, then misser
  if (DuplicateLines == 0 || Tmus == 1) begin : gen_no_duplicates
    assign any_miss     = 1'b0;
    assign any_missed   = 1'b0;
    assign miss_set     = '0;
    assign missed_line  = '0;
    assign duplicates_o = '0;
    logic unused;
    assign unused = ^{sets, lines, held};
  end else begin : gen_duplicates
    assign any_miss = misses_o != '0;
    always_comb begin
      miss_set = '0;
      if (any_miss) miss_set = sets;
    end
    logic [Tmus*4-1:0]          missed_q;
    logic [4*Tmus*LineBits-1:0] missed_line_q;
    always_ff @(posedge clk_i or negedge rst_ni) begin
      if (!rst_ni) missed_q <= '0;
      else missed_q <= misses_o;
    end
    always_ff @(posedge clk_i) if (any_miss) missed_line_q <= lines;
    assign missed_line = missed_line_q;
    assign any_missed  = missed_q != '0;
    always_comb begin
      duplicates_o = '0;
      if (any_missed) begin
        for (int b = 0; b < 4; b++) begin
          for (int n = 0; n < Tmus * Tmus; n++) begin
            if (held[b*Tmus*Tmus + n]) duplicates_o[(n % Tmus)*4 + b] = missed_q[(n % Tmus)*4 + b];
          end
        end
      end
    end
  end
  for (genvar t = 0; t < Tmus; t++) begin : gen_tmu
    // A word's look-ups are its texture's, moved by its plane
    logic [PlaneBits-1:0]  plane;
    logic [2*SetBits-1:0]  hash_x, hash_y, low_x, low_y;
    logic [2*LineBits-1:0] row, column;
    assign plane  = plane_i[t*PlaneBits +: PlaneBits];
    assign hash_x = color_i[t] ? color_hash_x : map_hash_x;
    assign hash_y = color_i[t] ? color_hash_y : map_hash_y;
    assign low_x  = color_i[t] ? color_low_x : map_low_x;
    assign low_y  = color_i[t] ? color_low_y : map_low_y;
    assign row    = color_i[t] ? color_row : map_row;
    assign column = color_i[t] ? color_column : map_column;
    assign look_up[t*4 +: 4] = !fetched_i[t] ? 4'd0 : color_i[t] ? color_used : map_used;

    logic [4*PlaceBits-1:0] place;
    logic [LineBits-1:0]    line [4];  // by bank
    for (genvar b = 0; b < 4; b++) begin : gen_bank
      localparam int At = t * 4 + b;
      localparam int X = b % 2, Y = b / 2;
      logic                read;  // for the look-up in the next cycle
      logic [SetBits-1:0]  hash, low, set, set_q;
      logic [LineBits-1:0] line_q;
      assign hash = hash_y[Y*SetBits +: SetBits] + hash_x[X*SetBits +: SetBits] + SetBits'(plane);
      assign low  = low_y[Y*SetBits +: SetBits] | low_x[X*SetBits +: SetBits];
      always_comb begin
        read = 1'b0;
        set  = '0;
        if (t_load) begin
          if (look_up[At]) begin
            read = 1'b1;
            set  = (low ^ hash) & SetBits'(Sets - 1);
          end
        end
      end
      always_ff @(posedge clk_i) begin
        if (read) begin
          set_q  <= set;
          line_q <= row[Y*LineBits +: LineBits] + column[X*LineBits +: LineBits] +
                    LineBits'(plane);
        end
      end
      localparam int By = b * Tmus + t;
      assign sets[By*SetBits +: SetBits]    = set_q;
      assign lines[By*LineBits +: LineBits] = line_q;
      assign line[b]                        = line_q;
      ptm_front_tag_bank #(
        .Sets(Sets), .Ways(Ways), .Tmus(Tmus), .Tmu(t), .DuplicateLines(DuplicateLines)
      ) u_bank (
        .clk_i(clk_i), .rst_ni(rst_ni), .invalidate_i(invalidate_i), .read_i(read),
        .read_set_i(set), .look_up_i(look_up_q[At]), .set_i(set_q), .line_i(line_q),
        .hit_o(hits_o[At]),
        .place_o(place[b*PlaceBits +: PlaceBits]), .any_miss_i(any_miss),
        .any_missed_i(any_missed), .miss_set_i(miss_set[b*Tmus*SetBits +: Tmus*SetBits]),
        .missed_line_i(missed_line[b*Tmus*LineBits +: Tmus*LineBits]),
        .held_o(held[By*Tmus +: Tmus])
      );
    end

    logic [1:0] miss_bank;
    ptm_front_tmu_tags u_tmu (
      .clk_i(clk_i), .valid_i(t_valid), .first_i(first_q), .push_i(miss_push_o),
      .fetched_i(fetched_q[t]), .color_i(color_q[t]),
      .taken_i(color_q[t] ? color_taken_q : map_taken_q),
      .new_rows_i(color_q[t] ? color_new_rows_q : map_new_rows_q),
      .new_columns_i(color_q[t] ? color_new_columns_q : map_new_columns_q),
      .misses_i(misses_o[t*4 +: 4]), .place_i(place), .miss_valid_o(miss_valid_o[t]),
      .miss_bank_o(miss_bank), .more_o(more[t]), .reads_o(reads_o[t*ReadsW +: ReadsW])
    );
    assign miss_line_o[t*LineBits +: LineBits] = line[miss_bank];
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
