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
  input  logic                        load_i,   // T takes over a beat
  input  ptm_unit_front_pkg::lookup_t lookup_i,
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

  ptm_unit_front_pkg::lookup_t lookup_q;
  always_ff @(posedge clk_i) if (load_i) lookup_q <= lookup_i;

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
      .update_i(first_i && lookup_q.used[b]), .set_i(lookup_q.set_index[b]),
      .line_i(lookup_q.line[b]), .hit_o(hit[b]), .way_o(way_now[b*2 +: 2]), .snoop_i(snoop),
      .snoop_set_i(snoop_set), .snoop_line_i(snoop_line), .snoop_held_o(held)
    );
  end
  assign hits_o   = lookup_q.used & hit;
  assign misses_o = lookup_q.used & ~hit;
  assign color_o  = lookup_q.color;
  assign line_o   = lookup_q.line;
  assign set_o    = lookup_q.set_index;

  // Misses by tap: all of the beat's, and those still to be pushed
  logic [3:0] missed_now, missed_q, left, left_q, left_after;
  for (genvar tap = 0; tap < 4; tap++) begin : gen_tap
    assign missed_now[tap] = lookup_q.first[tap] && !hit[lookup_q.bank[tap]];
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

  logic [1:0] tap_now;
  assign tap_now      = left[0] ? 2'd0 : left[1] ? 2'd1 : left[2] ? 2'd2 : 2'd3;
  assign miss_valid_o = valid_i && left != 4'd0;
  assign miss_line_o  = lookup_q.line[lookup_q.bank[tap_now]];
  assign more_o       = left_after != 4'd0;

  // Rows of the data banks: {bank, set, way}
  logic [4*RowBits-1:0] row;
  for (genvar tap = 0; tap < 4; tap++) begin : gen_row
    logic [1:0] bank;
    assign bank = lookup_q.bank[tap];
    assign row[tap*RowBits +: RowBits] =
        (RowBits'(bank) << (SetIndexBits + WayBits)) |
        (RowBits'(lookup_q.set_index[bank]) << WayBits) | RowBits'(way[bank*2 +: 2]);
  end
  always_comb begin
    reads_o         = '0;
    reads_o.fetched = lookup_q.fetched;
    reads_o.missed  = first_i ? missed_now : missed_q;
    reads_o.row     = row;
    reads_o.i       = lookup_q.i;
    reads_o.j       = lookup_q.j;
  end
endmodule
