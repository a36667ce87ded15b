// What the back of the unit needs of one draw's descriptor (docs/spec/unit.md, Draw descriptor).
//
// Descriptors stand still while fragments are inside, so each place that needs a field looks it up
// by the draw's number instead of carrying it along. Combinational.
module ptm_registers_draw_select (
  input  logic [ptm_unit_pkg::Draws*ptm_unit_pkg::DrawW-1:0] draws_i,
  input  logic [ptm_unit_pkg::DrawBits-1:0]                  draw_i,
  output logic [2:0]                       format_o,
  output logic                             bilinear_o,
  output logic                             color_o,
  output logic [1:0]                       palette_o,
  output logic [6*12-1:0]                  bias_o,   // a0's lowest
  output logic [6*ptm_pkg::ShiftBits-1:0]  shift_o,
  output logic [2:0]                       combine_o,
  output logic [8:0]                       ka_o,
  output logic [8:0]                       kd_o
);
  // A struct a draw: Yosys 0.23 knows no array of them.
  ptm_unit_pkg::draw_t draw0, draw1, draw2, draw3;
  assign draw0 = draws_i[0*ptm_unit_pkg::DrawW +: ptm_unit_pkg::DrawW];
  assign draw1 = draws_i[1*ptm_unit_pkg::DrawW +: ptm_unit_pkg::DrawW];
  assign draw2 = draws_i[2*ptm_unit_pkg::DrawW +: ptm_unit_pkg::DrawW];
  assign draw3 = draws_i[3*ptm_unit_pkg::DrawW +: ptm_unit_pkg::DrawW];

  always_comb begin
    unique case (draw_i)
      2'd0: begin
        {format_o, bilinear_o, color_o} = {draw0.format, draw0.bilinear, draw0.color};
        {palette_o, combine_o}          = {draw0.palette, draw0.combine};
        {ka_o, kd_o}                    = {draw0.ka, draw0.kd};
        bias_o                          = draw0.bias;
        shift_o                         = draw0.shift;
      end
      2'd1: begin
        {format_o, bilinear_o, color_o} = {draw1.format, draw1.bilinear, draw1.color};
        {palette_o, combine_o}          = {draw1.palette, draw1.combine};
        {ka_o, kd_o}                    = {draw1.ka, draw1.kd};
        bias_o                          = draw1.bias;
        shift_o                         = draw1.shift;
      end
      2'd2: begin
        {format_o, bilinear_o, color_o} = {draw2.format, draw2.bilinear, draw2.color};
        {palette_o, combine_o}          = {draw2.palette, draw2.combine};
        {ka_o, kd_o}                    = {draw2.ka, draw2.kd};
        bias_o                          = draw2.bias;
        shift_o                         = draw2.shift;
      end
      default: begin
        {format_o, bilinear_o, color_o} = {draw3.format, draw3.bilinear, draw3.color};
        {palette_o, combine_o}          = {draw3.palette, draw3.combine};
        {ka_o, kd_o}                    = {draw3.ka, draw3.kd};
        bias_o                          = draw3.bias;
        shift_o                         = draw3.shift;
      end
    endcase
  end
endmodule
