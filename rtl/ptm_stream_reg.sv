// One pipeline register of a valid/ready stream (docs/spec/handshake.md).
//
// Accepts when it is empty or being emptied, so a chain of them moves one item a cycle, and a
// bubble closes up while the end is blocked. ready_o is combinational from ready_i: a chain's ready
// runs through all of it, which is cheap (one AND-OR a stage) as long as the chain ends in a
// ptm_stream_fifo2. Latency 1. The payload is not reset; valid_o qualifies it.
`include "ptm_assert.svh"
module ptm_stream_reg #(
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
  logic valid_q;
  logic [Width-1:0] data_q;

  assign ready_o = !valid_q || ready_i;
  assign valid_o = valid_q;
  assign data_o  = data_q;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) valid_q <= 1'b0;
    else if (ready_o) valid_q <= valid_i;
  end

  always_ff @(posedge clk_i) begin
    if (valid_i && ready_o) data_q <= data_i;
  end

  `PTM_ASSERT(HoldUnderStall_A, valid_o && !ready_i |=> valid_o && $stable(data_o))
endmodule
