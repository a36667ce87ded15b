// Assertions that vanish where they do not parse (Yosys 0.23) and cost nothing unless asked for
// (`verilator --assert`). They need clk_i and rst_ni in scope.
`ifndef PTM_ASSERT_SVH
`define PTM_ASSERT_SVH

`ifdef YOSYS
`define PTM_ASSERT(name, property_expr)
`define PTM_ASSERT_INIT(name, condition)
`else
// The property holds in every cycle outside reset.
`define PTM_ASSERT(name, property_expr) \
  name: assert property (@(posedge clk_i) disable iff (!rst_ni) (property_expr)) \
  else $error("%m: violated");
// A requirement on parameters.
`define PTM_ASSERT_INIT(name, condition) \
  initial begin : name \
    if (!(condition)) $error("%m: violated"); \
  end
`endif

`endif
