# For scripts/synthesize: the shortest clock period at which no register's path is late, without
# wire loads. A period is a path's arrival and the setup time of the register at its end.
read_liberty @LIBERTY@
read_verilog @NETLIST@
link_design @TOP@
set period 100.0
source @SDC@
set registers [all_registers -clock_pins]
report_checks -path_delay max -from $registers -to [all_registers -data_pins] -format full
set path [lindex [find_timing_paths -path_delay max -from $registers -to [all_registers -data_pins]] 0]
puts "shortest period [expr { $period - [get_property $path slack] }]"
