// A copy of a tag bank's tags, which says whether a line stands there that another TMU misses: for
// the counter `duplicate_lines` alone. Read in the cycle of that look-up, it shows what stood there
// at the cycle's start, and is compared in the next. Used by ptm_front_tag_bank.
module ptm_front_tag_copy #(
  parameter int Sets = 32,
  parameter int Ways = 2,
  localparam int SetIndexBits = Sets == 1 ? 1 : $clog2(Sets),
  localparam int LineBits     = ptm_unit_pkg::LineBits
) (
  input  logic                    clk_i,
  // The bank allocates
  input  logic                     write_i,
  input  logic [SetIndexBits-1:0]  write_set_i,
  input  logic [Ways*LineBits-1:0] write_tags_i,
  // A look-up, and in the next cycle its line
  input  logic                    read_i,
  input  logic [SetIndexBits-1:0] read_set_i,
  input  logic [Ways-1:0]         valid_i,  // of that set's ways
  input  logic                    show_i,   // there was a look-up
  input  logic [LineBits-1:0]     line_i,
  output logic                    held_o    // else 0
);
  logic [Ways*LineBits-1:0] tag;
  ptm_memory_ram #(
    .Depth(Sets), .Width(Ways * LineBits)
  ) u_tags (
    .clk_i(clk_i), .write_i(write_i), .write_address_i(write_set_i), .write_data_i(write_tags_i),
    .read_i(read_i), .read_address_i(read_set_i), .read_data_o(tag)
  );

  logic [Ways-1:0] valid_q;
  always_ff @(posedge clk_i) if (read_i) valid_q <= valid_i;
  always_comb begin
    held_o = 1'b0;
    if (show_i) begin
      for (int w = 0; w < Ways; w++) begin
        if (valid_q[w] && tag[w*LineBits +: LineBits] == line_i) held_o = 1'b1;
      end
    end
  end
endmodule
