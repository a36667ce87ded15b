// What effects add to the draws' registers: docs/spec/effects.md, Registers. A part that is not
// built in is 0. Written, like the rest, while the unit is idle and before the draw's control.
// reg_rdata_o is what stands at the address, 0 if nothing does; tables cannot be read.
//
// One vector that only writes touch, as in ptm_unit_registers.
module ptm_effect_registers #(
  parameter int ExtraSets   = 0,  // 0..4
  parameter int ExtraPasses = 0,  // 0..4
  parameter int Stages      = 0,  // mask
  localparam int Draws   = ptm_unit_pkg::Draws,
  localparam int EffectW = ptm_unit_pkg::EffectW
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
  localparam int PassesAt = ptm_unit_pkg::EffectPassesAt, PassAt = ptm_unit_pkg::EffectPassAt;
  localparam int SetsAt = ptm_unit_pkg::EffectSetsAt, StagesAt = ptm_unit_pkg::EffectStagesAt;
  localparam int ArgumentAt = ptm_unit_pkg::EffectArgumentAt, BiasAt = ptm_unit_pkg::EffectBiasAt;
  localparam int StagesMax = ptm_unit_pkg::StagesMax, PassesMax = ptm_unit_pkg::PassesMax;

  logic we_draws, we_sets;
  assign we_draws     = reg_we_i && reg_addr_i[15:8] == 8'h00;
  assign we_sets      = reg_we_i && reg_addr_i[15:7] == 9'h050;
  assign table_we_o   = reg_we_i && reg_addr_i[15:10] == 6'h0c;
  assign table_addr_o = reg_addr_i[9:0];
  assign table_data_o = reg_wdata_i[11:0];

  logic [Draws*EffectW-1:0] effects_q;
  assign effects_o = effects_q;
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) effects_q <= '0;
    else if (we_draws || we_sets) begin
      for (int d = 0; d < Draws; d++) begin
        if (we_draws && reg_addr_i[7:6] == 2'(d)) begin
          if (ExtraPasses != 0 && reg_addr_i[5:0] == 6'd12) begin
            effects_q[d*EffectW+PassesAt +: 3] <= reg_wdata_i[2:0];
            for (int k = 0; k < ExtraPasses; k++) begin
              effects_q[d*EffectW+PassAt+4*k +: 4] <= reg_wdata_i[4*k+4 +: 4];
            end
          end
          if (ExtraSets != 0 && reg_addr_i[5:0] == 6'd13) begin
            effects_q[d*EffectW+SetsAt +: 3] <= reg_wdata_i[2:0];
          end
          if (Stages != 0 && reg_addr_i[5:0] == 6'd13) begin
            effects_q[d*EffectW+StagesAt +: StagesMax] <= reg_wdata_i[8 +: StagesMax];
          end
          if (Stages != 0 && reg_addr_i[5:0] == 6'd14) begin
            effects_q[d*EffectW+ArgumentAt +: 32] <= reg_wdata_i;
          end
        end
        for (int n = 0; n < 6 * ExtraSets; n++) begin
          if (we_sets && reg_addr_i[6:0] == 7'(32 * d + 8 * (n / 6) + n % 6)) begin
            effects_q[d*EffectW+BiasAt+12*n +: 12] <= reg_wdata_i[11:0];
            effects_q[d*EffectW+5*n +: 5]          <= reg_wdata_i[20:16];
          end
        end
      end
    end
  end

  // Reading
  always_comb begin
    reg_rdata_o = '0;
    if (reg_addr_i[15:8] == 8'h00) begin
      for (int d = 0; d < Draws; d++) begin
        if (reg_addr_i[7:6] == 2'(d)) begin
          case (reg_addr_i[5:0])
            6'd12: begin
              reg_rdata_o[2:0]              = effects_q[d*EffectW+PassesAt +: 3];
              reg_rdata_o[4 +: 4*PassesMax] = effects_q[d*EffectW+PassAt +: 4*PassesMax];
            end
            6'd13: begin
              reg_rdata_o[2:0]            = effects_q[d*EffectW+SetsAt +: 3];
              reg_rdata_o[8 +: StagesMax] = effects_q[d*EffectW+StagesAt +: StagesMax];
            end
            6'd14: reg_rdata_o = effects_q[d*EffectW+ArgumentAt +: 32];
            default: ;
          endcase
        end
      end
    end else if (reg_addr_i[15:7] == 9'h050) begin
      for (int d = 0; d < Draws; d++) begin
        for (int n = 0; n < 6 * ExtraSets; n++) begin
          if (reg_addr_i[6:0] == 7'(32 * d + 8 * (n / 6) + n % 6)) begin
            reg_rdata_o[11:0]  = effects_q[d*EffectW+BiasAt+12*n +: 12];
            reg_rdata_o[20:16] = effects_q[d*EffectW+5*n +: 5];
          end
        end
      end
    end
  end

  logic unused;
  assign unused = ^reg_wdata_i;
endmodule
