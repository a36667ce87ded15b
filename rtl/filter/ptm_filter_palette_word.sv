// One word of every entry of a palette: three coefficients. A write port, Ports read ports, each of
// which has a copy of the table.
//
// What a port is asked for in cycle c it shows from c + 1 on, until it is asked again. Written
// while no fragment is inside (docs/spec/unit.md, Registers).
module ptm_filter_palette_word #(
  parameter int IndexBits = 10,
  parameter int Width     = 24,
  parameter int Ports     = 4
) (
  input  logic                       clk_i,
  input  logic                       we_i,
  input  logic [IndexBits-1:0]       write_index_i,
  input  logic [Width-1:0]           write_data_i,
  input  logic [Ports-1:0]           read_i,
  input  logic [Ports*IndexBits-1:0] index_i,
  output logic [Ports*Width-1:0]     data_o
);
  for (genvar p = 0; p < Ports; p++) begin : gen_port
    ptm_memory_ram #(.Depth(1 << IndexBits), .Width(Width)) u_ram (
      .clk_i(clk_i), .write_i(we_i), .write_address_i(write_index_i),
      .write_data_i(write_data_i), .read_i(read_i[p]),
      .read_address_i(index_i[p*IndexBits +: IndexBits]), .read_data_o(data_o[p*Width +: Width])
    );
  end
endmodule
