// The control of a stream FIFO of two registers (docs/spec/handshake.md).
//
// Latency 1. Full at the start of a cycle, it accepts nothing, even if it is being emptied: ready_o
// depends on registers alone, so no path leads from ready_i to ready_o, and two places are what
// full throughput then takes. As with ptm_stream_chain the payload lies with the owner, a head and
// a tail register a field; the head is what valid_o offers.
//
//   always_ff @(posedge clk_i) begin
//     if (load_head_o) head_q <= data; else if (advance_o) head_q <= tail_q;
//     if (load_tail_o) tail_q <= data;
//   end
`include "ptm_assert.svh"
module ptm_stream_fifo2 (
  input  logic clk_i,
  input  logic rst_ni,
  input  logic valid_i,
  output logic ready_o,
  output logic load_head_o,
  output logic load_tail_o,
  output logic advance_o,   // the head takes over the tail
  output logic valid_o,
  input  logic ready_i
);
  logic head_valid_q, tail_valid_q;  // the tail holds an item only behind the head's

  logic push, pop;
  assign ready_o = !tail_valid_q;
  assign valid_o = head_valid_q;
  assign push    = valid_i && ready_o;
  assign pop     = head_valid_q && ready_i;

  // An item goes to the head if that is free after this cycle's pop. While the tail holds one,
  // nothing is pushed.
  assign load_head_o = push && (!head_valid_q || pop);
  assign load_tail_o = push && !load_head_o;
  assign advance_o   = pop && tail_valid_q;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      head_valid_q <= 1'b0;
      tail_valid_q <= 1'b0;
    end else begin
      head_valid_q <= load_head_o || advance_o || (head_valid_q && !pop);
      tail_valid_q <= load_tail_o || (tail_valid_q && !pop);
    end
  end

  `PTM_ASSERT(HoldUnderStall_A, valid_o && !ready_i |=> valid_o)
  `PTM_ASSERT(NoLoadUnderStall_A, valid_o && !ready_i |-> !load_head_o && !advance_o)
  `PTM_ASSERT(TailBehindHead_A, !tail_valid_q || head_valid_q)
endmodule
