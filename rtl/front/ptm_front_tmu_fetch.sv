// One TMU's part of F and D: its four data banks by texel parity, a line being a row in each, and
// the choice of the taps' words. Used by ptm_front_fetch, which moves the beats.
//
// K writes at the end of the cycle in which it commits; F reads as it leaves for D, and sees what
// stood before. docs/spec/unit-timing.md, Commit and fetch.
module ptm_front_tmu_fetch #(
  parameter int Rows = 256,  // lines of the cache
  localparam int RowBits   = ptm_front_pkg::RowBits,
  localparam int LineWidth = ptm_front_pkg::LineWidth
) (
  input  logic                         clk_i,
  // A line from K
  input  logic                         write_i,
  input  logic [RowBits-1:0]           write_row_i,
  input  logic [LineWidth-1:0]         line_i,
  input  logic                         failed_i,  // it could not be read
  // F takes over a beat; D does
  input  logic                         f_load_i,
  input  ptm_front_pkg::reads_t   reads_i,
  output logic                         f_color_o,  // its word in F is of the colour texture
  input  ptm_front_pkg::sources_t sources_i,  // that texture's: ptm_front_taps
  input  logic                         d_load_i,
  output ptm_unit_pkg::taps_t          taps_o,
  output logic                         failed_o   // a fetched tap's line could not be read
);
  localparam int PlaceBits = $clog2(Rows);
  localparam int LineBits  = PlaceBits - 2;  // of a line's place within its tag bank

  ptm_front_pkg::reads_t reads_q;
  logic [3:0]                 read;         // data banks that D's next beat wants
  logic [3:0]                 d_fetched_q;  // by tap
  logic [3:0]                 d_read_q;     // data banks that were read
  logic [7:0]                 d_bank_q;     // by tap: its data bank
  always_ff @(posedge clk_i) begin
    if (f_load_i) reads_q <= reads_i;
    if (d_load_i) begin
      d_fetched_q <= reads_q.fetched ? sources_i.fetched : '0;
      d_bank_q    <= sources_i.bank;
      d_read_q    <= read;
    end
  end
  assign f_color_o = reads_q.color;

  logic [15:0] at;             // by bank: {tile, word}
  logic [31:0] bank_word [4];  // of each bank, the word that its taps want
  logic [3:0]  bank_failed;    // and whether its line could not be read
  assign read = d_load_i && reads_q.fetched ? sources_i.here : '0;
  assign at   = sources_i.at;
  for (genvar b = 0; b < 4; b++) begin : gen_bank
    logic [1:0]           tile;
    logic [PlaceBits-1:0] row;
    assign tile = at[b*4+2 +: 2];
    assign row  = {tile, LineBits'(reads_q.place[tile])};
    ptm_front_data_bank #(
      .Rows(Rows), .Bank(b)
    ) u_bank (
      .clk_i(clk_i), .write_i(write_i), .write_row_i(write_row_i[PlaceBits-1:0]),
      .line_i(line_i), .failed_i(failed_i), .read_i(read[b]), .read_row_i(row),
      .read_word_i(at[b*4 +: 2]), .read_data_o(bank_word[b]), .read_failed_o(bank_failed[b])
    );
  end

  always_comb begin
    taps_o         = '0;
    taps_o.fetched = d_fetched_q;
    taps_o.word    = {bank_word[d_bank_q[7:6]], bank_word[d_bank_q[5:4]],
                      bank_word[d_bank_q[3:2]], bank_word[d_bank_q[1:0]]};
  end

  assign failed_o = (bank_failed & d_read_q) != '0;
endmodule
