// The handshake of pipeline registers in a row on a valid/ready stream (docs/spec/handshake.md).
//
// A register accepts when it is empty or being emptied, so the chain moves one item a cycle, and a
// bubble closes up while the end is blocked: a register stalls if it and all registers behind it
// are full and the end refuses. From the end, a stall runs through full registers as the carry of
// + 1 runs through ones, and here it is one: what `valid_q + 1` clears, stalls. ready_o is thereby
// combinational from ready_i, which is cheap as long as the chain ends in a ptm_stream_fifo2.
// Latency Stages.
//
// The payload lies with the owner, one register a field, loaded at the edge where the stage's bit
// of load_o is high; valid_o qualifies the last stage's, so it needs no reset. (Fields keep their
// names in waveforms, and packed into one vector the Verilated evaluator ran at half the speed.)
`include "ptm_assert.svh"
module ptm_stream_chain #(
  parameter int Stages = 7  // 2 or more
) (
  input  logic            clk_i,
  input  logic            rst_ni,
  input  logic            valid_i,
  output logic            ready_o,
  output logic [1:Stages] load_o,  // stage n takes its payload over; 1 is the first
  output logic            valid_o,
  input  logic            ready_i
);
  // The last stage is the lowest bit, where the carry starts.
  logic [1:Stages] valid_q, stalled;
  assign stalled = valid_q & ~(valid_q + Stages'(!ready_i));
  assign load_o  = {valid_i, valid_q[1:Stages-1]} & ~stalled;
  assign ready_o = !stalled[1];
  assign valid_o = valid_q[Stages];

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) valid_q <= '0;
    else valid_q <= load_o | stalled;
  end

  `PTM_ASSERT(NoLoadUnderStall_A, valid_o && !ready_i |-> !load_o[Stages])
  `PTM_ASSERT(HoldUnderStall_A, valid_o && !ready_i |=> valid_o)
endmodule
