// F and D: reads a beat's texels from the data banks of the TMUs' caches.
//
// Four banks a TMU by texel parity; a line is a row in each. F reads as it leaves for D, K writes
// at the end of the cycle in which it commits; a read sees what stood before. D holds the rows and
// picks the taps' words. docs/spec/unit-timing.md, Commit and fetch.
module ptm_unit_fetch #(
  parameter int Tmus = 3,
  parameter int Rows = 256,  // lines of a TMU's cache
  localparam int RowBits   = ptm_unit_front_pkg::RowBits,
  localparam int LineWidth = ptm_unit_front_pkg::LineWidth,
  localparam int BankWidth = ptm_unit_front_pkg::BankWidth
) (
  input  logic                clk_i,
  input  logic                rst_ni,
  // Lines from K
  input  logic                           commit_i,
  input  logic [Tmus-1:0]                rank_i,
  input  logic [Tmus-1:0][RowBits-1:0]   row_i,
  input  logic [Tmus-1:0][LineWidth-1:0] line_i,
  // Beat
  input  logic                valid_i,
  output logic                ready_o,
  input  ptm_unit_pkg::beat_t beat_i,
  input  ptm_unit_front_pkg::reads_t [Tmus-1:0] reads_i,
  // D
  output logic                valid_o,
  input  logic                ready_i,
  output ptm_unit_pkg::beat_t beat_o,
  output ptm_unit_pkg::taps_t [Tmus-1:0] taps_o
);
  localparam int PlaceBits = $clog2(Rows);

  logic                f_valid, f_ready, f_load, d_load;
  ptm_unit_pkg::beat_t f_beat_q, d_beat_q;
  ptm_unit_front_pkg::reads_t [Tmus-1:0] f_reads_q;
  ptm_stream_reg u_f (
    .clk_i(clk_i), .rst_ni(rst_ni), .valid_i(valid_i), .ready_o(ready_o), .load_o(f_load),
    .valid_o(f_valid), .ready_i(f_ready)
  );
  ptm_stream_reg u_d (
    .clk_i(clk_i), .rst_ni(rst_ni), .valid_i(f_valid), .ready_o(f_ready), .load_o(d_load),
    .valid_o(valid_o), .ready_i(ready_i)
  );
  always_ff @(posedge clk_i) begin
    if (f_load) begin
      f_beat_q  <= beat_i;
      f_reads_q <= reads_i;
    end
    if (d_load) d_beat_q <= f_beat_q;
  end
  assign beat_o = d_beat_q;

  for (genvar t = 0; t < Tmus; t++) begin : gen_tmu
    ptm_unit_front_pkg::reads_t reads;
    assign reads = f_reads_q[t];

    // Of each tap: its data bank and its word in that bank's row
    logic [3:0][1:0] bank, word;
    logic [3:0]      fetched_q;
    logic [3:0][1:0] bank_q, word_q;
    for (genvar tap = 0; tap < 4; tap++) begin : gen_tap
      assign bank[tap] = {reads.j[tap/2][0], reads.i[tap%2][0]};
      assign word[tap] = {reads.j[tap/2][1], reads.i[tap%2][1]};
    end
    always_ff @(posedge clk_i) begin
      if (d_load) begin
        fetched_q <= reads.fetched;
        bank_q    <= bank;
        word_q    <= word;
      end
    end

    logic [3:0][BankWidth-1:0] row;
    for (genvar b = 0; b < 4; b++) begin : gen_bank
      // Taps of one bank are the same texel
      logic [3:0] here;
      for (genvar tap = 0; tap < 4; tap++) begin : gen_here
        assign here[tap] = reads.fetched[tap] && bank[tap] == 2'(b);
      end
      logic [1:0] tap;
      assign tap = here[0] ? 2'd0 : here[1] ? 2'd1 : here[2] ? 2'd2 : 2'd3;
      // Words of the line at (j, i) with the bank's parities, in the order {j[1], i[1]}
      logic [BankWidth-1:0] words;
      for (genvar w = 0; w < 4; w++) begin : gen_word
        localparam int Word = ((w / 2) * 2 + b / 2) * 4 + (w % 2) * 2 + b % 2;
        assign words[w*32 +: 32] = line_i[t][Word*32 +: 32];
      end
      ptm_unit_data_bank #(
        .Rows(Rows)
      ) u_bank (
        .clk_i(clk_i), .write_i(commit_i && rank_i[t]), .write_row_i(row_i[t][PlaceBits-1:0]),
        .write_data_i(words), .read_i(d_load && here != 4'd0),
        .read_row_i(reads.row[tap][PlaceBits-1:0]), .read_data_o(row[b])
      );
    end

    always_comb begin
      taps_o[t]         = '0;
      taps_o[t].fetched = fetched_q;
      for (int tap = 0; tap < 4; tap++) begin
        taps_o[t].word[tap] = row[bank_q[tap]][32 * word_q[tap] +: 32];
      end
    end
  end
endmodule
