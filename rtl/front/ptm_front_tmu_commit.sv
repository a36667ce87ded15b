// One TMU's part of K: what it reads, and which of its missing lines are still to be committed.
// Used by ptm_front_commit, which decides when a rank moves. docs/spec/unit-timing.md, Commit.
module ptm_front_tmu_commit #(
  parameter int Rows = 256,  // lines of the cache
  localparam int RowBits = ptm_front_pkg::RowBits
) (
  input  logic                       clk_i,
  input  logic                       load_i,    // K takes over a beat
  input  ptm_front_pkg::reads_t reads_i,
  input  logic                       valid_i,   // K holds a beat: its taps
  input  ptm_front_pkg::taken_t map_i,
  input  ptm_front_pkg::taken_t color_i,
  input  logic                       commit_i,  // this rank is committed
  output logic                       line_o,    // the rank has a line of this TMU
  output logic [RowBits-1:0]         row_o,     // where it goes
  output logic                       more_o,    // the beat has lines beyond this rank
  output ptm_front_pkg::reads_t reads_o
);
  ptm_front_pkg::reads_t reads_q;
  logic [3:0]                 left_q, left_after;  // taps
  assign left_after = left_q & (left_q - 4'd1);
  assign line_o     = valid_i && left_q != 4'd0;
  assign more_o     = left_after != 4'd0;
  assign reads_o    = reads_q;

  // The rank's line goes where the tag bank of its tap said
  logic [1:0] tap, column_bank, row_bank, bank;
  always_comb begin
    {tap, column_bank, row_bank, bank} = '0;
    row_o                              = '0;
    if (line_o) begin
      tap         = left_q[0] ? 2'd0 : left_q[1] ? 2'd1 : left_q[2] ? 2'd2 : 2'd3;
      column_bank = reads_q.color ? {color_i.i1[2], color_i.i0[2]} : {map_i.i1[2], map_i.i0[2]};
      row_bank    = reads_q.color ? {color_i.j1[2], color_i.j0[2]} : {map_i.j1[2], map_i.j0[2]};
      bank        = {row_bank[tap[1]], column_bank[tap[0]]};
      row_o       = (RowBits'(bank) << ($clog2(Rows) - 2)) | RowBits'(reads_q.place[bank]);
    end
  end

  always_ff @(posedge clk_i) begin
    if (load_i) begin
      reads_q <= reads_i;
      left_q  <= reads_i.missed;
    end else if (commit_i) begin
      left_q <= left_after;
    end
  end
endmodule
