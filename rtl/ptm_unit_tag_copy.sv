// A copy of a tag bank's tags, which says whether a line stands there that another TMU misses: for
// the counter `duplicate_lines` alone. Read in the cycle of that look-up, it shows what stood there
// at the cycle's start, and is compared in the next. Used by ptm_unit_tag_bank.
module ptm_unit_tag_copy #(
  parameter int Sets = 32,
  parameter int Ways = 2,
  localparam int SetIndexBits = Sets == 1 ? 1 : $clog2(Sets),
  localparam int LineBits     = ptm_unit_pkg::LineBits
) (
  input  logic                    clk_i,
  input  logic                    rst_ni,
  // The bank allocates
  input  logic [Ways-1:0]         write_i,
  input  logic [SetIndexBits-1:0] write_set_i,
  input  logic [LineBits-1:0]     write_line_i,
  // A miss, and in the next cycle its line
  input  logic                    read_i,
  input  logic [SetIndexBits-1:0] read_set_i,
  input  logic [Ways-1:0]         valid_i,  // of that set's ways
  input  logic [LineBits-1:0]     line_i,
  output logic                    held_o    // in the next cycle, if there was a miss
);
  logic [Ways*LineBits-1:0] tag;
  for (genvar w = 0; w < Ways; w++) begin : gen_way
    ptm_ram #(
      .Depth(Sets), .Width(LineBits)
    ) u_tag (
      .clk_i(clk_i), .write_i(write_i[w]), .write_address_i(write_set_i),
      .write_data_i(write_line_i), .read_i(read_i), .read_address_i(read_set_i),
      .read_data_o(tag[w*LineBits +: LineBits])
    );
  end

  logic [Ways-1:0] valid_q;  // and there was a miss
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) valid_q <= '0;
    else valid_q <= read_i ? valid_i : '0;
  end
  always_comb begin
    held_o = 1'b0;
    if (valid_q != '0) begin
      for (int w = 0; w < Ways; w++) begin
        if (valid_q[w] && tag[w*LineBits +: LineBits] == line_i) held_o = 1'b1;
      end
    end
  end
endmodule
