// A quarter of the miss ring's lines: every fourth slot, a row each. K takes them in order.
//
// A line that is written in cycle d is read in d + 1, or in the cycle in which the one before it is
// taken, whichever is later; from the cycle after that it is offered. So K finds it a cycle late,
// and it passes no multiplexer between the memory and K. Used by ptm_front_miss_ring.
`include "ptm_assert.svh"
module ptm_front_miss_bank #(
  parameter int Rows  = 16,
  parameter int Width = 512,
  localparam int RowBits = Rows == 1 ? 1 : $clog2(Rows)
) (
  input  logic               clk_i,
  input  logic               rst_ni,
  // A line arrives for a row that holds none
  input  logic               write_i,
  input  logic [RowBits-1:0] write_row_i,
  input  logic [Width-1:0]   write_line_i,
  input  logic               write_failed_i,
  // The next row's line
  output logic               valid_o,
  input  logic               take_i,  // only while valid_o
  output logic [Width-1:0]   line_o,
  output logic               failed_o  // it could not be read
);
  logic [Rows-1:0]    written_q;  // and not read yet
  logic [RowBits-1:0] row_q, row_after, read_row;
  logic               valid_q, read;
  assign row_after = row_q == RowBits'(Rows - 1) ? '0 : row_q + 1'b1;
  assign read_row  = take_i ? row_after : row_q;
  assign read      = written_q[read_row];
  ptm_memory_ram #(
    .Depth(Rows), .Width(Width + 1)
  ) u_line (
    .clk_i(clk_i), .write_i(write_i), .write_address_i(write_row_i),
    .write_data_i({write_failed_i, write_line_i}), .read_i(read), .read_address_i(read_row),
    .read_data_o({failed_o, line_o})
  );
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      written_q <= '0;
      row_q     <= '0;
      valid_q   <= 1'b0;
    end else begin
      if (read) written_q[read_row] <= 1'b0;
      if (write_i) written_q[write_row_i] <= 1'b1;
      row_q   <= read_row;
      valid_q <= read || (valid_q && !take_i);
    end
  end
  assign valid_o = valid_q;

  `PTM_ASSERT(TakenWhenValid_A, !take_i || valid_o)
  `PTM_ASSERT(OfferedIsWhatWasWritten_A, !valid_o || {failed_o, line_o} == u_line.word_q[row_q])
  `PTM_ASSERT(WrittenWhenEmpty_A,
              !write_i || (!written_q[write_row_i] && !(valid_o && write_row_i == row_q)))
endmodule
