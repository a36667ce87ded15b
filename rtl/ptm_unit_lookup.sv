// What one TMU looks up for its word of a (sub-)beat: the taps' distinct tiles, by tag bank.
//
//   set = ({ty'[ky-1:0], tx'[kx-1:0]} xor (plane + 3 * level + 5 * texture + (tx' >> kx)
//         + (ty' >> ky))) mod Sets                       docs/spec/unit-timing.md, Tags
//
// The fetched taps are some columns of some rows. Two tiles of one tag bank, or two texels of one
// data bank, are never wanted at once: A3 has split what would. So bank {y, x} serves the column of
// tile parity x and the row of tile parity y. Combinational.
module ptm_unit_lookup #(
  parameter int Sets = 32,  // of one tag bank, a power of two
  localparam int SetBits  = ptm_unit_front_pkg::SetBits,
  localparam int LineBits = ptm_unit_pkg::LineBits
) (
  input  ptm_unit_front_pkg::texels_t       texels_i,
  input  ptm_unit_front_pkg::row_lines_t    row_lines_i,
  input  ptm_unit_front_pkg::column_lines_t column_lines_i,
  input  logic                  color_i,    // the word's texture; 0: the map
  input  logic                  fetched_i,  // the TMU has a word, and its texture has taps
  input  logic [2:0]            plane_i,
  input  logic [3:0]            taps_i,     // of the sub-beat
  output logic [3:0]            fetched_o,  // taps
  output logic [3:0]            first_o,    // the tap is the first that needs its tile
  output logic [7:0]            bank_o,     // by tap: the tag bank of its tile
  output logic [3:0]            used_o,     // by bank: it has a look-up, for the next two
  output logic [4*LineBits-1:0] line_o,
  output logic [4*SetBits-1:0]  set_o
);
  localparam int K  = $clog2(Sets);
  localparam int Kx = (K + 1) / 2;
  localparam int Ky = K - Kx;

  // Columns and rows of the taps that are fetched
  logic [1:0] columns, rows;
  assign columns = {texels_i.columns && (taps_i[1] || taps_i[3]), taps_i[0] || taps_i[2]};
  assign rows    = {texels_i.rows && (taps_i[2] || taps_i[3]), taps_i[0] || taps_i[1]};
  assign fetched_o = {4{fetched_i}} &
      {rows[1] && columns[1], rows[1] && columns[0], rows[0] && columns[1], rows[0] && columns[0]};

  logic [11:2] i0, i1, j0, j1;  // tiles
  assign i0 = texels_i.i[0][11:2];
  assign i1 = texels_i.i[1][11:2];
  assign j0 = texels_i.j[0][11:2];
  assign j1 = texels_i.j[1][11:2];

  // Column 1 is new unless column 0 is fetched too and lies in the same tile; likewise row 1. A tap
  // is the first to need its tile if both its column and its row are new.
  logic new_column, new_row;
  assign new_column = !columns[0] || i0 != i1;
  assign new_row    = !rows[0] || j0 != j1;
  assign first_o    = fetched_o & {new_row && new_column, new_row, new_column, 1'b1};
  assign bank_o     = {j1[2], i1[2], j1[2], i0[2], j0[2], i1[2], j0[2], i0[2]};

  // The hash is a sum of a part for the word, one for the column and one for the row. Modulo
  // 2^SetBits, of which Sets is a factor.
  logic [SetBits-1:0] hash_word;
  assign hash_word = SetBits'(plane_i) + SetBits'(texels_i.level) +
                     (SetBits'(texels_i.level) << 1) + (color_i ? SetBits'(5) : '0);

  // By parity: what columns and rows add
  logic [1:0]            has_column, has_row;
  logic [2*SetBits-1:0]  low_x, hash_x, low_y, hash_y;
  logic [2*LineBits-1:0] column_line, row_line;
  for (genvar p = 0; p < 2; p++) begin : gen_parity
    logic        column0, row0;  // column 0 or row 0 has this parity; else it is 1's turn
    logic [8:0]  x, y;           // tx', ty': within the bank
    logic [12:0] column;
    assign column0       = columns[0] && i0[2] == 1'(p);
    assign row0          = rows[0] && j0[2] == 1'(p);
    assign has_column[p] = column0 || (columns[1] && i1[2] == 1'(p));
    assign has_row[p]    = row0 || (rows[1] && j1[2] == 1'(p));
    assign x             = column0 ? i0[11:3] : i1[11:3];
    assign y             = row0 ? j0[11:3] : j1[11:3];
    assign low_x[p*SetBits +: SetBits]  = SetBits'(x & 9'((1 << Kx) - 1));
    assign low_y[p*SetBits +: SetBits]  = SetBits'((y & 9'((1 << Ky) - 1)) << Kx);
    assign hash_x[p*SetBits +: SetBits] = SetBits'(x >> Kx);
    assign hash_y[p*SetBits +: SetBits] = SetBits'(y >> Ky);
    assign column        = column0 ? column_lines_i.column[0] : column_lines_i.column[1];
    assign column_line[p*LineBits +: LineBits] = LineBits'(column);
    assign row_line[p*LineBits +: LineBits] = LineBits'(plane_i) +
        (row0 ? row_lines_i.row[0] : row_lines_i.row[1]);
  end
  for (genvar b = 0; b < 4; b++) begin : gen_bank
    localparam int X = b % 2;
    localparam int Y = b / 2;
    logic [SetBits-1:0] low, hash;
    assign low       = low_y[Y*SetBits +: SetBits] | low_x[X*SetBits +: SetBits];
    assign hash      = hash_word + hash_x[X*SetBits +: SetBits] + hash_y[Y*SetBits +: SetBits];
    assign used_o[b] = fetched_i && has_row[Y] && has_column[X];
    assign set_o[b*SetBits +: SetBits] = (low ^ hash) & SetBits'(Sets - 1);
    assign line_o[b*LineBits +: LineBits] =
        row_line[Y*LineBits +: LineBits] + column_line[X*LineBits +: LineBits];
  end
endmodule
