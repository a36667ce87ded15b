// Which taps a palette looks up in which look-up cycle of their beat.
//
//   n = max(1, ceil(taps / Ports)) cycles; cycle k takes the fetched taps k * Ports ..
//   in order 00 10 01 11                                 docs/spec/unit-timing.md, Palette
//
// Twin: the palette's part of D in model/pipeline. Combinational.
module ptm_filter_palette_schedule #(
  parameter int Ports     = 4,  // 1, 2, 4
  parameter int IndexBits = 10
) (
  input  logic [3:0]                 fetched_i,
  input  logic [1:0]                 step_i,   // k
  input  logic [4*IndexBits-1:0]     index_i,  // a tap, 00 lowest
  output logic                       last_o,   // step k is the last
  output logic [3:0]                 now_o,    // taps that are looked up in this step
  output logic [7:0]                 port_o,   // 2 bits a tap: by which port
  output logic [Ports-1:0]           read_o,   // the port has something to look up
  output logic [Ports*IndexBits-1:0] index_o   // a port; anything where it has nothing to do
);
  if (Ports == 4) begin : gen_all
    // A port of its own for each tap
    assign last_o  = 1'b1;
    assign now_o   = fetched_i;
    assign port_o  = {2'd3, 2'd2, 2'd1, 2'd0};
    assign read_o  = fetched_i;
    assign index_o = index_i;
    logic unused;
    assign unused = ^step_i;
  end else begin : gen_some
    localparam int Log2 = $clog2(Ports);
    // Without taps nothing moves, and nothing is simulated
    logic [1:0] rank [4];  // fetched taps before a tap
    logic [2:0] count;     // all of them
    logic [4:0] more;      // the fewest taps for which another step is needed, less one
    always_comb begin
      {count, more, now_o, port_o, read_o, index_o} = '0;
      for (int t = 0; t < 4; t++) rank[t] = 2'd0;
      last_o = 1'b1;
      if (fetched_i != '0) begin
        for (int t = 1; t < 4; t++) rank[t] = rank[t-1] + 2'(fetched_i[t-1]);
        count  = 3'(rank[3]) + 3'(fetched_i[3]);
        more   = (5'(step_i) + 5'd1) << Log2;
        last_o = 5'(count) <= more;
        for (int t = 0; t < 4; t++) begin
          now_o[t]         = fetched_i[t] && rank[t] >> Log2 == step_i;
          port_o[2*t +: 2] = rank[t] & 2'(Ports - 1);
          for (int p = 0; p < Ports; p++) begin
            if (now_o[t] && port_o[2*t +: 2] == 2'(p)) begin
              read_o[p] = 1'b1;
              index_o[p*IndexBits +: IndexBits] = index_i[t*IndexBits +: IndexBits];
            end
          end
        end
      end
    end
  end
endmodule
