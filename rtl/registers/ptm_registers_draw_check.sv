// Checks one level of one texture of a draw, and the draw's control: docs/spec/unit.md, Legal.
//
//   1 size, 2 levels, 8 control; 4 the level ends beyond the memory's lines
//   8 too: effects that the unit is not built for, or that the draw has not the texture for
//                                                              docs/spec/effects.md, Legal
//
// Sizes, levels and addresses count only for textures that the draw has. Whoever steps through the
// levels looks at error 4 only if there is no other. One multiply: tiles across times tiles down.
// Twin: check_draw() in model/reference/unit/draw.h. Combinational.
module ptm_registers_draw_check #(
  parameter int CoefBits    = 8,
  parameter int HalfVector  = 0,
  parameter int ExtraSets   = 0,
  parameter int ExtraPasses = 0,
  parameter int Stages      = 0
) (
  input  logic [2:0]  format_i,
  input  logic [1:0]  mip_i,
  input  logic [1:0]  wrap_u_i,
  input  logic [1:0]  wrap_v_i,
  input  logic [2:0]  combine_i,
  input  logic        color_i,
  input  logic [ptm_unit_pkg::EffectW-1:0] effect_i,  // effect_t
  input  logic        texture_i,       // 0: the map, 1: the colour texture; what follows is its
  input  logic [ptm_unit_pkg::SideBits-1:0] width_i,
  input  logic [ptm_unit_pkg::SideBits-1:0] height_i,
  input  logic [3:0]  levels_i,
  input  logic [3:0]  level_i,
  input  logic [ptm_unit_pkg::LineBits-1:0] base_i,
  input  logic [ptm_unit_pkg::LineBits:0]   memory_lines_i,
  output logic        bad_size_o,
  output logic        bad_levels_o,
  output logic        bad_control_o,
  output logic        beyond_o
);
  localparam int SideW = ptm_unit_pkg::SideBits;
  localparam int LargestSide = ptm_unit_pkg::LargestSide;

  logic present;
  assign present = texture_i ? color_i : format_i != ptm_unit_pkg::FormatNone;

  logic unknown, incomplete;
  assign unknown = format_i > ptm_unit_pkg::FormatLast || mip_i > ptm_unit_pkg::MipLast ||
                   wrap_u_i > ptm_unit_pkg::WrapLast || wrap_v_i > ptm_unit_pkg::WrapLast ||
                   combine_i > ptm_unit_pkg::CombineLast;
  assign incomplete = (combine_i != ptm_unit_pkg::CombineNone && !color_i) ||
                      (format_i == ptm_unit_pkg::FormatNone &&
                       combine_i != ptm_unit_pkg::CombineReplace);

  // Effects
  logic [2:0] sets;
  if (ExtraSets == 0 && ExtraPasses == 0 && Stages == 0) begin : gen_no_effects
    assign sets          = 3'd0;
    assign bad_control_o = unknown || incomplete;
    logic unused_effect;
    assign unused_effect = ^{effect_i, sets};
  end else begin : gen_effects
    logic [2:0] passes;
    logic [3:0] pass;
    logic [7:0] stages;
    logic       beyond_build, bad_pass;
    assign passes = effect_i[ptm_unit_pkg::EffectPassesAt +: 3];
    assign sets   = effect_i[ptm_unit_pkg::EffectSetsAt +: 3];
    assign stages = effect_i[ptm_unit_pkg::EffectStagesAt +: 8];
    // (Yosys 0.23 forgets the ~ in front of a narrowing cast.)
    localparam logic [7:0] Built = 8'(Stages);
    assign beyond_build = sets > 3'(ExtraSets) || passes > 3'(ExtraPasses) ||
                          (stages & ~Built) != '0;
    always_comb begin
      bad_pass = 1'b0;
      pass     = '0;
      for (int k = 0; k < ExtraPasses; k++) begin
        pass = effect_i[ptm_unit_pkg::EffectPassAt + 4*k +: 4];
        if (3'(k) < passes) begin
          if (pass[2:0] > sets || (pass[3] && HalfVector == 0)) bad_pass = 1'b1;
          if (pass[2:0] == 3'd0 && !ptm_format_pkg::one_polynomial(format_i)) bad_pass = 1'b1;
        end
      end
    end
    assign bad_control_o = unknown || incomplete || beyond_build || bad_pass ||
                           (format_i == ptm_unit_pkg::FormatNone &&
                            (sets != 3'd0 || passes != 3'd0));
    logic unused_effect;
    assign unused_effect = ^effect_i;
  end

  assign bad_size_o = present && (width_i == '0 || width_i > SideW'(LargestSide) ||
                                  height_i == '0 || height_i > SideW'(LargestSide));
  // The last level is the one whose longer side is 1, or any before it.
  logic [SideW-1:0] longer;
  assign longer       = width_i > height_i ? width_i : height_i;
  assign bad_levels_o = present && (levels_i == 4'd0 ||
                                    levels_i > 4'(ptm_unit_pkg::LevelsMax) ||
                                    longer >> (levels_i - 4'd1) == '0);

  // The level's lines: tiles across times tiles down times planes
  logic [SideW-1:0]   width, height;
  logic [SideW-2:0]   across, down;  // 4 texels a tile
  logic [2*SideW-3:0] tiles;
  logic [2*SideW:0]   lines;
  assign width  = width_i >> level_i;
  assign height = height_i >> level_i;
  assign across = width == '0 ? (SideW-1)'(1) : (SideW-1)'((SideW+1)'(width) + (SideW+1)'(3) >> 2);
  assign down   = height == '0 ? (SideW-1)'(1)
                               : (SideW-1)'((SideW+1)'(height) + (SideW+1)'(3) >> 2);
  always_comb begin
    tiles = '0;
    if (present) tiles = (2*SideW-2)'(across) * (2*SideW-2)'(down);
  end
  localparam int AWord = ptm_pkg::coefficients_a_word(CoefBits);
  logic [ptm_format_pkg::PlanesBits-1:0] planes;
  logic [2*SideW:0]   own_lines;
  assign planes    = texture_i ? 4'd1 : ptm_format_pkg::planes(AWord, format_i);
  assign own_lines = (planes[0] ? (2*SideW+1)'(tiles) : '0) +
                     (planes[1] ? {2'b0, tiles, 1'b0} : '0) +
                     (planes[2] ? {1'b0, tiles, 2'b0} : '0) +
                     (planes[3] ? {tiles, 3'b0} : '0);
  if (ExtraSets == 0) begin : gen_own_lines
    assign lines = own_lines;
  end else begin : gen_set_lines  // more than four sets are an error of their own
    logic [2*SideW:0] set;  // of one: two planes, or three
    assign set   = {2'b0, tiles, 1'b0} + (AWord == 3 ? '0 : (2*SideW+1)'(tiles));
    assign lines = texture_i ? own_lines
                 : own_lines + (sets[2] ? set << 2
                                        : (sets[0] ? set : '0) + (sets[1] ? set << 1 : '0));
  end
  assign beyond_o = present && level_i < levels_i &&
                    (2*SideW+2)'(base_i) + (2*SideW+2)'(lines) > (2*SideW+2)'(memory_lines_i);
endmodule
