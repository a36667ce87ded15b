# Constraints of ptm_evaluator as a block of its own: one clock, and half a period for what stands
# before its inputs and behind its outputs. Set `period` (ns) before reading this file.
if { ![info exists period] } { set period 5.0 }
create_clock -name clk -period $period [get_ports clk_i]
set data_in [all_inputs -no_clocks]
set_input_delay [expr { $period / 2 }] -clock clk $data_in
set_output_delay [expr { $period / 2 }] -clock clk [all_outputs]
# The reset is asserted at any time and released in step with the clock by whoever drives it.
set_false_path -from [get_ports rst_ni]
