// Which taps a palette looks up in which cycle of their beat's stay in D.
//
//   n = max(1, ceil(taps / Ports)) cycles; cycle k takes the fetched taps k * Ports ..
//   in order 00 10 01 11                                       docs/spec/unit-timing.md, D
//
// Twin: the palette's part of D in model/pipeline. Combinational.
module ptm_palette_schedule #(
  parameter int Ports     = 4,  // 1, 2, 4
  parameter int IndexBits = 10
) (
  input  logic [3:0]                 fetched_i,
  input  logic [1:0]                 step_i,   // k
  input  logic [4*IndexBits-1:0]     index_i,  // a tap, 00 lowest
  output logic                       last_o,   // step k is the last
  output logic [3:0]                 now_o,    // taps that are looked up in this step
  output logic [7:0]                 port_o,   // 2 bits a tap: by which port
  output logic [Ports*IndexBits-1:0] index_o   // a port; anything where it has nothing to do
);
  // Fetched taps before tap t, and all of them
  logic [2:0] count;
  logic [1:0] rank1, rank2, rank3;
  assign rank1 = {1'b0, fetched_i[0]};
  assign rank2 = rank1 + {1'b0, fetched_i[1]};
  assign rank3 = rank2 + {1'b0, fetched_i[2]};
  assign count = {1'b0, rank3} + {2'b0, fetched_i[3]};

  if (Ports == 4) begin : gen_all
    // A port of its own for each tap
    assign last_o  = 1'b1;
    assign now_o   = fetched_i;
    assign port_o  = {2'd3, 2'd2, 2'd1, 2'd0};
    assign index_o = index_i;
    logic unused;
    assign unused = ^{count, step_i};
  end else begin : gen_some
    localparam int Log2 = $clog2(Ports);
    logic [7:0] rank;
    logic [4:0] more;  // the fewest taps for which another step is needed, less one
    assign rank   = {rank3, rank2, rank1, 2'd0};
    assign more   = (5'(step_i) + 5'd1) << Log2;
    assign last_o = 5'(count) <= more;
    for (genvar t = 0; t < 4; t++) begin : gen_tap
      assign now_o[t]         = fetched_i[t] && rank[2*t +: 2] >> Log2 == step_i;
      assign port_o[2*t +: 2] = rank[2*t +: 2] & 2'(Ports - 1);
    end
    for (genvar p = 0; p < Ports; p++) begin : gen_port
      logic [IndexBits-1:0] index;
      always_comb begin
        index = '0;
        if (fetched_i != '0) begin
          for (int t = 0; t < 4; t++) begin
            if (now_o[t] && port_o[2*t +: 2] == 2'(p)) index = index_i[t*IndexBits +: IndexBits];
          end
        end
      end
      assign index_o[p*IndexBits +: IndexBits] = index;
    end
  end
endmodule
