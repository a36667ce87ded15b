// U6, one texture in one footprint: the lines of the four taps' tiles, and whether the banks can
// serve both columns and both rows at once.
//
//   line(tx, ty) = base + (ty * tiles_across + tx) * planes        docs/spec/unit.md, Lines
//   collides     = i0 != i1 and (i0, i1 have the same parity, or their tiles differ and have it)
//                                                                  docs/spec/unit-timing.md, A3
// Two multiplies, one a row of tiles; times 1, 3 or 6 planes is additions.
// Twin: ptm::reference::place_of() in model/reference/unit/beats.h. Combinational.
module ptm_unit_tiles #(
  localparam int LineBits = ptm_unit_pkg::LineBits
) (
  input  logic [12:0]                  width_i,   // of the level
  input  logic [LineBits-1:0]          base_i,    // of the level
  input  logic [2:0]                   planes_i,  // 1, 3, 6
  input  logic [3:0]                   level_i,
  input  logic                         columns_i, // both columns are fetched
  input  logic                         rows_i,
  input  logic [1:0][11:0]             i_i,
  input  logic [1:0][11:0]             j_i,
  output ptm_unit_front_pkg::texels_t  texels_o
);
  // ceil(width / 4) <= 1024
  logic [12:0] rounded_up;
  assign rounded_up = width_i + 13'd3;

  // Lines before the row of tiles, in tiles: below 2^20
  logic [20:0] before0, before1;
  assign before0 = 21'(j_i[0][11:2]) * 21'(rounded_up[12:2]);
  assign before1 = 21'(j_i[1][11:2]) * 21'(rounded_up[12:2]);

  logic [LineBits-1:0] line [4];
  for (genvar t = 0; t < 4; t++) begin : gen_tap
    logic [20:0]         in_row;
    logic [LineBits-1:0] tile, tripled;
    assign in_row  = (t >= 2 ? before1 : before0) + 21'(i_i[t % 2][11:2]);
    assign tile    = LineBits'(in_row);
    assign tripled = tile + (tile << 1);
    assign line[t] = base_i + (planes_i == 3'd1 ? tile : planes_i == 3'd3 ? tripled
                                                                          : tripled << 1);
  end

  always_comb begin
    texels_o            = '0;
    texels_o.columns    = columns_i;
    texels_o.rows       = rows_i;
    texels_o.i          = i_i;
    texels_o.j          = j_i;
    texels_o.line       = {line[3], line[2], line[1], line[0]};
    texels_o.level      = level_i;
    texels_o.collides_u = columns_i && i_i[0] != i_i[1] &&
        (i_i[0][0] == i_i[1][0] || (i_i[0][11:2] != i_i[1][11:2] && i_i[0][2] == i_i[1][2]));
    texels_o.collides_v = rows_i && j_i[0] != j_i[1] &&
        (j_i[0][0] == j_i[1][0] || (j_i[0][11:2] != j_i[1][11:2] && j_i[0][2] == j_i[1][2]));
  end

  logic unused_rounding;
  assign unused_rounding = ^rounded_up[1:0];
endmodule
