# Writes the module ptm_effect_chain, the stages of a table of effects one behind the other:
#
#   PTM_CHAIN_TABLE  the table (contract/effects.def, or what a build leaves of it)
#   PTM_CHAIN        the file
#
# cmake/PtmEffects.cmake includes it for the build; for the whole table, which is committed:
#   cmake -D PTM_CHAIN_TABLE=contract/effects.def \
#     -D PTM_CHAIN=rtl/effects/ptm_effect_chain.sv -P cmake/EffectChain.cmake
set(stages "")
file(STRINGS ${PTM_CHAIN_TABLE} rows REGEX "^PTM_STAGE\\(")
foreach(row IN LISTS rows)
  if(NOT row MATCHES "^PTM_STAGE\\(([0-7]), ([a-z_0-9]+)\\)$")
    message(FATAL_ERROR "${PTM_CHAIN_TABLE}: no row of a stage: ${row}")
  endif()
  list(APPEND stages ${CMAKE_MATCH_1}:${CMAKE_MATCH_2})
endforeach()
list(SORT stages)  # numbers of one digit

set(links "")
set(increments "")
set(mask 0)
set(from 0)
foreach(stage IN LISTS stages)
  string(REPLACE ":" ";" stage ${stage})
  list(GET stage 0 number)
  list(GET stage 1 id)
  math(EXPR bit "1 << ${number}")
  math(EXPR mask "${mask} | ${bit}")
  math(EXPR to "${from} + 1")
  string(APPEND increments " + 6'(inc_${id})")
  string(APPEND links "
  // Stage ${number}
  logic                 valid_${to}, ready_${to};
  ptm_unit_pkg::pixel_t pixel_${to};
  logic [3*AddendW-1:0] addend_${to};
  logic [ValuesW-1:0]   value_${to};
  logic [2:0]           inc_${id};
  if ((Stages & ${bit}) != 0) begin : gen_${id}
    ptm_effect_${id} #(
      .LumBits(LumBits), .LumFrac(LumFrac), .RoundNearest(RoundNearest)
    ) u_${id} (
      .clk_i(clk_i), .rst_ni(rst_ni), .ks_i(ks_i), .argument_i(argument_i),
      .acts_i(acts_i[${number}*Draws +: Draws]), .table_we_i(table_we_i),
      .table_addr_i(table_addr_i), .table_data_i(table_data_i), .valid_i(valid_${from}),
      .ready_o(ready_${from}), .pixel_i(pixel_${from}), .addend_i(addend_${from}),
      .value_i(value_${from}), .valid_o(valid_${to}), .ready_i(ready_${to}),
      .pixel_o(pixel_${to}), .addend_o(addend_${to}), .value_o(value_${to}),
      .inc_o(inc_${id})
    );
  end else begin : gen_no_${id}
    assign valid_${to}  = valid_${from};
    assign ready_${from}  = ready_${to};
    assign pixel_${to}  = pixel_${from};
    assign addend_${to} = addend_${from};
    assign value_${to}  = value_${from};
    assign inc_${id} = 3'd0;
  end
")
  set(from ${to})
endforeach()
if(increments STREQUAL "")
  set(increments " + 6'd0")
endif()
string(SUBSTRING "${increments}" 3 -1 increments)

set(module "// Written by cmake/EffectChain.cmake from a table of effects (contract/effects.def).
//
// The stages behind C2 in order of their numbers, those of the mask Stages; what is not in it is
// not there.                                                       docs/spec/effects.md, Time
// Twin: model/pipeline/unit/effect_chain.h.
`include \"ptm_assert.svh\"
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
  `PTM_REQUIRE(ptm_illegal_Stages_that_this_build_has_not, (Stages & ~${mask}) == 0)

  logic                 valid_0, ready_0;
  ptm_unit_pkg::pixel_t pixel_0;
  logic [3*AddendW-1:0] addend_0;
  logic [ValuesW-1:0]   value_0;
  assign valid_0  = valid_i;
  assign ready_o  = ready_0;
  assign pixel_0  = pixel_i;
  assign addend_0 = '0;
  assign value_0  = value_i;
${links}
  assign valid_o = valid_${from};
  assign ready_${from} = ready_i;
  assign pixel_o = pixel_${from};
  assign inc_o   = ${increments};

  logic unused;
  assign unused = ^{clk_i, rst_ni, ks_i, argument_i, acts_i, table_we_i, table_addr_i, table_data_i,
                    addend_${from}, value_${from}};
endmodule
")
file(CONFIGURE OUTPUT ${PTM_CHAIN} CONTENT "${module}" @ONLY)
