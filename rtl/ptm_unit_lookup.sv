// What the words of one texture look up for a (sub-)beat: the taps' distinct tiles, by tag bank. A
// word adds its plane to line and hash (ptm_unit_tmu_tags).
//
//   set = ({ty'[ky-1:0], tx'[kx-1:0]} xor (plane + 3 * level + 5 * texture + (tx' >> kx)
//         + (ty' >> ky))) mod Sets                       docs/spec/unit-timing.md, Tags
//
// The fetched taps are some columns of some rows. Two tiles of one tag bank, or two texels of one
// data bank, are never wanted at once: A3 has split what would. So bank {y, x} serves the column of
// tile parity x and the row of tile parity y.
//
// Stands still, at 0, while not enabled: the simulation of a draw without this texture saves it.
// Combinational.
module ptm_unit_lookup #(
  parameter int Sets  = 32,  // of one tag bank, a power of two
  parameter int Color = 0,   // the colour texture; 0: the map
  localparam int SetBits  = ptm_unit_front_pkg::SetBits,
  localparam int LineBits = ptm_unit_pkg::LineBits
) (
  input  logic                              enable_i,  // a word of this texture is fetched
  input  ptm_unit_front_pkg::texels_t       texels_i,
  input  ptm_unit_front_pkg::row_lines_t    row_lines_i,
  input  ptm_unit_front_pkg::column_lines_t column_lines_i,
  input  logic [3:0]                  taps_i,     // of the sub-beat
  output ptm_unit_front_pkg::taken_t  taken_o,
  output logic [3:0]                  first_o,    // the tap is the first that needs its tile
  output logic [3:0]                  used_o,     // by bank: it has a look-up, for what follows
  // A bank's hash before the plane, and what it is to be xored with
  output logic [4*SetBits-1:0]        hash_o,
  output logic [4*SetBits-1:0]        low_o,
  // By parity: a bank's line is the sum of its row's, its column's and the plane
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

  logic [11:2] i0, i1, j0, j1;  // tiles
  assign i0 = texels_i.i[0][11:2];
  assign i1 = texels_i.i[1][11:2];
  assign j0 = texels_i.j[0][11:2];
  assign j1 = texels_i.j[1][11:2];

  // Column 1 is new unless column 0 is fetched too and lies in the same tile; likewise row 1. A tap
  // is the first to need its tile if both its column and its row are new.
  logic [1:0] new_columns, new_rows;
  always_comb begin
    new_columns = '0;
    new_rows    = '0;
    if (enable_i) begin
      new_columns = {columns[1] && (!columns[0] || i0 != i1), columns[0]};
      new_rows    = {rows[1] && (!rows[0] || j0 != j1), rows[0]};
    end
  end
  assign first_o = {{2{new_rows[1]}} & new_columns, {2{new_rows[0]}} & new_columns};
  logic [2:0] place_i0, place_i1, place_j0, place_j1;
  assign place_i0 = texels_i.i[0][2:0];
  assign place_i1 = texels_i.i[1][2:0];
  assign place_j0 = texels_i.j[0][2:0];
  assign place_j1 = texels_i.j[1][2:0];
  always_comb begin
    taken_o = '0;
    if (enable_i) begin
      taken_o.columns = columns;
      taken_o.rows    = rows;
      taken_o.i2      = {place_i1[2], place_i0[2]};
      taken_o.i1      = {place_i1[1], place_i0[1]};
      taken_o.i0      = {place_i1[0], place_i0[0]};
      taken_o.j2      = {place_j1[2], place_j0[2]};
      taken_o.j1      = {place_j1[1], place_j0[1]};
      taken_o.j0      = {place_j1[0], place_j0[0]};
    end
  end

  // The hash is a sum of a part for the level and the texture, one for the column and one for the
  // row. Modulo 2^SetBits, of which Sets is a factor.
  logic [SetBits-1:0] hash_level;
  assign hash_level = SetBits'(texels_i.level) + (SetBits'(texels_i.level) << 1) +
                      (Color != 0 ? SetBits'(5) : '0);

  // By parity: what columns and rows add
  logic [1:0]         has_column, has_row;
  logic [SetBits-1:0] low_x [2], hash_x [2], low_y [2], hash_y [2];
  for (genvar p = 0; p < 2; p++) begin : gen_parity
    logic        column0, row0;  // column 0 or row 0 has this parity; else it is 1's turn
    logic [8:0]  x, y;           // tx', ty': within the bank
    logic [13:0] column;
    logic [25:0] row;
    always_comb begin
      {column0, row0, has_column[p], has_row[p]}         = '0;
      {x, y, column, row}                                = '0;
      {low_x[p], low_y[p], hash_x[p], hash_y[p]}         = '0;
      if (enable_i) begin
        column0       = columns[0] && i0[2] == 1'(p);
        row0          = rows[0] && j0[2] == 1'(p);
        has_column[p] = column0 || (columns[1] && i1[2] == 1'(p));
        has_row[p]    = row0 || (rows[1] && j1[2] == 1'(p));
        x             = column0 ? i0[11:3] : i1[11:3];
        y             = row0 ? j0[11:3] : j1[11:3];
        low_x[p]      = SetBits'(x & 9'((1 << Kx) - 1));
        low_y[p]      = SetBits'((y & 9'((1 << Ky) - 1)) << Kx);
        hash_x[p]     = SetBits'(x >> Kx);
        hash_y[p]     = SetBits'(y >> Ky) + hash_level;
        column        = column0 ? column_lines_i.column[0] : column_lines_i.column[1];
        row           = row0 ? row_lines_i.row[0] : row_lines_i.row[1];
      end
    end
    assign column_o[p*LineBits +: LineBits] = LineBits'(column);
    assign row_o[p*LineBits +: LineBits]    = row;
  end
  assign used_o = {{2{has_row[1]}} & has_column, {2{has_row[0]}} & has_column};
  assign low_o  = {low_y[1] | low_x[1], low_y[1] | low_x[0],
                   low_y[0] | low_x[1], low_y[0] | low_x[0]};
  assign hash_o = {hash_y[1] + hash_x[1], hash_y[1] + hash_x[0],
                   hash_y[0] + hash_x[1], hash_y[0] + hash_x[0]};
endmodule
