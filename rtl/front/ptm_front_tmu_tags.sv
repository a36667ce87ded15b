// One TMU's part of T: what of its word's misses is still to be pushed to the miss ring, and what
// it will read. Used by ptm_front_tags, which looks up and decides when a rank moves.
//
// The outcome of the first cycle is kept while the beat stays. docs/spec/unit-timing.md, Tags.
module ptm_front_tmu_tags #(
  localparam int PlaceBits = ptm_front_pkg::PlaceBits
) (
  input  logic                        clk_i,
  // The beat in T
  input  logic                        valid_i,
  input  logic                        first_i,       // its first cycle: look-ups have meaning
  input  logic                        push_i,        // this rank is pushed
  input  logic                        fetched_i,     // this TMU has a word that is fetched
  input  logic                        color_i,       // of the colour texture
  input  ptm_front_pkg::taken_t  taken_i,
  input  logic [1:0]                  new_rows_i,    // a tap is the first to need its tile if both
  input  logic [1:0]                  new_columns_i, // its row and its column are new
  // Look-ups, by bank
  input  logic [3:0]                  misses_i,
  input  logic [4*PlaceBits-1:0]      place_i,
  // This rank
  output logic                        miss_valid_o,
  output logic [1:0]                  miss_bank_o,
  output logic                        more_o,        // the beat has misses beyond this rank
  output ptm_front_pkg::reads_t  reads_o
);
  // Misses by tap: all of the beat's, and those still to be pushed
  logic [3:0]             missed_now, missed_q, left, left_q, left_after;
  logic [4*PlaceBits-1:0] place_q;
  always_comb begin
    missed_now = 4'd0;
    if (misses_i != 4'd0) begin
      for (int tap = 0; tap < 4; tap++) begin
        missed_now[tap] = new_rows_i[tap/2] && new_columns_i[tap%2] &&
                          misses_i[{tap / 2 == 0 ? taken_i.j0[2] : taken_i.j1[2],
                                    tap % 2 == 0 ? taken_i.i0[2] : taken_i.i1[2]}];
      end
    end
  end
  assign left       = first_i ? missed_now : left_q;
  assign left_after = left & (left - 4'd1);
  always_ff @(posedge clk_i) begin
    if (first_i) begin
      missed_q <= missed_now;
      place_q  <= place_i;
    end
    left_q <= push_i ? left_after : left;
  end

  logic [1:0] tap_now, column_bank, row_bank;  // halves of a tap's tag bank
  assign miss_valid_o = valid_i && left != 4'd0;
  assign more_o       = left_after != 4'd0;
  always_comb begin
    tap_now     = 2'd0;
    column_bank = 2'd0;
    row_bank    = 2'd0;
    miss_bank_o = 2'd0;
    if (left != 4'd0) begin
      tap_now     = left[0] ? 2'd0 : left[1] ? 2'd1 : left[2] ? 2'd2 : 2'd3;
      column_bank = {taken_i.i1[2], taken_i.i0[2]};
      row_bank    = {taken_i.j1[2], taken_i.j0[2]};
      miss_bank_o = {row_bank[tap_now[1]], column_bank[tap_now[0]]};
    end
  end

  assign reads_o = {fetched_i, color_i, first_i ? missed_now : missed_q,
                    first_i ? place_i : place_q};
endmodule
