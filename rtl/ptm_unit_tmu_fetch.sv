// One TMU's part of F and D: its four data banks by texel parity, a line being a row in each, and
// the choice of the taps' words. Used by ptm_unit_fetch, which moves the beats.
//
// K writes at the end of the cycle in which it commits; F reads as it leaves for D, and sees what
// stood before. docs/spec/unit-timing.md, Commit and fetch.
module ptm_unit_tmu_fetch #(
  parameter int Rows = 256,  // lines of the cache
  localparam int RowBits   = ptm_unit_front_pkg::RowBits,
  localparam int LineWidth = ptm_unit_front_pkg::LineWidth,
  localparam int BankWidth = ptm_unit_front_pkg::BankWidth
) (
  input  logic                       clk_i,
  // A line from K
  input  logic                       write_i,
  input  logic [RowBits-1:0]         write_row_i,
  input  logic [LineWidth-1:0]       line_i,
  // F takes over a beat; D does
  input  logic                       f_load_i,
  input  ptm_unit_front_pkg::reads_t reads_i,
  input  logic                       d_load_i,
  output ptm_unit_pkg::taps_t        taps_o
);
  localparam int PlaceBits = $clog2(Rows);

  ptm_unit_front_pkg::reads_t reads_q;
  always_ff @(posedge clk_i) if (f_load_i) reads_q <= reads_i;

  // Of each tap: its data bank, and its word in that bank's row
  logic [7:0] bank, word, bank_q;
  for (genvar tap = 0; tap < 4; tap++) begin : gen_tap
    logic [1:0] i, j;
    assign i                = reads_q.i[tap%2];
    assign j                = reads_q.j[tap/2];
    assign bank[tap*2 +: 2] = {j[0], i[0]};
    assign word[tap*2 +: 2] = {j[1], i[1]};
  end
  logic [3:0] fetched_q;
  always_ff @(posedge clk_i) begin
    if (d_load_i) begin
      fetched_q <= reads_q.fetched;
      bank_q    <= bank;
    end
  end

  logic [127:0] bank_words;  // of each bank, the word that its taps want
  for (genvar b = 0; b < 4; b++) begin : gen_bank
    // Taps of one bank are the same texel
    logic [3:0] here;
    for (genvar tap = 0; tap < 4; tap++) begin : gen_here
      assign here[tap] = reads_q.fetched[tap] && bank[tap*2 +: 2] == 2'(b);
    end
    logic [1:0]         tap;
    logic [RowBits-1:0] row;
    assign tap = here[0] ? 2'd0 : here[1] ? 2'd1 : here[2] ? 2'd2 : 2'd3;
    assign row = reads_q.row[tap];
    // Words of the line with the bank's parities, in the order {j[1], i[1]}
    logic [BankWidth-1:0] words, read;
    for (genvar w = 0; w < 4; w++) begin : gen_word
      localparam int Word = ((w / 2) * 2 + b / 2) * 4 + (w % 2) * 2 + b % 2;
      assign words[w*32 +: 32] = line_i[Word*32 +: 32];
    end
    ptm_unit_data_bank #(
      .Rows(Rows)
    ) u_bank (
      .clk_i(clk_i), .write_i(write_i), .write_row_i(write_row_i[PlaceBits-1:0]),
      .write_data_i(words), .read_i(d_load_i && here != 4'd0), .read_row_i(row[PlaceBits-1:0]),
      .read_data_o(read)
    );
    logic [1:0] word_q;
    always_ff @(posedge clk_i) if (d_load_i) word_q <= word[tap*2 +: 2];
    assign bank_words[b*32 +: 32] = read[word_q*32 +: 32];
  end

  logic [127:0] tap_words;
  for (genvar tap = 0; tap < 4; tap++) begin : gen_word
    assign tap_words[tap*32 +: 32] = bank_words[bank_q[tap*2 +: 2]*32 +: 32];
  end
  always_comb begin
    taps_o         = '0;
    taps_o.fetched = fetched_q;
    taps_o.word    = tap_words;
  end
endmodule
