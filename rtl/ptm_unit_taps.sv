// Where one texture's taps lie in the data banks, for all of its words: in F by bank what to read,
// in D what was read, by bank and by tap. Used by ptm_unit_fetch.
//
// Data bank {y, x} serves the column of parity x and the row of parity y; taps of one bank are the
// same texel.                                   docs/spec/unit-timing.md, Commit and fetch
module ptm_unit_taps (
  input  logic                        clk_i,
  // F
  input  ptm_unit_front_pkg::taken_t  taken_i,
  output logic [3:0]                  here_o,      // by data bank: it is read
  output logic [7:0]                  tag_bank_o,  // by data bank: of the tile it reads
  // D
  input  logic                        d_load_i,
  output logic [7:0]                  word_o,      // by data bank: in its row
  output logic [3:0]                  fetched_o,   // by tap
  output logic [7:0]                  bank_o       // by tap: its data bank
);
  // By parity: whether there is a column and a row that has it, and the bits of its place
  logic [1:0] has_column, has_row, column_tile, column_word, row_tile, row_word;
  for (genvar p = 0; p < 2; p++) begin : gen_parity
    logic column0, row0;
    assign column0        = taken_i.columns[0] && taken_i.i0[0] == 1'(p);
    assign row0           = taken_i.rows[0] && taken_i.j0[0] == 1'(p);
    assign has_column[p]  = column0 || (taken_i.columns[1] && taken_i.i0[1] == 1'(p));
    assign has_row[p]     = row0 || (taken_i.rows[1] && taken_i.j0[1] == 1'(p));
    assign column_tile[p] = column0 ? taken_i.i2[0] : taken_i.i2[1];
    assign column_word[p] = column0 ? taken_i.i1[0] : taken_i.i1[1];
    assign row_tile[p]    = row0 ? taken_i.j2[0] : taken_i.j2[1];
    assign row_word[p]    = row0 ? taken_i.j1[0] : taken_i.j1[1];
  end
  assign here_o     = {{2{has_row[1]}} & has_column, {2{has_row[0]}} & has_column};
  // Without taps nothing moves, and nothing is simulated
  always_comb begin
    tag_bank_o = '0;
    if (taken_i.columns != '0) begin
      tag_bank_o = {row_tile[1], column_tile[1], row_tile[1], column_tile[0],
                    row_tile[0], column_tile[1], row_tile[0], column_tile[0]};
    end
  end

  logic [1:0] columns_q, rows_q, i0_q, j0_q, column_word_q, row_word_q;
  always_ff @(posedge clk_i) begin
    if (d_load_i) begin
      columns_q     <= taken_i.columns;
      rows_q        <= taken_i.rows;
      i0_q          <= taken_i.i0;
      j0_q          <= taken_i.j0;
      column_word_q <= column_word;
      row_word_q    <= row_word;
    end
  end
  assign fetched_o = {{2{rows_q[1]}} & columns_q, {2{rows_q[0]}} & columns_q};
  always_comb begin
    word_o = '0;
    bank_o = '0;
    if (columns_q != '0) begin
      word_o = {row_word_q[1], column_word_q[1], row_word_q[1], column_word_q[0],
                row_word_q[0], column_word_q[1], row_word_q[0], column_word_q[0]};
      bank_o = {j0_q[1], i0_q[1], j0_q[1], i0_q[0], j0_q[0], i0_q[1], j0_q[0], i0_q[0]};
    end
  end
endmodule
