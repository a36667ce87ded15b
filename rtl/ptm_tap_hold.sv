// One tap's word, or one word of its palette entry: what D brings of it in its last cycle, or what
// was held of it since an earlier cycle or sub-beat, goes to P (docs/spec/unit-timing.md, D).
//
// hold_q is not cleared between beats: a tap that no sub-beat fetched has weight 0. It is cleared by
// reset, because 0 times what was never loaded is X to a four-state simulator.
module ptm_tap_hold #(
  parameter int Width = 32
) (
  input  logic             clk_i,
  input  logic             rst_ni,
  input  logic             now_i,     // data_i is this tap's
  input  logic             hold_i,    // keep it for a later cycle
  input  logic             load_p_i,  // the beat enters P
  input  logic [Width-1:0] data_i,
  output logic [Width-1:0] p_o
);
  logic [Width-1:0] hold_q, p_q;
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) hold_q <= '0;
    else if (hold_i && now_i) hold_q <= data_i;
  end
  always_ff @(posedge clk_i) begin
    if (load_p_i) p_q <= now_i ? data_i : hold_q;
  end
  assign p_o = p_q;
endmodule
