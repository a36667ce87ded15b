// The fragment FIFO: beats between T and K, long enough to hide the memory's latency.
//
// Latency 1; full at the start of a cycle, it accepts nothing (T6). docs/spec/unit-timing.md.
`include "ptm_assert.svh"
module ptm_unit_beat_fifo #(
  parameter int Tmus  = 3,
  parameter int Depth = 192,  // 4..1024
  localparam int TakenW = ptm_unit_front_pkg::TakenW,
  localparam int ReadsW = ptm_unit_front_pkg::ReadsW
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
  localparam int PlaceBits = $clog2(Depth);
  localparam int CountBits = $clog2(Depth + 1);

  localparam int BeatW = ptm_unit_pkg::BeatW;
  logic [BeatW-1:0]     beat_q [Depth];
  logic [2*TakenW-1:0]  taken_q [Depth];
  logic [PlaceBits-1:0] write_q, read_q;
  logic [CountBits-1:0] count_q;

  logic push, pop;
  assign ready_o = count_q != CountBits'(Depth);
  assign valid_o = count_q != '0;
  assign push    = valid_i && ready_o;
  assign pop     = valid_o && ready_i;
  assign beat_o  = beat_q[read_q];
  assign taken_o = taken_q[read_q];
  always_ff @(posedge clk_i) begin
    if (push) begin
      beat_q[write_q]  <= beat_i;
      taken_q[write_q] <= taken_i;
    end
  end
  for (genvar t = 0; t < Tmus; t++) begin : gen_tmu
    logic [ReadsW-1:0] reads_q [Depth];
    always_ff @(posedge clk_i) if (push) reads_q[write_q] <= reads_i[t*ReadsW +: ReadsW];
    assign reads_o[t*ReadsW +: ReadsW] = reads_q[read_q];
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      write_q <= '0;
      read_q  <= '0;
      count_q <= '0;
    end else begin
      if (push) write_q <= write_q == PlaceBits'(Depth - 1) ? '0 : write_q + 1'b1;
      if (pop) read_q <= read_q == PlaceBits'(Depth - 1) ? '0 : read_q + 1'b1;
      count_q <= count_q + CountBits'(push) - CountBits'(pop);
    end
  end

  `PTM_ASSERT(HoldUnderStall_A, valid_o && !ready_i |=> valid_o)
endmodule
