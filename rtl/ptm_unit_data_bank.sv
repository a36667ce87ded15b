// One data bank of one TMU's cache: a line's four words of one texel parity a row. One port to
// write rows, one to read words; a read in the cycle of a write gives what stood there before. The
// read register is D.
module ptm_unit_data_bank #(
  parameter int Rows = 256,
  parameter int Bank = 0,  // {parity in v, parity in u}
  localparam int RowBits   = $clog2(Rows),
  localparam int LineWidth = ptm_unit_front_pkg::LineWidth
) (
  input  logic                 clk_i,
  input  logic                 write_i,
  input  logic [RowBits-1:0]   write_row_i,
  input  logic [LineWidth-1:0] line_i,
  input  logic                 read_i,
  input  logic [RowBits-1:0]   read_row_i,
  input  logic [1:0]           read_word_i,  // {j[1], i[1]}
  output logic [31:0]          read_data_o
);
  localparam int First = Bank / 2 * 4 + Bank % 2;  // word of the line

  logic [31:0] word_q [4*Rows];  // {row, word}
  logic [31:0] read_q;
  always_ff @(posedge clk_i) begin
    if (write_i) begin
      for (int w = 0; w < 4; w++) begin
        word_q[{write_row_i, 2'(w)}] <= line_i[32*(First + w / 2 * 8 + w % 2 * 2) +: 32];
      end
    end
    if (read_i) read_q <= word_q[{read_row_i, read_word_i}];
  end
  assign read_data_o = read_q;
endmodule
