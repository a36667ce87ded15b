// One data bank of one TMU's cache: a line's four words of one texel parity a row. One port to
// write, one to read; a read in the cycle of a write gives what stood there before. The read
// register is D.
module ptm_unit_data_bank #(
  parameter int Rows = 256,
  localparam int RowBits = $clog2(Rows),
  localparam int Width   = ptm_unit_front_pkg::BankWidth
) (
  input  logic               clk_i,
  input  logic               write_i,
  input  logic [RowBits-1:0] write_row_i,
  input  logic [Width-1:0]   write_data_i,
  input  logic               read_i,
  input  logic [RowBits-1:0] read_row_i,
  output logic [Width-1:0]   read_data_o
);
  logic [Width-1:0] row_q [Rows];
  logic [Width-1:0] read_q;
  always_ff @(posedge clk_i) begin
    if (write_i) row_q[write_row_i] <= write_data_i;
    if (read_i) read_q <= row_q[read_row_i];
  end
  assign read_data_o = read_q;
endmodule
