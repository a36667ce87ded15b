// What effects add to the draws' registers: docs/spec/effects.md, Registers. A part that is not
// built in is 0. Written, like the rest, while the unit is idle and before the draw's control.
// reg_rdata_o is what stands at the address, 0 if nothing does; tables cannot be read.
//
// One vector that only writes touch, as in ptm_registers.
module ptm_registers_effects #(
  parameter int ExtraSets   = 0,  // 0..4
  parameter int ExtraPasses = 0,  // 0..4
  parameter int Stages      = 0,  // mask
  localparam int Draws   = ptm_register_pkg::Draws,
  localparam int EffectW = ptm_register_pkg::EffectW
) (
  input  logic                     clk_i,
  input  logic                     rst_ni,
  input  logic                     reg_we_i,
  input  logic [15:0]              reg_addr_i,
  input  logic [31:0]              reg_wdata_i,
  output logic [31:0]              reg_rdata_o,
  output logic [Draws*EffectW-1:0] effects_o,   // effect_t, draw 0 lowest
  output logic                     table_we_o,  // address and data are the port's
  output logic [9:0]               table_addr_o,
  output logic [11:0]              table_data_o
);
  localparam int DrawAt   = $clog2(ptm_register_pkg::DrawSize);
  localparam int DrawStep = $clog2(ptm_register_pkg::DrawStride);  // of one draw's registers
  localparam int SetAt    = $clog2(ptm_register_pkg::SetSize);
  localparam int SetStep  = $clog2(ptm_register_pkg::SetStride);
  localparam int TableAt  = $clog2(ptm_register_pkg::TableSize);
  localparam logic [15:0] DrawBlock  = ptm_register_pkg::DrawBlock;
  localparam logic [15:0] SetBlock   = ptm_register_pkg::SetBlock;
  localparam logic [15:0] TableBlock = ptm_register_pkg::TableBlock;

  logic we_draws, we_sets;
  assign we_draws     = reg_we_i && reg_addr_i[15:DrawAt] == DrawBlock[15:DrawAt];
  assign we_sets      = reg_we_i && reg_addr_i[15:SetAt] == SetBlock[15:SetAt];
  assign table_we_o   = reg_we_i && reg_addr_i[15:TableAt] == TableBlock[15:TableAt];
  assign table_addr_o = reg_addr_i[TableAt-1:0];
  assign table_data_o = reg_wdata_i[ptm_register_pkg::TableEntryEntryW-1:0];

  logic [Draws*EffectW-1:0] effects_q;
  assign effects_o = effects_q;
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) effects_q <= '0;
    else if (we_draws || we_sets) begin
      for (int d = 0; d < Draws; d++) begin
        if (we_draws && reg_addr_i[DrawAt-1:DrawStep] == 2'(d)) begin
          case (reg_addr_i[DrawStep-1:0])
            `include "contract/ptm_draw_effect_write.svh"
            default: ;
          endcase
        end
        if (we_sets && reg_addr_i[SetAt-1:SetStep] == 2'(d)) begin
          case (reg_addr_i[SetStep-1:0])
            `include "contract/ptm_set_effect_write.svh"
            default: ;
          endcase
        end
      end
    end
  end

  ptm_registers_effect_word u_word (
    .effects_i(effects_q), .addr_i(reg_addr_i), .data_o(reg_rdata_o)
  );

  logic unused;
  assign unused = ^reg_wdata_i;
endmodule
