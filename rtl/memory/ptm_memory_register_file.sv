// A small memory with a write port and a read port that answers in the same cycle: flip-flops or
// distributed RAM, at most 2 kbit. Larger ones are ptm_memory_ram.
//
// A write in cycle c stands there from c + 1 on. Nothing is reset: what was never written reads as
// X. Addresses are below Depth.
module ptm_memory_register_file #(
  parameter int Depth = 32,  // 1 or more
  parameter int Width = 4,
  localparam int AddressBits = Depth == 1 ? 1 : $clog2(Depth)
) (
  input  logic                   clk_i,
  input  logic                   write_i,
  input  logic [AddressBits-1:0] write_address_i,
  input  logic [Width-1:0]       write_data_i,
  input  logic [AddressBits-1:0] read_address_i,
  output logic [Width-1:0]       read_data_o
);
  logic [Width-1:0] word_q [Depth];
  always_ff @(posedge clk_i) if (write_i) word_q[write_address_i] <= write_data_i;
  assign read_data_o = word_q[read_address_i];
endmodule
