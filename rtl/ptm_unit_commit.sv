// K: the beat at the fragment FIFO's exit. Commits one rank of its missing lines a cycle, at most a
// line a TMU, as soon as all of the rank are usable and F accepts; the beat leaves with its last
// rank, and its slots return. docs/spec/unit-timing.md, Commit and fetch.
module ptm_unit_commit #(
  parameter int Tmus = 3,
  localparam int RowBits = ptm_unit_front_pkg::RowBits
) (
  input  logic                clk_i,
  input  logic                rst_ni,
  input  logic                valid_i,
  output logic                ready_o,
  input  ptm_unit_pkg::beat_t beat_i,
  input  ptm_unit_front_pkg::reads_t [Tmus-1:0] reads_i,
  // Miss ring
  output logic [Tmus-1:0]     rank_o,
  input  logic                usable_i,
  output logic                commit_o,
  output logic                release_o,
  output logic [Tmus-1:0][RowBits-1:0] row_o,  // where the rank's lines go
  // F
  output logic                valid_o,
  input  logic                ready_i,
  output ptm_unit_pkg::beat_t beat_o,
  output ptm_unit_front_pkg::reads_t [Tmus-1:0] reads_o,
  output logic                holds_o          // a beat stands here
);
  logic                k_load, leaves;
  ptm_unit_pkg::beat_t beat_q;
  ptm_unit_front_pkg::reads_t [Tmus-1:0] reads_q;
  ptm_stream_reg u_k (
    .clk_i(clk_i), .rst_ni(rst_ni), .valid_i(valid_i), .ready_o(ready_o), .load_o(k_load),
    .valid_o(holds_o), .ready_i(leaves)
  );
  always_ff @(posedge clk_i) begin
    if (k_load) begin
      beat_q  <= beat_i;
      reads_q <= reads_i;
    end
  end

  logic [Tmus-1:0][3:0] left_q, left_after;
  logic [Tmus-1:0]      more;
  for (genvar t = 0; t < Tmus; t++) begin : gen_tmu
    ptm_unit_front_pkg::reads_t reads, reads_in;
    assign reads    = reads_q[t];
    assign reads_in = reads_i[t];
    logic [1:0] tap;
    assign tap           = left_q[t][0] ? 2'd0 : left_q[t][1] ? 2'd1 : left_q[t][2] ? 2'd2 : 2'd3;
    assign rank_o[t]     = holds_o && left_q[t] != 4'd0;
    assign row_o[t]      = reads.row[tap];
    assign left_after[t] = left_q[t] & (left_q[t] - 4'd1);
    assign more[t]       = left_after[t] != 4'd0;
    always_ff @(posedge clk_i) begin
      if (k_load) left_q[t] <= reads_in.missed;
      else if (commit_o) left_q[t] <= left_after[t];
    end
  end

  logic last_rank;
  assign last_rank = more == '0;
  assign valid_o   = holds_o && usable_i && last_rank;
  assign leaves    = valid_o && ready_i;
  assign commit_o  = holds_o && usable_i && ready_i;
  assign release_o = leaves;
  assign beat_o    = beat_q;
  assign reads_o   = reads_q;
endmodule
