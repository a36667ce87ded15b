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
  output logic                       f_color_o,   // its word in F is of the colour texture
  input  logic [3:0]                 here_i,      // that texture's: ptm_unit_taps
  input  logic [7:0]                 tag_bank_i,
  input  logic                       d_load_i,
  output logic                       d_color_o,   // likewise in D
  input  logic [3:0]                 fetched_i,
  input  logic [7:0]                 word_i,
  input  logic [7:0]                 bank_i,
  output ptm_unit_pkg::taps_t        taps_o
);
  localparam int PlaceBits = $clog2(Rows);
  localparam int LineBits  = PlaceBits - 2;  // of a line's place within its tag bank

  ptm_unit_front_pkg::reads_t reads_q;
  logic                       d_fetched_q, d_color_q;
  always_ff @(posedge clk_i) begin
    if (f_load_i) reads_q <= reads_i;
    if (d_load_i) begin
      d_fetched_q <= reads_q.fetched;
      d_color_q   <= reads_q.color;
    end
  end
  assign f_color_o = reads_q.color;
  assign d_color_o = d_color_q;

  logic read;
  assign read = d_load_i && reads_q.fetched;
  logic [31:0] bank_word [4];  // of each bank, the word that its taps want
  for (genvar b = 0; b < 4; b++) begin : gen_bank
    logic [1:0]           tag_bank;
    logic [PlaceBits-1:0] row;
    assign tag_bank = tag_bank_i[b*2 +: 2];
    assign row      = {tag_bank, LineBits'(reads_q.place[tag_bank])};
    // Words of the line with the bank's parities, in the order {j[1], i[1]}
    logic [BankWidth-1:0] words, read_words;
    for (genvar w = 0; w < 4; w++) begin : gen_word
      localparam int Word = ((w / 2) * 2 + b / 2) * 4 + (w % 2) * 2 + b % 2;
      assign words[w*32 +: 32] = line_i[Word*32 +: 32];
    end
    ptm_unit_data_bank #(
      .Rows(Rows)
    ) u_bank (
      .clk_i(clk_i), .write_i(write_i), .write_row_i(write_row_i[PlaceBits-1:0]),
      .write_data_i(words), .read_i(read && here_i[b]), .read_row_i(row),
      .read_data_o(read_words)
    );
    assign bank_word[b] = read_words[word_i[b*2 +: 2]*32 +: 32];
  end

  always_comb begin
    taps_o         = '0;
    taps_o.fetched = d_fetched_q ? fetched_i : 4'd0;
    taps_o.word    = {bank_word[bank_i[7:6]], bank_word[bank_i[5:4]], bank_word[bank_i[3:2]],
                      bank_word[bank_i[1:0]]};
  end
endmodule
