// U11, products: 6 multiplies, two a channel, exact.
//
//   s = P * kp + C * kc                                                docs/spec/unit.md, U11
//
//   none 1, 0 | modulate C, 0 | decal 255 - Ca, Ca | blend kd, ka | add 1, 1 | replace 0, 1
//
// so that the modes differ in factors here and in what ptm_back_combine_scale does with the sum.
// Twin: combine_channel() in model/reference/unit/combine.h. Combinational.
module ptm_back_combine_products (
  input  logic [2:0]      combine_i,
  input  logic [23:0]     lit_i,    // P, red lowest
  input  logic [23:0]     color_i,  // C
  input  logic [7:0]      alpha_i,  // Ca
  input  logic [8:0]      ka_i,
  input  logic [8:0]      kd_i,
  output logic [3*17-1:0] lit_o,    // P * kp, red lowest
  output logic [3*17-1:0] color_o   // C * kc
);
  logic       modulate;
  logic [8:0] kp, kc;
  assign modulate = combine_i == ptm_unit_pkg::CombineModulate;
  always_comb begin
    case (combine_i)
      ptm_unit_pkg::CombineDecal:   {kp, kc} = {9'd255 - {1'b0, alpha_i}, 1'b0, alpha_i};
      ptm_unit_pkg::CombineBlend:   {kp, kc} = {kd_i, ka_i};
      ptm_unit_pkg::CombineAdd:     {kp, kc} = {9'd1, 9'd1};
      ptm_unit_pkg::CombineReplace: {kp, kc} = {9'd0, 9'd1};
      default:                      {kp, kc} = {9'd1, 9'd0};
    endcase
  end
  for (genvar c = 0; c < 3; c++) begin : gen_channel
    logic [7:0] lit, color;
    logic [8:0] factor;
    assign lit    = lit_i[8*c +: 8];
    assign color  = color_i[8*c +: 8];
    assign factor = modulate ? {1'b0, color} : kp;
    assign lit_o[17*c +: 17]   = 17'(lit) * 17'(factor);
    assign color_o[17*c +: 17] = 17'(color) * 17'(kc);
  end
endmodule
