// Half-vectors of the fragments that are inside: they keep their order from the unit's input to O,
// so they wait here instead of travelling through every register.    docs/spec/effects.md, Fragment
//
// Depth is the most fragments that A0 to O hold; while they hold as many, none is accepted, so it
// is never too full to take one. A fragment pushed in cycle c is in O many cycles later.
`include "ptm_assert.svh"
module ptm_back_half_vector_fifo #(
  parameter int Depth = 206,  // 2 or more
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
  logic ready, valid;
  ptm_memory_fifo #(.Depth(Depth), .Width(2 * Width)) u_fifo (
    .clk_i(clk_i), .rst_ni(rst_ni), .valid_i(push_i), .ready_o(ready), .data_i({hv_i, hu_i}),
    .valid_o(valid), .ready_i(pop_i), .data_o({hv_o, hu_o})
  );

  `PTM_ASSERT(NeverTooFull_A, !push_i || ready)
  `PTM_ASSERT(HoldsWhatLeaves_A, !pop_i || valid)

  logic unused;
  assign unused = ready ^ valid;
endmodule
