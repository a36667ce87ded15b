// Where one texture's taps lie in the data banks, for all of its words: by bank what to read, by
// tap its bank. Used by ptm_front_fetch in F.
//
// Data bank {y, x} serves the column of parity x and the row of parity y; taps of one bank are the
// same texel.                                   docs/spec/unit-timing.md, Commit and fetch
//
// Without taps all stands still, at 0: the simulation of a draw without this texture saves it.
// Combinational.
module ptm_front_taps (
  input  ptm_front_pkg::taken_t   taken_i,
  output ptm_front_pkg::sources_t sources_o
);
  logic [2:0] i0, i1, j0, j1;  // places
  assign i0 = taken_i.i0;
  assign i1 = taken_i.i1;
  assign j0 = taken_i.j0;
  assign j1 = taken_i.j1;

  // By parity: whether there is a column and a row that has it
  logic       x0, x1, y0, y1;  // column 0 or row 0 has this parity; else it is 1's turn
  logic [1:0] has_column, has_row;
  // Bits of a place, for the tile and for the word, a row's above a column's
  logic [3:0] at_i0, at_i1, at_j0, at_j1, at_x0, at_x1, at_y0, at_y1;
  // By tap
  logic [7:0] bank_x, bank_y;
  logic [3:0] fetched, here;
  always_comb begin
    {x0, x1, y0, y1, has_column, has_row} = '0;
    {at_i0, at_i1, at_j0, at_j1}          = '0;
    {at_x0, at_x1, at_y0, at_y1}          = '0;
    {bank_x, bank_y, fetched, here}       = '0;
    sources_o                             = '0;
    if (taken_i.columns != '0) begin
      x0         = taken_i.columns[0] && !i0[0];
      x1         = taken_i.columns[0] && i0[0];
      y0         = taken_i.rows[0] && !j0[0];
      y1         = taken_i.rows[0] && j0[0];
      has_column = {x1 || (taken_i.columns[1] && i1[0]), x0 || (taken_i.columns[1] && !i1[0])};
      has_row    = {y1 || (taken_i.rows[1] && j1[0]), y0 || (taken_i.rows[1] && !j1[0])};
      here       = {{2{has_row[1]}} & has_column, {2{has_row[0]}} & has_column};
      at_i0      = {1'b0, i0[2], 1'b0, i0[1]};
      at_i1      = {1'b0, i1[2], 1'b0, i1[1]};
      at_j0      = {j0[2], 1'b0, j0[1], 1'b0};
      at_j1      = {j1[2], 1'b0, j1[1], 1'b0};
      at_x0      = x0 ? at_i0 : at_i1;
      at_x1      = x1 ? at_i0 : at_i1;
      at_y0      = y0 ? at_j0 : at_j1;
      at_y1      = y1 ? at_j0 : at_j1;
      bank_x     = {2{1'b0, i1[0], 1'b0, i0[0]}};
      bank_y     = {{2{j1[0], 1'b0}}, {2{j0[0], 1'b0}}};
      fetched    = {{2{taken_i.rows[1]}} & taken_i.columns, {2{taken_i.rows[0]}} & taken_i.columns};
      sources_o  = {fetched, bank_x | bank_y, here,
                    at_y1 | at_x1, at_y1 | at_x0, at_y0 | at_x1, at_y0 | at_x0};
    end
  end
endmodule
