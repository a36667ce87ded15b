// One of four values, by the number of a draw. (An index times a width is a multiply to Yosys.)
// Combinational.
module ptm_registers_by_draw #(
  parameter int Width = 1
) (
  input  logic [ptm_unit_pkg::Draws*Width-1:0]  values_i,  // draw 0's lowest
  input  logic [ptm_unit_pkg::DrawBits-1:0]     draw_i,
  output logic [Width-1:0]                      value_o
);
  always_comb begin
    unique case (draw_i)
      2'd0:    value_o = values_i[0*Width +: Width];
      2'd1:    value_o = values_i[1*Width +: Width];
      2'd2:    value_o = values_i[2*Width +: Width];
      default: value_o = values_i[3*Width +: Width];
    endcase
  end
endmodule
