// What stands at an address of the draws' registers, 0 where nothing does: docs/spec/unit.md,
// Registers. What effects add is ptm_registers_effect_word's. Combinational; 0 while read_i is low,
// which spares the Verilated unit the choice in all cycles without a read.
module ptm_registers_draw_word #(
  localparam int Draws = ptm_register_pkg::Draws,
  localparam int DrawW = ptm_register_pkg::DrawW
) (
  input  logic [Draws*DrawW-1:0] draws_i,  // draw_t, draw 0 lowest
  input  logic                   read_i,
  input  logic [7:0]             addr_i,
  output logic [31:0]            data_o
);
  localparam int DrawStep = $clog2(ptm_register_pkg::DrawStride);  // of one draw's registers

  always_comb begin
    data_o = '0;
    if (read_i) begin
      for (int d = 0; d < Draws; d++) begin
        if (addr_i[7:6] == 2'(d)) begin
          case (addr_i[DrawStep-1:0])
            `include "contract/ptm_draw_read.svh"
            default: ;
          endcase
        end
      end
    end
  end
endmodule
