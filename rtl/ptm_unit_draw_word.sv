// What stands at an address of the draws' registers, 0 where nothing does: docs/spec/unit.md,
// Registers. What effects add is ptm_effect_registers'. Combinational; 0 while read_i is low, which
// spares the Verilated unit the choice in all cycles without a read.
module ptm_unit_draw_word #(
  localparam int Draws = ptm_unit_pkg::Draws,
  localparam int DrawW = ptm_unit_pkg::DrawW
) (
  input  logic [Draws*DrawW-1:0] draws_i,  // draw_t, draw 0 lowest
  input  logic                   read_i,
  input  logic [7:0]             addr_i,
  output logic [31:0]            data_o
);
  localparam int LineW = ptm_unit_pkg::LineBits, SideW = ptm_unit_pkg::SideBits;
  localparam int Map = ptm_unit_pkg::DrawMapAt, Color = ptm_unit_pkg::DrawColorAt;

  always_comb begin
    data_o = '0;
    if (read_i) begin
      for (int d = 0; d < Draws; d++) begin
        if (addr_i[7:6] == 2'(d)) begin
          case (addr_i[5:0])
            6'd0: begin
              data_o[2:0]   = draws_i[d*DrawW+ptm_unit_pkg::DrawFormatAt +: 3];
              data_o[4:3]   = draws_i[d*DrawW+ptm_unit_pkg::DrawMipAt +: 2];
              data_o[5]     = draws_i[d*DrawW+ptm_unit_pkg::DrawBilinearAt];
              data_o[7:6]   = draws_i[d*DrawW+ptm_unit_pkg::DrawWrapUAt +: 2];
              data_o[9:8]   = draws_i[d*DrawW+ptm_unit_pkg::DrawWrapVAt +: 2];
              data_o[12:10] = draws_i[d*DrawW+ptm_unit_pkg::DrawCombineAt +: 3];
              data_o[13]    = draws_i[d*DrawW+ptm_unit_pkg::DrawHasColorAt];
              data_o[15:14] = draws_i[d*DrawW+ptm_unit_pkg::DrawPaletteAt +: 2];
            end
            6'd1: begin
              data_o[0 +: SideW]  = draws_i[d*DrawW+Map+ptm_unit_pkg::WidthAt +: SideW];
              data_o[16 +: SideW] = draws_i[d*DrawW+Map+ptm_unit_pkg::HeightAt +: SideW];
            end
            6'd2: begin
              data_o[0 +: SideW]  = draws_i[d*DrawW+Color+ptm_unit_pkg::WidthAt +: SideW];
              data_o[16 +: SideW] = draws_i[d*DrawW+Color+ptm_unit_pkg::HeightAt +: SideW];
            end
            6'd3: begin
              data_o[3:0]   = draws_i[d*DrawW+Map+ptm_unit_pkg::LevelsAt +: 4];
              data_o[11:8]  = draws_i[d*DrawW+Color+ptm_unit_pkg::LevelsAt +: 4];
              data_o[28:16] = draws_i[d*DrawW+ptm_unit_pkg::DrawLodAt +: 13];
            end
            6'd10: begin
              data_o[8:0]   = draws_i[d*DrawW+ptm_unit_pkg::DrawKaAt +: 9];
              data_o[17:9]  = draws_i[d*DrawW+ptm_unit_pkg::DrawKdAt +: 9];
              data_o[26:18] = draws_i[d*DrawW+ptm_unit_pkg::DrawKsAt +: 9];
            end
            default: ;
          endcase
          for (int i = 0; i < 6; i++) begin
            if (addr_i[5:0] == 6'(4 + i)) begin
              data_o[11:0]  = draws_i[d*DrawW+ptm_unit_pkg::DrawBiasAt+12*i +: 12];
              data_o[20:16] = draws_i[d*DrawW+ptm_unit_pkg::DrawShiftAt+5*i +: 5];
            end
          end
          for (int l = 0; l < ptm_unit_pkg::LevelsMax; l++) begin
            if (addr_i[5:0] == 6'(16 + l)) begin
              data_o[LineW-1:0] = draws_i[d*DrawW+Map+LineW*l +: LineW];
            end
            if (addr_i[5:0] == 6'(32 + l)) begin
              data_o[LineW-1:0] = draws_i[d*DrawW+Color+LineW*l +: LineW];
            end
          end
        end
      end
    end
  end
endmodule
