// One TMU's part of T: its word's look-ups in the four tag banks, and what of them is still to be
// pushed to the miss ring. Used by ptm_unit_tags, which decides when a rank moves.
//
// The outcome of the first cycle is kept while the beat stays. docs/spec/unit-timing.md, Tags.
module ptm_unit_tmu_tags #(
  parameter int Sets   = 32,  // of a bank
  parameter int Ways   = 2,
  parameter int Snoops = 2,   // other TMUs, at least 1 port
  localparam int LineBits = ptm_unit_pkg::LineBits,
  localparam int SetBits  = ptm_unit_front_pkg::SetBits,
  localparam int RowBits  = ptm_unit_front_pkg::RowBits
) (
  input  logic                        clk_i,
  input  logic                        rst_ni,
  input  logic                        invalidate_i,
  input  logic                        load_i,   // T takes over a beat, with this word:
  input  ptm_unit_front_pkg::texels_t       texels_i,
  input  ptm_unit_front_pkg::row_lines_t    row_lines_i,
  input  ptm_unit_front_pkg::column_lines_t column_lines_i,
  input  logic                        color_i,
  input  logic                        fetched_i,
  input  logic [2:0]                  plane_i,
  input  logic [3:0]                  taps_i,
  input  logic                        valid_i,  // T holds a beat
  input  logic                        first_i,  // in its first cycle: look up
  input  logic                        push_i,   // this rank is pushed
  // This rank
  output logic                        miss_valid_o,
  output logic [LineBits-1:0]         miss_line_o,
  output logic                        more_o,   // the beat has misses beyond this rank
  output ptm_unit_front_pkg::reads_t  reads_o,
  // Of the look-up, by bank; of a meaning only in the first cycle
  output logic [3:0]                  hits_o,
  output logic [3:0]                  misses_o,
  output logic                        color_o,
  output logic [4*LineBits-1:0]       line_o,
  output logic [4*SetBits-1:0]        set_o,
  // Other TMUs' misses of the same cycle: does this cache hold them? By TMU, then bank
  input  logic [Snoops*4-1:0]          snoop_i,
  input  logic [Snoops*4*LineBits-1:0] snoop_line_i,
  input  logic [Snoops*4*SetBits-1:0]  snoop_set_i,
  output logic [Snoops*4-1:0]          snoop_held_o
);
  localparam int WayBits = $clog2(Ways);
  localparam int SetIndexBits = $clog2(Sets);

  logic [3:0]            fetched, fetched_q, first, first_q;  // by tap
  logic [7:0]            tap_bank, tap_bank_q;
  logic [3:0]            used, used_q;                        // by bank
  logic [4*LineBits-1:0] line, line_q;
  logic [4*SetBits-1:0]  set_index, set_index_q;
  logic [3:0]            i_q, j_q;                            // within the tiles
  logic                  color_q;
  ptm_unit_lookup #(
    .Sets(Sets)
  ) u_lookup (
    .texels_i(texels_i), .row_lines_i(row_lines_i), .column_lines_i(column_lines_i),
    .color_i(color_i), .fetched_i(fetched_i), .plane_i(plane_i), .taps_i(taps_i),
    .fetched_o(fetched), .first_o(first), .bank_o(tap_bank), .used_o(used), .line_o(line),
    .set_o(set_index)
  );
  always_ff @(posedge clk_i) begin
    if (load_i) begin
      fetched_q   <= fetched;
      first_q     <= first;
      tap_bank_q  <= tap_bank;
      used_q      <= used;
      line_q      <= line;
      set_index_q <= set_index;
      i_q         <= {texels_i.i[1][1:0], texels_i.i[0][1:0]};
      j_q         <= {texels_i.j[1][1:0], texels_i.j[0][1:0]};
      color_q     <= color_i;
    end
  end

  logic [3:0] hit;
  logic [7:0] way_now, way_q, way;  // by bank
  for (genvar b = 0; b < 4; b++) begin : gen_bank
    logic [Snoops-1:0]          snoop, held;
    logic [Snoops*LineBits-1:0] snoop_line;
    logic [Snoops*SetBits-1:0]  snoop_set;
    for (genvar s = 0; s < Snoops; s++) begin : gen_snoop
      localparam int From = s * 4 + b;
      assign snoop[s]                           = snoop_i[From];
      assign snoop_line[s*LineBits +: LineBits] = snoop_line_i[From*LineBits +: LineBits];
      assign snoop_set[s*SetBits +: SetBits]    = snoop_set_i[From*SetBits +: SetBits];
      assign snoop_held_o[From]                 = held[s];
    end
    ptm_unit_tag_bank #(
      .Sets(Sets), .Ways(Ways), .Snoops(Snoops)
    ) u_bank (
      .clk_i(clk_i), .rst_ni(rst_ni), .invalidate_i(invalidate_i),
      .update_i(first_i && used_q[b]), .set_i(set_index_q[b*SetBits +: SetBits]),
      .line_i(line_q[b*LineBits +: LineBits]), .hit_o(hit[b]), .way_o(way_now[b*2 +: 2]),
      .snoop_i(snoop),
      .snoop_set_i(snoop_set), .snoop_line_i(snoop_line), .snoop_held_o(held)
    );
  end
  assign hits_o   = used_q & hit;
  assign misses_o = used_q & ~hit;
  assign color_o  = color_q;
  assign line_o   = line_q;
  assign set_o    = set_index_q;

  // Misses by tap: all of the beat's, and those still to be pushed
  logic [3:0] missed_now, missed_q, left, left_q, left_after;
  for (genvar tap = 0; tap < 4; tap++) begin : gen_tap
    assign missed_now[tap] = first_q[tap] && !hit[tap_bank_q[tap*2 +: 2]];
  end
  assign left       = first_i ? missed_now : left_q;
  assign left_after = left & (left - 4'd1);
  assign way        = first_i ? way_now : way_q;
  always_ff @(posedge clk_i) begin
    if (first_i) begin
      missed_q <= missed_now;
      way_q    <= way_now;
    end
    left_q <= push_i ? left_after : left;
  end

  logic [1:0] tap_now, bank_now;
  assign tap_now      = left[0] ? 2'd0 : left[1] ? 2'd1 : left[2] ? 2'd2 : 2'd3;
  assign miss_valid_o = valid_i && left != 4'd0;
  assign bank_now     = tap_bank_q[tap_now*2 +: 2];
  assign miss_line_o  = line_q[bank_now*LineBits +: LineBits];
  assign more_o       = left_after != 4'd0;

  // Rows of the data banks: {bank, set, way}
  logic [4*RowBits-1:0] row;
  for (genvar tap = 0; tap < 4; tap++) begin : gen_row
    logic [1:0] bank;
    assign bank = tap_bank_q[tap*2 +: 2];
    assign row[tap*RowBits +: RowBits] =
        (RowBits'(bank) << (SetIndexBits + WayBits)) |
        (RowBits'(set_index_q[bank*SetBits +: SetBits]) << WayBits) | RowBits'(way[bank*2 +: 2]);
  end
  always_comb begin
    reads_o         = '0;
    reads_o.fetched = fetched_q;
    reads_o.missed  = first_i ? missed_now : missed_q;
    reads_o.row     = row;
    reads_o.i       = i_q;
    reads_o.j       = j_q;
  end
endmodule
