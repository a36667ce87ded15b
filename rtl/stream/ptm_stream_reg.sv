// The handshake of one pipeline register of a valid/ready stream (docs/spec/handshake.md).
//
// Accepts when it is empty or being emptied, so a chain of them moves one item a cycle, and a
// bubble closes up while the end is blocked. ready_o is combinational from ready_i: a chain's ready
// runs through all of it, which is cheap (one AND-OR a stage) as long as the chain ends in a
// ptm_stream_fifo2. Latency 1.
//
// The payload lies with the owner, one register a field, loaded at the edge where load_o is high;
// valid_o qualifies it, so it needs no reset. (Fields keep their names in waveforms, and packed
// into one vector the Verilated evaluator ran at half the speed.)
`include "ptm_assert.svh"
module ptm_stream_reg (
  input  logic clk_i,
  input  logic rst_ni,
  input  logic valid_i,
  output logic ready_o,
  output logic load_o,  // a transfer happens: the payload is to be taken over
  output logic valid_o,
  input  logic ready_i
);
  logic valid_q;

  assign ready_o = !valid_q || ready_i;
  assign load_o  = valid_i && ready_o;
  assign valid_o = valid_q;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) valid_q <= 1'b0;
    else if (ready_o) valid_q <= valid_i;
  end

  `PTM_ASSERT(NoLoadUnderStall_A, valid_o && !ready_i |-> !load_o)
  `PTM_ASSERT(HoldUnderStall_A, valid_o && !ready_i |=> valid_o)
endmodule
