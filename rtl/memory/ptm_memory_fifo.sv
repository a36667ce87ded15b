// A stream FIFO whose items lie in a ptm_memory_ram (docs/spec/handshake.md).
//
// Latency 1: what is pushed into an empty FIFO in cycle c is offered in c + 1. An item a cycle goes
// in and another out. Full at the start of a cycle, it accepts nothing, even if it is being
// emptied: ready_o and valid_o depend on registers alone. data_o is the oldest item's while valid_o
// is high, and anything otherwise. After a reset it is empty; items are not reset.
//
// The memory answers a cycle after it is asked, so it is asked for the item behind the oldest one
// as that leaves, and its output keeps what it read until the next leaves. What is pushed where
// nothing is left behind it would be written and read in one cycle: it goes past the memory, into
// bypass_q.
`include "ptm_assert.svh"
module ptm_memory_fifo #(
  parameter int Depth = 192,  // 2 or more
  parameter int Width = 32
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
  localparam int PlaceBits = $clog2(Depth);
  localparam int CountBits = $clog2(Depth + 1);
  localparam logic [PlaceBits-1:0] Last = PlaceBits'(Depth - 1);

  // The place of the next item that is pushed, and of the item behind the oldest
  logic [PlaceBits-1:0] write_q, next_q;
  logic [CountBits-1:0] count_q;
  logic                 bypassed_q;  // the oldest item is bypass_q
  logic [Width-1:0]     bypass_q, stored;

  logic push, pop, oldest, read;
  assign ready_o = count_q != CountBits'(Depth);
  assign valid_o = count_q != '0;
  assign push    = valid_i && ready_o;
  assign pop     = valid_o && ready_i;
  // What is pushed is the oldest at the end of this cycle; what is behind the oldest is.
  assign oldest  = push && (count_q == '0 || (pop && count_q == CountBits'(1)));
  assign read    = pop && count_q > CountBits'(1);

  ptm_memory_ram #(.Depth(Depth), .Width(Width)) u_ram (
    .clk_i(clk_i), .write_i(push && !oldest), .write_address_i(write_q), .write_data_i(data_i),
    .read_i(read), .read_address_i(next_q), .read_data_o(stored)
  );
  always_ff @(posedge clk_i) if (oldest) bypass_q <= data_i;
  assign data_o = bypassed_q ? bypass_q : stored;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      write_q    <= '0;
      next_q     <= PlaceBits'(1);
      count_q    <= '0;
      bypassed_q <= 1'b0;
    end else begin
      if (push) write_q <= write_q == Last ? '0 : write_q + 1'b1;
      if (pop) next_q <= next_q == Last ? '0 : next_q + 1'b1;
      if (push != pop) count_q <= push ? count_q + 1'b1 : count_q - 1'b1;
      if (oldest || read) bypassed_q <= oldest;
    end
  end

  `PTM_ASSERT(HoldUnderStall_A, valid_o && !ready_i |=> valid_o)
  `PTM_ASSERT(NeverReadsWhatIsBeingWritten_A, !(read && push && write_q == next_q))
endmodule
