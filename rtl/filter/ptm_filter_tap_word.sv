// One tap's word in Q and P (docs/spec/unit-timing.md, Palette). The sub-beats of a beat bring
// their taps to Q one after the other; P takes over what stands there.
//
// Q's register is not cleared between beats: a tap that no sub-beat fetched has weight 0. It is
// cleared by reset, because 0 times what was never loaded is X to a four-state simulator.
module ptm_filter_tap_word #(
  parameter int Width = 32
) (
  input  logic             clk_i,
  input  logic             rst_ni,
  input  logic             load_q_i,  // data_i is this tap's, of the beat that enters Q
  input  logic             load_p_i,
  input  logic [Width-1:0] data_i,
  output logic [Width-1:0] p_o
);
  logic [Width-1:0] q_q, p_q;
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) q_q <= '0;
    else if (load_q_i) q_q <= data_i;
  end
  always_ff @(posedge clk_i) if (load_p_i) p_q <= q_q;
  assign p_o = p_q;
endmodule
