# Constraints of ptm_unit as a block of its own: one clock, and half a period for what stands before
# its inputs and behind its outputs. Set `period` (ns) before reading this file.
if { ![info exists period] } { set period 5.0 }
create_clock -name clk -period $period [get_ports clk_i]
set_input_delay [expr { $period / 2 }] -clock clk [all_inputs -no_clocks]
set_output_delay [expr { $period / 2 }] -clock clk [all_outputs]
# Both resets are asserted at any time and released in step with the clock by whoever drives them;
# where the memory outlives a reset of the unit, rst_ni falls in step with the clock too.
set_false_path -from [get_ports { rst_ni mem_rst_ni }]
