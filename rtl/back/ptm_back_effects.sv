// What effects add behind the evaluator: the values of extra passes, which travel beside their
// pixel through C1 and C2, and the chain of stages behind C2.     docs/spec/effects.md, X1 and Time
//
// An extra pass of a fragment is taken before the fragment's pixel is; value[k] of passes that the
// draw does not have is 0. Twins: shade() in model/reference/unit/shade.h, the effect chain in
// model/pipeline.
module ptm_back_effects #(
  // EvalConfig
  parameter int LumBits      = 10,
  parameter int LumFrac      = 0,
  parameter int RoundNearest = 1,
  // UnitConfig
  parameter int ExtraPasses  = 0,  // 0..4
  parameter int Stages       = 1,  // mask
  localparam int LumW      = ptm_pkg::lum_bits(LumBits, LumFrac),
  localparam int Draws     = ptm_unit_pkg::Draws,
  localparam int DrawW     = ptm_unit_pkg::DrawW,
  localparam int DrawBits  = ptm_unit_pkg::DrawBits,
  localparam int EffectW   = ptm_unit_pkg::EffectW,
  localparam int PassesMax = ptm_unit_pkg::PassesMax,
  localparam int StagesMax = ptm_unit_pkg::StagesMax
) (
  input  logic                     clk_i,
  input  logic                     rst_ni,
  input  logic [Draws*DrawW-1:0]   draws_i,    // draw_t, draw 0 lowest
  input  logic [Draws*EffectW-1:0] effects_i,  // effect_t
  input  logic                     table_we_i,
  input  logic [9:0]               table_addr_i,
  input  logic [11:0]              table_data_i,
  // What the evaluator offers: an extra pass that is taken, and the draw
  input  logic                     take_i,
  input  logic [1:0]               number_i,
  input  logic [LumW-1:0]          lum_i,
  input  logic [DrawBits-1:0]      draw_i,
  // C1 and C2
  input  logic                     load_c1_i,
  input  logic                     load_c2_i,
  output logic [DrawBits-1:0]      c2_draw_o,
  input  logic                     valid_i,
  output logic                     ready_o,
  input  ptm_unit_pkg::pixel_t     pixel_i,
  // Pixels
  output logic                     valid_o,
  input  logic                     ready_i,
  output ptm_unit_pkg::pixel_t     pixel_o,
  output logic [5:0]               inc_o       // multiplies of the stages
);
  logic [DrawBits-1:0] c1_draw_q, c2_draw_q;
  always_ff @(posedge clk_i) begin
    if (load_c1_i) c1_draw_q <= draw_i;
    if (load_c2_i) c2_draw_q <= c1_draw_q;
  end
  assign c2_draw_o = c2_draw_q;

  logic [2:0]                passes;
  logic [PassesMax*LumW-1:0] value;  // of the pixel in C2
  for (genvar k = 0; k < PassesMax; k++) begin : gen_value
    if (k < ExtraPasses) begin : gen_pass
      logic [LumW-1:0] value_q, c1_q, c2_q;
      always_ff @(posedge clk_i) begin
        if (take_i && number_i == 2'(k)) value_q <= lum_i;
        if (load_c1_i) c1_q <= 3'(k) < passes ? value_q : '0;
        if (load_c2_i) c2_q <= c1_q;
      end
      assign value[k*LumW +: LumW] = c2_q;
    end else begin : gen_none
      assign value[k*LumW +: LumW] = '0;
    end
  end

  // What stages look at, and how many passes a draw has, by draw
  logic [Draws*3-1:0]         passes_by_draw;
  logic [Draws*9-1:0]         ks;
  logic [Draws*32-1:0]        argument;
  logic [StagesMax*Draws-1:0] acts;  // stage by stage
  for (genvar d = 0; d < Draws; d++) begin : gen_draw
    assign passes_by_draw[3*d +: 3] =
        effects_i[d*EffectW + ptm_unit_pkg::EffectPassesAt +: 3];
    assign ks[9*d +: 9]         = draws_i[d*DrawW +: 9];
    assign argument[32*d +: 32] = effects_i[d*EffectW + ptm_unit_pkg::EffectArgumentAt +: 32];
    for (genvar n = 0; n < StagesMax; n++) begin : gen_stage
      assign acts[n*Draws+d] = effects_i[d*EffectW + ptm_unit_pkg::EffectStagesAt + n];
    end
  end
  ptm_registers_by_draw #(.Width(3)) u_passes (
    .values_i(passes_by_draw), .draw_i(draw_i), .value_o(passes)
  );
  ptm_effect_chain #(
    .LumBits(LumBits), .LumFrac(LumFrac), .RoundNearest(RoundNearest), .Stages(Stages)
  ) u_chain (
    .clk_i(clk_i), .rst_ni(rst_ni), .ks_i(ks), .argument_i(argument), .acts_i(acts),
    .table_we_i(table_we_i), .table_addr_i(table_addr_i), .table_data_i(table_data_i),
    .valid_i(valid_i), .ready_o(ready_o), .pixel_i(pixel_i), .value_i(value), .valid_o(valid_o),
    .ready_i(ready_i), .pixel_o(pixel_o), .inc_o(inc_o)
  );

  logic unused;
  assign unused = ^{draws_i, effects_i, take_i, number_i, lum_i, passes};
endmodule
