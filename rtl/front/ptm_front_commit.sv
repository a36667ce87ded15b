// K: the beat at the fragment FIFO's exit. Commits one rank of its missing lines a cycle, at most a
// line a TMU, as soon as all of the rank are usable and F accepts; the beat leaves with its last
// rank, and its slots return. docs/spec/unit-timing.md, Commit and fetch.
module ptm_front_commit #(
  parameter int Tmus = 3,
  parameter int Rows = 256,  // lines of a TMU's cache
  localparam int RowBits = ptm_front_pkg::RowBits,
  localparam int TakenW  = ptm_front_pkg::TakenW,
  localparam int ReadsW  = ptm_front_pkg::ReadsW
) (
  input  logic                clk_i,
  input  logic                rst_ni,
  input  logic                valid_i,
  output logic                ready_o,
  input  ptm_unit_pkg::beat_t beat_i,
  input  logic [2*TakenW-1:0] taken_i,  // of the map, of the colour texture
  input  logic [Tmus*ReadsW-1:0] reads_i,
  // Miss ring
  output logic [Tmus-1:0]     rank_o,
  input  logic                usable_i,
  output logic                commit_o,
  output logic                release_o,
  output logic [Tmus*RowBits-1:0] row_o,  // where the rank's lines go
  // F
  output logic                valid_o,
  input  logic                ready_i,
  output ptm_unit_pkg::beat_t beat_o,
  output logic [2*TakenW-1:0] taken_o,
  output logic [Tmus*ReadsW-1:0] reads_o,
  output logic                holds_o          // a beat stands here
);
  logic                k_load, leaves;
  ptm_unit_pkg::beat_t beat_q;
  ptm_front_pkg::taken_t map_q, color_q;
  ptm_stream_reg u_k (
    .clk_i(clk_i), .rst_ni(rst_ni), .valid_i(valid_i), .ready_o(ready_o), .load_o(k_load),
    .valid_o(holds_o), .ready_i(leaves)
  );
  always_ff @(posedge clk_i) begin
    if (k_load) begin
      beat_q           <= beat_i;
      {color_q, map_q} <= taken_i;
    end
  end
  assign taken_o = {color_q, map_q};

  logic [Tmus-1:0] more;
  for (genvar t = 0; t < Tmus; t++) begin : gen_tmu
    ptm_front_tmu_commit #(
      .Rows(Rows)
    ) u_tmu (
      .clk_i(clk_i), .load_i(k_load), .reads_i(reads_i[t*ReadsW +: ReadsW]), .valid_i(holds_o),
      .map_i(map_q), .color_i(color_q), .commit_i(commit_o), .line_o(rank_o[t]),
      .row_o(row_o[t*RowBits +: RowBits]), .more_o(more[t]), .reads_o(reads_o[t*ReadsW +: ReadsW])
    );
  end

  logic last_rank;
  assign last_rank = more == '0;
  assign valid_o   = holds_o && usable_i && last_rank;
  assign leaves    = valid_o && ready_i;
  assign commit_o  = holds_o && usable_i && ready_i;
  assign release_o = leaves;
  assign beat_o    = beat_q;
endmodule
