// Half-vectors of the fragments that are inside: they keep their order from the unit's input to O,
// so they wait here instead of travelling through every register.    docs/spec/effects.md, Fragment
//
// Depth is the most fragments that A0 to O hold, so it is never too full to take one.
`include "ptm_assert.svh"
module ptm_half_fifo #(
  parameter int Depth = 205,  // 2 or more
  parameter int Width = 10    // of a light code
) (
  input  logic                    clk_i,
  input  logic                    rst_ni,
  input  logic                    push_i,
  input  logic signed [Width-1:0] hu_i,
  input  logic signed [Width-1:0] hv_i,
  input  logic                    pop_i,
  output logic signed [Width-1:0] hu_o,   // the oldest's
  output logic signed [Width-1:0] hv_o
);
  localparam int PlaceBits = $clog2(Depth);
  logic [2*Width-1:0]   half_q [Depth];
  logic [PlaceBits-1:0] write_q, read_q;
  assign {hv_o, hu_o} = half_q[read_q];
  always_ff @(posedge clk_i) begin
    if (push_i) half_q[write_q] <= {hv_i, hu_i};
  end
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      write_q <= '0;
      read_q  <= '0;
    end else begin
      if (push_i) write_q <= write_q == PlaceBits'(Depth - 1) ? '0 : write_q + 1'b1;
      if (pop_i) read_q <= read_q == PlaceBits'(Depth - 1) ? '0 : read_q + 1'b1;
    end
  end

`ifndef YOSYS
  int count_q;
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) count_q <= 0;
    else count_q <= count_q + 32'(push_i) - 32'(pop_i);
  end
`endif
  `PTM_ASSERT(NeverTooFull_A, !push_i || pop_i || count_q < Depth)
  `PTM_ASSERT(HoldsWhatLeaves_A, !pop_i || count_q > 0)
endmodule
