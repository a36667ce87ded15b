// A stream FIFO of two registers (docs/spec/handshake.md).
//
// Latency 1. Full at the start of a cycle, it accepts nothing, even if it is being emptied: ready_o
// depends on the registered count alone, so no path leads from ready_i to ready_o, and two places
// are what full throughput then takes. The payload is not reset; valid_o qualifies it.
`include "ptm_assert.svh"
module ptm_stream_fifo2 #(
  parameter int Width = 8
) (
  input  logic             clk_i,
  input  logic             rst_ni,
  input  logic             valid_i,
  output logic             ready_o,
  input  logic [Width-1:0] data_i,
  output logic             valid_o,
  input  logic             ready_i,
  output logic [Width-1:0] data_o
);
  logic head_valid_q, tail_valid_q;  // the tail holds an item only behind the head's
  logic [Width-1:0] head_q, tail_q;

  logic push, pop;
  assign ready_o = !tail_valid_q;
  assign valid_o = head_valid_q;
  assign data_o  = head_q;
  assign push    = valid_i && ready_o;
  assign pop     = valid_o && ready_i;

  // Where an item goes: to the head if the head is free after this cycle's pop, else to the tail.
  logic push_head;
  assign push_head = push && (!head_valid_q || pop);

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      head_valid_q <= 1'b0;
      tail_valid_q <= 1'b0;
    end else begin
      head_valid_q <= push || tail_valid_q || (head_valid_q && !pop);
      tail_valid_q <= pop ? 1'b0 : tail_valid_q || (push && head_valid_q);
    end
  end

  always_ff @(posedge clk_i) begin
    if (push_head) head_q <= data_i;
    else if (pop) head_q <= tail_q;
    if (push && !push_head) tail_q <= data_i;
  end

  `PTM_ASSERT(HoldUnderStall_A, valid_o && !ready_i |=> valid_o && $stable(data_o))
  `PTM_ASSERT(TailBehindHead_A, !tail_valid_q || head_valid_q)
endmodule
