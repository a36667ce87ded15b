// A memory with a write port and a read port, in one clock: what FPGA tools map to block RAM and an
// ASIC team replaces by a macro. Every memory of the unit of more than 2 kbit is one of these.
//
//   a write in cycle c stands there from c + 1 on
//   a read in cycle c shows in c + 1, and until the cycle after the next read
//   a read in the cycle of a write to the same address shows what stood there before
//
// Nothing is reset: what was never written reads as X. Addresses are below Depth.
// ptm_memory_register_file is for small ones, which are read in the same cycle.
(* memory_macro *)
module ptm_memory_ram #(
  parameter int Depth = 256,  // 1 or more
  parameter int Width = 32,
  localparam int AddressBits = Depth == 1 ? 1 : $clog2(Depth)
) (
  input  logic                   clk_i,
  input  logic                   write_i,
  input  logic [AddressBits-1:0] write_address_i,
  input  logic [Width-1:0]       write_data_i,
  input  logic                   read_i,
  input  logic [AddressBits-1:0] read_address_i,
  output logic [Width-1:0]       read_data_o
);
  logic [Width-1:0] word_q [Depth];
  logic [Width-1:0] read_q;
  always_ff @(posedge clk_i) begin
    if (read_i) read_q <= word_q[read_address_i];
    // (Blocking, behind the read: a simulation then needs no copy of what is written.)
    /* verilator lint_off BLKSEQ */
    if (write_i) word_q[write_address_i] = write_data_i;
    /* verilator lint_on BLKSEQ */
  end
  assign read_data_o = read_q;
endmodule
