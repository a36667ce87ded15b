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
  localparam int LineBits = ptm_unit_pkg::LineBits
) (
  input  logic                clk_i,
  input  logic                rst_ni,
  input  logic                invalidate_i,
  // Sub-beat
  input  logic                valid_i,
  output logic                ready_o,
  input  ptm_unit_pkg::beat_t beat_i,
  input  ptm_unit_front_pkg::lookup_t [Tmus-1:0] lookup_i,
  // A rank to the miss ring: lines of the TMUs in miss_valid_o, all or none
  output logic [Tmus-1:0]               miss_valid_o,
  output logic [Tmus-1:0][LineBits-1:0] miss_line_o,
  output logic                          miss_push_o,
  input  logic                          miss_fits_i,  // as many slots are free
  // To the fragment FIFO
  output logic                valid_o,
  input  logic                ready_i,
  output ptm_unit_pkg::beat_t beat_o,
  output ptm_unit_front_pkg::reads_t [Tmus-1:0] reads_o,
  // Counters
  output logic                waits_for_slots_o,
  output logic                looked_o,          // the increments below count in this cycle
  output logic [Tmus-1:0][3:0] hits_o,           // by TMU and bank
  output logic [Tmus-1:0][3:0] misses_o,
  output logic [Tmus-1:0][3:0] duplicates_o,
  output logic [Tmus-1:0]      color_o,          // texture of the TMU's word
  output logic [ptm_unit_pkg::DrawBits-1:0] draw_o
);
  localparam int SetIndexBits = $clog2(Sets);
  localparam int WayBits      = $clog2(Ways);
  localparam int RowBits      = ptm_unit_front_pkg::RowBits;
  localparam int Snoops       = Tmus == 1 ? 1 : Tmus - 1;

  logic                t_valid, t_load, leaves;
  ptm_unit_pkg::beat_t beat_q;
  ptm_unit_front_pkg::lookup_t [Tmus-1:0] lookup_q;
  ptm_stream_reg u_t (
    .clk_i(clk_i), .rst_ni(rst_ni), .valid_i(valid_i), .ready_o(ready_o), .load_o(t_load),
    .valid_o(t_valid), .ready_i(leaves)
  );
  always_ff @(posedge clk_i) begin
    if (t_load) begin
      beat_q   <= beat_i;
      lookup_q <= lookup_i;
    end
  end

  logic first_q;  // the first cycle of the beat
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) first_q <= 1'b0;
    else first_q <= t_load;
  end
  logic look;
  assign look     = t_valid && first_q;
  assign looked_o = look;
  assign draw_o   = beat_q.draw;

  // By TMU: misses that are to be pushed, by tap
  logic [Tmus-1:0][3:0] left, left_after;
  logic [Tmus-1:0]      more;  // beyond this rank

  logic [3:0]                                      bank_miss [Tmus];  // of this cycle's look-up
  logic [3:0][ptm_unit_front_pkg::SetBits-1:0]     bank_set [Tmus];
  logic [3:0][LineBits-1:0]                        bank_line [Tmus];
  logic [3:0]                                      held [Tmus][Snoops];

  for (genvar t = 0; t < Tmus; t++) begin : gen_tmu
    ptm_unit_front_pkg::lookup_t lookup;
    assign lookup = lookup_q[t];

    logic [3:0]      hit;
    logic [3:0][1:0] way_now, way_q, way;
    for (genvar b = 0; b < 4; b++) begin : gen_bank
      logic [Snoops-1:0]                                   snoop, snoop_held;
      logic [Snoops-1:0][ptm_unit_front_pkg::SetBits-1:0]  snoop_set;
      logic [Snoops-1:0][LineBits-1:0]                     snoop_line;
      for (genvar s = 0; s < Snoops; s++) begin : gen_snoop
        // The other TMUs, in order; with one TMU nobody
        localparam int Other = Tmus == 1 ? 0 : s < t ? s : s + 1;
        assign snoop[s]      = Tmus > 1 && look && bank_miss[Other][b];
        assign snoop_set[s]  = bank_set[Other][b];
        assign snoop_line[s] = bank_line[Other][b];
        assign held[t][s][b] = snoop_held[s];
      end
      ptm_unit_tag_bank #(
        .Sets(Sets), .Ways(Ways), .Snoops(Snoops)
      ) u_bank (
        .clk_i(clk_i), .rst_ni(rst_ni), .invalidate_i(invalidate_i),
        .update_i(look && lookup.used[b]), .set_i(lookup.set_index[b]), .line_i(lookup.line[b]),
        .hit_o(hit[b]), .way_o(way_now[b]), .snoop_i(snoop), .snoop_set_i(snoop_set),
        .snoop_line_i(snoop_line), .snoop_held_o(snoop_held)
      );
    end
    assign bank_miss[t] = lookup.used & ~hit;
    assign bank_set[t]  = lookup.set_index;
    assign bank_line[t] = lookup.line;
    assign hits_o[t]    = lookup.used & hit;
    assign misses_o[t]  = bank_miss[t];
    assign color_o[t]   = lookup.color;

    // The outcome is kept while the beat stays
    logic [3:0] missed_now, missed_q, missed, left_q;
    for (genvar tap = 0; tap < 4; tap++) begin : gen_tap
      assign missed_now[tap] = lookup.first[tap] && !hit[lookup.bank[tap]];
    end
    assign missed  = first_q ? missed_now : missed_q;
    assign left[t] = first_q ? missed_now : left_q;
    assign way     = first_q ? way_now : way_q;
    always_ff @(posedge clk_i) begin
      if (first_q) begin
        missed_q <= missed_now;
        way_q    <= way_now;
      end
      left_q <= miss_push_o ? left_after[t] : left[t];
    end

    // This rank
    logic [1:0] tap_now;
    assign tap_now         = left[t][0] ? 2'd0 : left[t][1] ? 2'd1 : left[t][2] ? 2'd2 : 2'd3;
    assign miss_valid_o[t] = t_valid && left[t] != 4'd0;
    assign miss_line_o[t]  = lookup.line[lookup.bank[tap_now]];
    assign left_after[t]   = left[t] & (left[t] - 4'd1);
    assign more[t]         = left_after[t] != 4'd0;

    // Rows of the data banks: {bank, set, way}
    logic [3:0][RowBits-1:0] row;
    for (genvar tap = 0; tap < 4; tap++) begin : gen_row
      logic [1:0] bank;
      assign bank     = lookup.bank[tap];
      assign row[tap] = RowBits'({bank, {SetIndexBits{1'b0}}, {WayBits{1'b0}}}) |
                        RowBits'({lookup.set_index[bank], {WayBits{1'b0}}}) | RowBits'(way[bank]);
    end
    always_comb begin
      reads_o[t]         = '0;
      reads_o[t].fetched = lookup.fetched;
      reads_o[t].missed  = missed;
      reads_o[t].row     = row;
      reads_o[t].i       = lookup.i;
      reads_o[t].j       = lookup.j;
    end
  end

  // Duplicates: lines that this TMU misses and another one holds
  for (genvar t = 0; t < Tmus; t++) begin : gen_duplicates
    always_comb begin
      duplicates_o[t] = 4'd0;
      for (int other = 0; other < Tmus; other++) begin
        if (Tmus > 1 && other != t) begin
          duplicates_o[t] = duplicates_o[t] | held[other][t < other ? t : t - 1];
        end
      end
    end
  end

  // Ranks and the way out. Whether the FIFO has a place is known at the cycle's start.
  logic last_rank;
  assign last_rank         = more == '0;
  assign valid_o           = t_valid && last_rank && miss_fits_i;
  assign leaves            = valid_o && ready_i;
  assign miss_push_o       = t_valid && miss_fits_i && (!last_rank || ready_i);
  assign waits_for_slots_o = t_valid && !miss_fits_i;
  assign beat_o            = beat_q;

  `PTM_ASSERT(FirstOnlyOfABeat_A, !first_q || t_valid)
endmodule
