// How many fragments are inside: accepted, and their pixel not taken yet.
module ptm_front_inside (
  input  logic clk_i,
  input  logic rst_ni,
  input  logic accepted_i,
  input  logic taken_i,
  output logic busy_o,        // fragments are inside
  output logic last_taken_o   // the last of them leaves as a pixel, and none enters
);
  logic [15:0] inside_q;
  assign busy_o       = inside_q != '0;
  assign last_taken_o = taken_i && !accepted_i && inside_q == 16'd1;
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) inside_q <= '0;
    else inside_q <= inside_q + 16'(accepted_i) - 16'(taken_i);
  end
endmodule
