// One word of every entry of a palette: three coefficients. A write port, Ports read ports.
//
// Reading is combinational; the register behind it is the tap's place in P or the one that holds
// it (ptm_tap_hold). Written while no fragment is inside (docs/spec/unit.md, Registers).
module ptm_palette_word #(
  parameter int IndexBits = 10,
  parameter int Width     = 24,
  parameter int Ports     = 4
) (
  input  logic                       clk_i,
  input  logic                       we_i,
  input  logic [IndexBits-1:0]       write_index_i,
  input  logic [Width-1:0]           write_data_i,
  input  logic [Ports*IndexBits-1:0] index_i,
  output logic [Ports*Width-1:0]     data_o
);
  logic [Width-1:0] table_q [1 << IndexBits];
  always_ff @(posedge clk_i) begin
    if (we_i) table_q[write_index_i] <= write_data_i;
  end
  for (genvar p = 0; p < Ports; p++) begin : gen_port
    assign data_o[p*Width +: Width] = table_q[index_i[p*IndexBits +: IndexBits]];
  end
endmodule
