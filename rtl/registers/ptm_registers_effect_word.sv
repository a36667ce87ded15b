// What stands at an address of the registers that effects add, 0 where nothing does:
// docs/spec/effects.md, Registers. Tables cannot be read. Combinational.
module ptm_registers_effect_word #(
  localparam int Draws   = ptm_register_pkg::Draws,
  localparam int EffectW = ptm_register_pkg::EffectW
) (
  input  logic [Draws*EffectW-1:0] effects_i,  // effect_t, draw 0 lowest
  input  logic [15:0]              addr_i,
  output logic [31:0]              data_o
);
  localparam int DrawAt   = $clog2(ptm_register_pkg::DrawSize);
  localparam int DrawStep = $clog2(ptm_register_pkg::DrawStride);  // of one draw's registers
  localparam int SetAt    = $clog2(ptm_register_pkg::SetSize);
  localparam int SetStep  = $clog2(ptm_register_pkg::SetStride);
  localparam logic [15:0] DrawBlock = ptm_register_pkg::DrawBlock;
  localparam logic [15:0] SetBlock  = ptm_register_pkg::SetBlock;

  always_comb begin
    data_o = '0;
    if (addr_i[15:DrawAt] == DrawBlock[15:DrawAt]) begin
      for (int d = 0; d < Draws; d++) begin
        if (addr_i[DrawAt-1:DrawStep] == 2'(d)) begin
          case (addr_i[DrawStep-1:0])
            `include "contract/ptm_draw_effect_read.svh"
            default: ;
          endcase
        end
      end
    end else if (addr_i[15:SetAt] == SetBlock[15:SetAt]) begin
      for (int d = 0; d < Draws; d++) begin
        if (addr_i[SetAt-1:SetStep] == 2'(d)) begin
          case (addr_i[SetStep-1:0])
            `include "contract/ptm_set_effect_read.svh"
            default: ;
          endcase
        end
      end
    end
  end
endmodule
