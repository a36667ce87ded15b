// Assertions that vanish where they do not parse (Yosys 0.23, Icarus Verilog 11) and cost nothing
// unless asked for (`verilator --assert`). They need clk_i and rst_ni in scope.
`ifndef PTM_ASSERT_SVH
`define PTM_ASSERT_SVH

`ifdef YOSYS
`define PTM_ASSERT(name, property_expr)
`elsif __ICARUS__
`define PTM_ASSERT(name, property_expr)
`else
// The property holds in every cycle outside reset.
`define PTM_ASSERT(name, property_expr) \
  name: assert property (@(posedge clk_i) disable iff (!rst_ni) (property_expr)) \
  else $error("%m: violated");
`endif

// A requirement on parameters. Where it does not hold, elaboration stops in every tool, because a
// module is missing; its name, `fault`, says what is wrong. ($error is no help: Verilator only
// prints it when the simulation starts, and Yosys does not know it.)
`define PTM_REQUIRE(fault, condition) \
  if (!(condition)) begin : gen_``fault \
    fault u_fault (); \
  end

`endif
