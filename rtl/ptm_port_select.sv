// The word that one of Ports read ports brought. Combinational.
module ptm_port_select #(
  parameter int Ports = 4,  // 1, 2, 4
  parameter int Width = 24
) (
  input  logic [Ports*Width-1:0] data_i,
  input  logic [1:0]             port_i,
  output logic [Width-1:0]       data_o
);
  always_comb begin
    data_o = data_i[0 +: Width];
    for (int p = 1; p < Ports; p++) begin
      if (port_i == 2'(p)) data_o = data_i[p*Width +: Width];
    end
  end
endmodule
