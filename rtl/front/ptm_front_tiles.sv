// U4 behind its products, U5 and U6, one texture in one footprint: its texels, the lines of their
// tiles, and whether the banks can serve both columns and both rows at once.
//
//   line(tx, ty) = base + (ty * tiles_across + tx) * planes        docs/spec/unit.md, Lines
//                = row line + column line; the word's plane is added where it is known
//   collides     = i0 != i1 and (i0, i1 have the same parity, or their tiles differ and have it)
//                                                                  docs/spec/unit-timing.md, A3
// Two multiplies, one a row of tiles; times 1, 3 or 6 planes, and two a set, is additions; with two
// coefficients a word times 1, 4 or 9, and three a set.
// Twin: ptm::reference::place_of() in model/reference/unit/beats.h. Combinational.
module ptm_front_tiles #(
  parameter int CoefBits  = 8,
  parameter int ExtraSets = 0,  // 0..4
  localparam int AWord = ptm_pkg::coefficients_a_word(CoefBits),
  localparam int PlanesBits = ptm_format_pkg::PlanesBits,
  localparam int LineBits = ptm_unit_pkg::LineBits
) (
  input  logic                        enable_i,     // the draw has this texture
  input  logic                        bilinear_i,
  input  logic                        repeat_u_i,
  input  logic                        repeat_v_i,
  input  logic [31:0]                 product_u_i,  // fu * W_l
  input  logic [31:0]                 product_v_i,
  input  ptm_front_pkg::level_t  level_i,
  input  logic [PlanesBits-1:0]       planes_i,     // 1, 3, 6; or 1, 4, 9
  input  logic [2:0]                  sets_i,       // 0..4, two planes more each; or three
  output logic [7:0]                  wu_o,
  output logic [7:0]                  wv_o,
  output ptm_front_pkg::texels_t       texels_o,
  output ptm_front_pkg::row_lines_t    row_lines_o,
  output ptm_front_pkg::column_lines_t column_lines_o
);
  logic [11:0] i0, i1, j0, j1;
  ptm_front_scale u_scale_u (
    .enable_i(enable_i), .bilinear_i(bilinear_i), .repeat_i(repeat_u_i),
    .product_i(product_u_i),
    .side_i(level_i.width), .i0_o(i0), .i1_o(i1), .weight_o(wu_o)
  );
  ptm_front_scale u_scale_v (
    .enable_i(enable_i), .bilinear_i(bilinear_i), .repeat_i(repeat_v_i),
    .product_i(product_v_i),
    .side_i(level_i.height), .i0_o(j0), .i1_o(j1), .weight_o(wv_o)
  );

  // ceil(width / 4) <= 1024
  logic [12:0] rounded_up;
  assign rounded_up = level_i.width + 13'd3;

  // Tiles before the row of tiles: below 2^20
  logic [20:0] before0, before1;
  function automatic logic [LineBits-1:0] times_planes(input logic [20:0] tiles,
                                                       input logic [PlanesBits-1:0] planes);
    logic [LineBits-1:0] one, three;
    one          = LineBits'(tiles);
    three        = one + (one << 1);
    if (AWord == 3) begin
      times_planes = planes == 4'd1 ? one : planes == 4'd3 ? three : three << 1;
    end else begin
      times_planes = planes == 4'd1 ? one : planes == 4'd4 ? one << 2 : one + (one << 3);
    end
  endfunction
  function automatic logic [LineBits-1:0] times_sets(input logic [20:0] tiles,
                                                     input logic [2:0] sets);
    logic [LineBits-1:0] set;  // of one
    set        = AWord == 3 ? LineBits'(tiles) << 1
                            : LineBits'(tiles) + (LineBits'(tiles) << 1);
    times_sets = sets[2] ? set << 2 : (sets[0] ? set : '0) + (sets[1] ? set << 1 : '0);
  endfunction
  logic [LineBits-1:0] row0, row1, column0, column1;
  always_comb begin
    before0 = '0;
    before1 = '0;
    row0    = '0;
    row1    = '0;
    column0 = '0;
    column1 = '0;
    if (enable_i) begin
      before0 = 21'(j0[11:2]) * 21'(rounded_up[12:2]);
      before1 = 21'(j1[11:2]) * 21'(rounded_up[12:2]);
      row0    = level_i.base + times_planes(before0, planes_i);
      row1    = level_i.base + times_planes(before1, planes_i);
      column0 = times_planes(21'(i0[11:2]), planes_i);
      column1 = times_planes(21'(i1[11:2]), planes_i);
    end
  end

  logic columns, rows, collides_u, collides_v;
  assign columns        = wu_o != 8'd0;
  assign rows           = wv_o != 8'd0;
  assign collides_u     = columns && i0 != i1 &&
                          (i0[0] == i1[0] || (i0[11:2] != i1[11:2] && i0[2] == i1[2]));
  assign collides_v     = rows && j0 != j1 &&
                          (j0[0] == j1[0] || (j0[11:2] != j1[11:2] && j0[2] == j1[2]));
  assign texels_o       = {i1, i0, j1, j0, level_i.level, columns, rows, collides_u, collides_v};

  // With the sets' planes
  logic [LineBits-1:0] column0_all, column1_all;
  if (ExtraSets == 0) begin : gen_own
    assign row_lines_o = {row1, row0};
    localparam int W = AWord == 3 ? 13 : 14;  // 1,023 tiles of six planes, or of nine
    assign column0_all = {{(LineBits-W){1'b0}}, column0[W-1:0]};
    assign column1_all = {{(LineBits-W){1'b0}}, column1[W-1:0]};
    logic unused_sets;
    assign unused_sets = ^{sets_i, column0[25:W], column1[25:W]};
  end else begin : gen_sets
    logic [2:0] sets;
    assign sets        = enable_i ? sets_i : '0;
    assign row_lines_o = {row1 + times_sets(before1, sets), row0 + times_sets(before0, sets)};
    assign column0_all = column0 + times_sets(21'(i0[11:2]), sets);
    assign column1_all = column1 + times_sets(21'(i1[11:2]), sets);
  end
  assign column_lines_o = {column1_all[14:0], column0_all[14:0]};

  logic unused_bits;
  assign unused_bits = ^{rounded_up[1:0], column0_all[25:15], column1_all[25:15]};
endmodule
