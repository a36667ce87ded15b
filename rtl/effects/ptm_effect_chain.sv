// Written by cmake/EffectChain.cmake from a table of effects (contract/effects.def).
//
// The stages behind C2 in order of their numbers, those of the mask Stages; what is not in it is
// not there.                                                       docs/spec/effects.md, Time
// Twin: model/pipeline/unit/effect_chain.h.
`include "ptm_assert.svh"
module ptm_effect_chain #(
  parameter int LumBits      = 10,  // EvalConfig
  parameter int LumFrac      = 0,
  parameter int RoundNearest = 1,
  parameter int Stages       = 0,   // mask
  localparam int LumW      = ptm_pkg::lum_bits(LumBits, LumFrac),
  localparam int Draws     = ptm_unit_pkg::Draws,
  localparam int AddendW   = ptm_unit_pkg::AddendW,
  localparam int ValuesW   = ptm_unit_pkg::PassesMax * LumW,
  localparam int StagesMax = ptm_unit_pkg::StagesMax
) (
  input  logic                       clk_i,
  input  logic                       rst_ni,
  // Registers by draw, draw 0 lowest, acts_i stage by stage; the port that writes the tables
  input  logic [Draws*9-1:0]         ks_i,
  input  logic [Draws*32-1:0]        argument_i,
  input  logic [StagesMax*Draws-1:0] acts_i,
  input  logic                       table_we_i,
  input  logic [9:0]                 table_addr_i,
  input  logic [11:0]                table_data_i,
  // Pixels in and out, values of the extra passes
  input  logic                       valid_i,
  output logic                       ready_o,
  input  ptm_unit_pkg::pixel_t       pixel_i,
  input  logic [ValuesW-1:0]         value_i,
  output logic                       valid_o,
  input  logic                       ready_i,
  output ptm_unit_pkg::pixel_t       pixel_o,
  output logic [5:0]                 inc_o    // multiplies of the pixels that enter stages
);
  `PTM_REQUIRE(ptm_illegal_Stages_that_this_build_has_not, (Stages & ~7) == 0)

  logic                 valid_0, ready_0;
  ptm_unit_pkg::pixel_t pixel_0;
  logic [3*AddendW-1:0] addend_0;
  logic [ValuesW-1:0]   value_0;
  assign valid_0  = valid_i;
  assign ready_o  = ready_0;
  assign pixel_0  = pixel_i;
  assign addend_0 = '0;
  assign value_0  = value_i;

  // Stage 0
  logic                 valid_1, ready_1;
  ptm_unit_pkg::pixel_t pixel_1;
  logic [3*AddendW-1:0] addend_1;
  logic [ValuesW-1:0]   value_1;
  logic [2:0]           inc_power;
  if ((Stages & 1) != 0) begin : gen_power
    ptm_effect_power #(
      .LumBits(LumBits), .LumFrac(LumFrac), .RoundNearest(RoundNearest)
    ) u_power (
      .clk_i(clk_i), .rst_ni(rst_ni), .ks_i(ks_i), .argument_i(argument_i),
      .acts_i(acts_i[0*Draws +: Draws]), .table_we_i(table_we_i),
      .table_addr_i(table_addr_i), .table_data_i(table_data_i), .valid_i(valid_0),
      .ready_o(ready_0), .pixel_i(pixel_0), .addend_i(addend_0),
      .value_i(value_0), .valid_o(valid_1), .ready_i(ready_1),
      .pixel_o(pixel_1), .addend_o(addend_1), .value_o(value_1),
      .inc_o(inc_power)
    );
  end else begin : gen_no_power
    assign valid_1  = valid_0;
    assign ready_0  = ready_1;
    assign pixel_1  = pixel_0;
    assign addend_1 = addend_0;
    assign value_1  = value_0;
    assign inc_power = 3'd0;
  end

  // Stage 1
  logic                 valid_2, ready_2;
  ptm_unit_pkg::pixel_t pixel_2;
  logic [3*AddendW-1:0] addend_2;
  logic [ValuesW-1:0]   value_2;
  logic [2:0]           inc_modulate;
  if ((Stages & 2) != 0) begin : gen_modulate
    ptm_effect_modulate #(
      .LumBits(LumBits), .LumFrac(LumFrac), .RoundNearest(RoundNearest)
    ) u_modulate (
      .clk_i(clk_i), .rst_ni(rst_ni), .ks_i(ks_i), .argument_i(argument_i),
      .acts_i(acts_i[1*Draws +: Draws]), .table_we_i(table_we_i),
      .table_addr_i(table_addr_i), .table_data_i(table_data_i), .valid_i(valid_1),
      .ready_o(ready_1), .pixel_i(pixel_1), .addend_i(addend_1),
      .value_i(value_1), .valid_o(valid_2), .ready_i(ready_2),
      .pixel_o(pixel_2), .addend_o(addend_2), .value_o(value_2),
      .inc_o(inc_modulate)
    );
  end else begin : gen_no_modulate
    assign valid_2  = valid_1;
    assign ready_1  = ready_2;
    assign pixel_2  = pixel_1;
    assign addend_2 = addend_1;
    assign value_2  = value_1;
    assign inc_modulate = 3'd0;
  end

  // Stage 2
  logic                 valid_3, ready_3;
  ptm_unit_pkg::pixel_t pixel_3;
  logic [3*AddendW-1:0] addend_3;
  logic [ValuesW-1:0]   value_3;
  logic [2:0]           inc_add;
  if ((Stages & 4) != 0) begin : gen_add
    ptm_effect_add #(
      .LumBits(LumBits), .LumFrac(LumFrac), .RoundNearest(RoundNearest)
    ) u_add (
      .clk_i(clk_i), .rst_ni(rst_ni), .ks_i(ks_i), .argument_i(argument_i),
      .acts_i(acts_i[2*Draws +: Draws]), .table_we_i(table_we_i),
      .table_addr_i(table_addr_i), .table_data_i(table_data_i), .valid_i(valid_2),
      .ready_o(ready_2), .pixel_i(pixel_2), .addend_i(addend_2),
      .value_i(value_2), .valid_o(valid_3), .ready_i(ready_3),
      .pixel_o(pixel_3), .addend_o(addend_3), .value_o(value_3),
      .inc_o(inc_add)
    );
  end else begin : gen_no_add
    assign valid_3  = valid_2;
    assign ready_2  = ready_3;
    assign pixel_3  = pixel_2;
    assign addend_3 = addend_2;
    assign value_3  = value_2;
    assign inc_add = 3'd0;
  end

  assign valid_o = valid_3;
  assign ready_3 = ready_i;
  assign pixel_o = pixel_3;
  assign inc_o   = 6'(inc_power) + 6'(inc_modulate) + 6'(inc_add);

  logic unused;
  assign unused = ^{clk_i, rst_ni, ks_i, argument_i, acts_i, table_we_i, table_addr_i, table_data_i,
                    addend_3, value_3};
endmodule
