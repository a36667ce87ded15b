// An expression that Verilator 5.006 computes wrongly at -O3 unless it is told
// -fno-const-bit-op-tree. x[38] cancels, so the output is 0 for every x. No design logic.
module ptm_xor_tree_tb (
  input  logic [38:0] x_i,
  output logic        differs_o
);
  assign differs_o = (x_i[38] ^ x_i[31] ^ x_i[38]) != x_i[31];
endmodule
