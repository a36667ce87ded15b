// One direction of ptm_front_lookup: which of a (sub-)beat's two columns lies in the tag banks of
// which parity, and where. Rows likewise.
//
// Stands still, at 0, while not enabled. Combinational.
module ptm_front_lookup_axis (
  input  logic       enable_i,
  input  logic [1:0] fetched_i,  // columns
  input  logic [9:0] tile0_i,    // of column 0
  input  logic [9:0] tile1_i,
  output logic [1:0] new_o,      // a column that no column before it shares the tile with
  output logic [1:0] has_o,      // by parity of the tile: a column lies there
  output logic [1:0] first_o,    // by parity: it is column 0; else it is 1's turn
  output logic [8:0] even_o,     // the tile within the bank of that parity
  output logic [8:0] odd_o
);
  always_comb begin
    {new_o, has_o, first_o, even_o, odd_o} = '0;
    if (enable_i) begin
      new_o   = {fetched_i[1] && (!fetched_i[0] || tile0_i != tile1_i), fetched_i[0]};
      first_o = {fetched_i[0] && tile0_i[0], fetched_i[0] && !tile0_i[0]};
      has_o   = first_o | {fetched_i[1] && tile1_i[0], fetched_i[1] && !tile1_i[0]};
      even_o  = first_o[0] ? tile0_i[9:1] : tile1_i[9:1];
      odd_o   = first_o[1] ? tile0_i[9:1] : tile1_i[9:1];
    end
  end
endmodule
