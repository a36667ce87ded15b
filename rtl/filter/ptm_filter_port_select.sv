// The word that one of a palette's read ports brought for a tap (ptm_filter_palette_schedule).
// Combinational.
module ptm_filter_port_select #(
  parameter int Ports = 4,  // 1, 2, 4
  parameter int Width = 24,
  parameter int Tap   = 0
) (
  input  logic [Ports*Width-1:0] data_i,
  input  logic [1:0]             port_i,
  output logic [Width-1:0]       data_o
);
  if (Ports == 2) begin : gen_either
    assign data_o = port_i[0] ? data_i[Width +: Width] : data_i[0 +: Width];
  end else begin : gen_own
    assign data_o = data_i[(Tap%Ports)*Width +: Width];
  end
  logic unused;
  assign unused = ^port_i;
endmodule
