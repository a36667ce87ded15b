// Checks one level of one texture of a draw, and the draw's control: docs/spec/unit.md, Legal.
//
//   1 size, 2 levels, 8 control; 4 the level ends beyond the memory's lines
//
// Sizes, levels and addresses count only for textures that the draw has. Whoever steps through the
// levels looks at error 4 only if there is no other. One multiply: tiles across times tiles down.
// Twin: check_draw() in model/reference/unit/draw.h. Combinational.
module ptm_draw_check (
  input  logic [2:0]  format_i,
  input  logic [1:0]  mip_i,
  input  logic [1:0]  wrap_u_i,
  input  logic [1:0]  wrap_v_i,
  input  logic [2:0]  combine_i,
  input  logic        color_i,
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
  localparam int LargestSide = 4096;

  logic present;
  assign present = texture_i ? color_i : format_i != ptm_unit_pkg::FormatNone;

  logic unknown, incomplete;
  assign unknown = format_i > ptm_unit_pkg::FormatPaletteRgb || mip_i > ptm_unit_pkg::MipLinear ||
                   wrap_u_i > ptm_unit_pkg::WrapClamp || wrap_v_i > ptm_unit_pkg::WrapClamp ||
                   combine_i > ptm_unit_pkg::CombineReplace;
  assign incomplete = (combine_i != ptm_unit_pkg::CombineNone && !color_i) ||
                      (format_i == ptm_unit_pkg::FormatNone &&
                       combine_i != ptm_unit_pkg::CombineReplace);
  assign bad_control_o = unknown || incomplete;

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
  assign tiles  = (2*SideW-2)'(across) * (2*SideW-2)'(down);
  always_comb begin
    lines = (2*SideW+1)'(tiles);
    if (!texture_i && format_i == ptm_unit_pkg::FormatLrgb) begin
      lines = (2*SideW+1)'(tiles) + {2'b0, tiles, 1'b0};  // 3 planes
    end else if (!texture_i && format_i == ptm_unit_pkg::FormatRgb) begin
      lines = {2'b0, tiles, 1'b0} + {1'b0, tiles, 2'b0};  // 6
    end
  end
  assign beyond_o = present && level_i < levels_i &&
                    (2*SideW+2)'(base_i) + (2*SideW+2)'(lines) > (2*SideW+2)'(memory_lines_i);
endmodule
