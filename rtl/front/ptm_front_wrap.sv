// U3, one direction: a coordinate into the texture.
//
//   repeat  the fraction                                           docs/spec/unit.md, U3
//   mirror  the fraction, inverted where bit 20 is set
//   clamp   limited to 0 .. 2^20 - 1
//
// Twin: ptm::reference::wrap_coordinate() in model/reference/unit/coordinate.h. Combinational.
module ptm_front_wrap #(
  localparam int InBits = 34
) (
  input  logic [1:0]               wrap_i,
  input  logic signed [InBits-1:0] u_i,  // 20 fraction bits
  output logic [19:0]              u_o   // Q0.20
);
  logic in_range;
  assign in_range = u_i[InBits-1:20] == '0;

  always_comb begin
    u_o = u_i[19:0];
    if (wrap_i == ptm_unit_pkg::WrapMirror) u_o = u_i[19:0] ^ {20{u_i[20]}};
    if (wrap_i == ptm_unit_pkg::WrapClamp && !in_range) u_o = u_i[InBits-1] ? '0 : '1;
  end
endmodule
