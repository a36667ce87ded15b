// The fragment FIFO: beats between T and K, long enough to hide the memory's latency. One memory
// for all that belongs to a beat.
//
// Latency 1; full at the start of a cycle, it accepts nothing (T6). docs/spec/unit-timing.md.
module ptm_front_beat_fifo #(
  parameter int Tmus  = 3,
  parameter int Depth = 192,  // 4..1024
  localparam int TakenW = ptm_front_pkg::TakenW,
  localparam int ReadsW = ptm_front_pkg::ReadsW
) (
  input  logic                clk_i,
  input  logic                rst_ni,
  input  logic                valid_i,
  output logic                ready_o,
  input  ptm_unit_pkg::beat_t beat_i,
  input  logic [2*TakenW-1:0]    taken_i,  // of both textures
  input  logic [Tmus*ReadsW-1:0] reads_i,
  output logic                valid_o,
  input  logic                ready_i,
  output ptm_unit_pkg::beat_t beat_o,
  output logic [2*TakenW-1:0]    taken_o,
  output logic [Tmus*ReadsW-1:0] reads_o
);
  ptm_memory_fifo #(
    .Depth(Depth), .Width(ptm_unit_pkg::BeatW + 2 * TakenW + Tmus * ReadsW)
  ) u_fifo (
    .clk_i(clk_i), .rst_ni(rst_ni), .valid_i(valid_i), .ready_o(ready_o),
    .data_i({beat_i, taken_i, reads_i}), .valid_o(valid_o), .ready_i(ready_i),
    .data_o({beat_o, taken_o, reads_o})
  );
endmodule
