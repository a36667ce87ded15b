// One data bank of one TMU's cache: a line's four words of one texel parity a row, and whether the
// line could not be read. One port to write rows, one to read them; a read in the cycle of a write
// gives what stood there before. The read register is D, behind which the word is chosen.
module ptm_front_data_bank #(
  parameter int Rows = 256,
  parameter int Bank = 0,  // {parity in v, parity in u}
  localparam int RowBits   = $clog2(Rows),
  localparam int LineWidth = ptm_front_pkg::LineWidth
) (
  input  logic                 clk_i,
  input  logic                 write_i,
  input  logic [RowBits-1:0]   write_row_i,
  input  logic [LineWidth-1:0] line_i,
  input  logic                 failed_i,
  input  logic                 read_i,
  input  logic [RowBits-1:0]   read_row_i,
  input  logic [1:0]           read_word_i,  // {j[1], i[1]}
  output logic [31:0]          read_data_o,
  output logic                 read_failed_o
);
  localparam int First = Bank / 2 * 4 + Bank % 2;  // word of the line

  logic [128:0] written, row;  // a bit of failure, four words
  always_comb begin
    written = '0;
    if (write_i) begin
      written = {failed_i, line_i[32*(First+10) +: 32], line_i[32*(First+8) +: 32],
                 line_i[32*(First+2) +: 32], line_i[32*First +: 32]};
    end
  end
  ptm_memory_ram #(
    .Depth(Rows), .Width(129)
  ) u_row (
    .clk_i(clk_i), .write_i(write_i), .write_address_i(write_row_i),
    .write_data_i(written), .read_i(read_i), .read_address_i(read_row_i), .read_data_o(row)
  );
  logic [1:0] word_q;
  always_ff @(posedge clk_i) if (read_i) word_q <= read_word_i;
  assign read_data_o   = row[{1'b0, word_q, 5'd0} +: 32];
  assign read_failed_o = row[128];

  logic unused;
  assign unused = ^line_i;
endmodule
