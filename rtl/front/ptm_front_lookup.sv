// The look-ups of one texture for one beat or sub-beat: in which tiles its taps lie, and for each
// of the four tag banks the set and the line to look up. Line and set are given here without the
// word's plane, which ptm_front_tags adds for each TMU, since all words of a texture share the
// rest.
//
//   set = ({ty'[ky-1:0], tx'[kx-1:0]} xor (plane + 3 * level + 5 * texture + (tx' >> kx)
//         + (ty' >> ky))) mod Sets                       docs/spec/unit-timing.md, Tags
//
// Tag bank {y, x} holds the tiles (tx, ty) whose ty has parity y and whose tx has parity x. The
// fetched taps are one or two columns times one or two rows. If their two columns lie in different
// tiles, the parities of those differ, since A3 has split every beat in which two tiles would want
// one bank (Seam split). So for each parity x at most one column of tiles is looked up, for each
// parity y at most one row, and bank {y, x} looks up the tile where the two cross.
//
// All outputs are 0 while enable_i is low.
// Combinational.
module ptm_front_lookup #(
  parameter int Sets  = 32,  // of one tag bank, a power of two
  parameter int Color = 0,   // the colour texture; 0: the map
  localparam int SetBits  = ptm_front_pkg::SetBits,
  localparam int LineBits = ptm_unit_pkg::LineBits
) (
  input  logic                              enable_i,  // a word of this texture is fetched
  input  ptm_front_pkg::texels_t       texels_i,
  input  ptm_front_pkg::row_lines_t    row_lines_i,
  input  ptm_front_pkg::column_lines_t column_lines_i,
  input  logic [3:0]                  taps_i,     // of the sub-beat
  output ptm_front_pkg::taken_t  taken_o,
  // A column is new if no fetched column before it lies in the same tile; likewise a row. A tap is
  // the first that needs its tile if both its column and its row are new.
  output logic [1:0]                  new_rows_o,
  output logic [1:0]                  new_columns_o,
  output logic [3:0]                  used_o,     // by bank: it has a look-up
  // For the set of bank {y, x}, which is (low_x | low_y) xor (hash_x + hash_y + plane): the parts
  // of the column of tiles of parity x and of the row of parity y. Two entries each, even parity
  // lowest
  output logic [2*SetBits-1:0]              hash_x_o,
  output logic [2*SetBits-1:0]              hash_y_o,
  output logic [2*SetBits-1:0]              low_x_o,
  output logic [2*SetBits-1:0]              low_y_o,
  // The line of bank {y, x} is the row's part of parity y, the column's of parity x and the plane
  output logic [2*LineBits-1:0]       row_o,
  output logic [2*LineBits-1:0]       column_o
);
  localparam int K  = $clog2(Sets);
  localparam int Kx = (K + 1) / 2;
  localparam int Ky = K - Kx;

  // Columns and rows of the taps that are fetched
  logic [1:0] columns, rows;
  assign columns = {texels_i.columns && (taps_i[1] || taps_i[3]), taps_i[0] || taps_i[2]};
  assign rows    = {texels_i.rows && (taps_i[2] || taps_i[3]), taps_i[0] || taps_i[1]};

  // Column 1 is new unless column 0 is fetched too and lies in the same tile; likewise row 1.
  logic [1:0] has_column, has_row, column0, row0;
  logic [8:0] x_even, x_odd, y_even, y_odd;  // tx', ty': within the bank
  ptm_front_lookup_axis u_x (
    .enable_i(enable_i), .fetched_i(columns), .tile0_i(texels_i.i[0][11:2]),
    .tile1_i(texels_i.i[1][11:2]), .new_o(new_columns_o), .has_o(has_column), .first_o(column0),
    .even_o(x_even), .odd_o(x_odd)
  );
  ptm_front_lookup_axis u_y (
    .enable_i(enable_i), .fetched_i(rows), .tile0_i(texels_i.j[0][11:2]),
    .tile1_i(texels_i.j[1][11:2]), .new_o(new_rows_o), .has_o(has_row), .first_o(row0),
    .even_o(y_even), .odd_o(y_odd)
  );

  // The hash is a sum of a part for the level and the texture, one for the column and one for the
  // row. It is computed modulo 2^SetBits, of which Sets is a factor.
  logic [SetBits-1:0]  hash_level, hash_even, hash_odd;
  logic [LineBits-1:0] column_line0, column_line1, row_line0, row_line1;
  assign column_line0 = LineBits'(column_lines_i.column[0]);
  assign column_line1 = LineBits'(column_lines_i.column[1]);
  assign row_line0    = row_lines_i.row[0];
  assign row_line1    = row_lines_i.row[1];
  always_comb begin
    {hash_even, hash_odd}                                      = '0;
    {hash_level, used_o, hash_x_o, hash_y_o, low_x_o, low_y_o} = '0;
    {column_o, row_o}                                          = '0;
    taken_o                                                    = '0;
    if (enable_i) begin
      taken_o    = {columns, rows, texels_i.i[1][2:0], texels_i.i[0][2:0], texels_i.j[1][2:0],
                    texels_i.j[0][2:0]};
      used_o     = {{2{has_row[1]}} & has_column, {2{has_row[0]}} & has_column};
      hash_level = SetBits'(texels_i.level) + (SetBits'(texels_i.level) << 1) +
                   (Color != 0 ? SetBits'(5) : '0);
      low_x_o    = {SetBits'(x_odd & 9'((1 << Kx) - 1)), SetBits'(x_even & 9'((1 << Kx) - 1))};
      low_y_o    = {SetBits'((y_odd & 9'((1 << Ky) - 1)) << Kx),
                    SetBits'((y_even & 9'((1 << Ky) - 1)) << Kx)};
      hash_x_o   = {SetBits'(x_odd >> Kx), SetBits'(x_even >> Kx)};
      // (Not in one concatenation: Yosys 0.23 gives a sum with a narrowing cast its old width.)
      hash_even  = SetBits'(y_even >> Ky) + hash_level;
      hash_odd   = SetBits'(y_odd >> Ky) + hash_level;
      hash_y_o   = {hash_odd, hash_even};
      column_o   = {column0[1] ? column_line0 : column_line1,
                    column0[0] ? column_line0 : column_line1};
      row_o      = {row0[1] ? row_line0 : row_line1, row0[0] ? row_line0 : row_line1};
    end
  end
endmodule
