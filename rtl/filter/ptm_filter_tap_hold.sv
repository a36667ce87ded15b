// One tap's part of a palette word, from the palette's output to P (docs/spec/unit-timing.md,
// Palette): what the beat's last look-up cycle asked for is still shown when the beat leaves Q,
// what an earlier one asked for is kept here in the cycle in which it is shown.
//
// hold_q is not cleared between beats: a tap that no sub-beat fetched has weight 0. It is cleared
// by reset, because 0 times what was never loaded is X to a four-state simulator.
module ptm_filter_tap_hold #(
  parameter int Width = 24
) (
  input  logic             clk_i,
  input  logic             rst_ni,
  input  logic             shown_i,   // data_i is this tap's
  input  logic             hold_i,    // in this cycle only
  input  logic             load_p_i,  // the beat leaves Q
  input  logic [Width-1:0] data_i,
  output logic [Width-1:0] p_o
);
  logic [Width-1:0] hold_q, p_q;
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) hold_q <= '0;
    else if (hold_i && shown_i) hold_q <= data_i;
  end
  always_ff @(posedge clk_i) begin
    if (load_p_i) p_q <= shown_i ? data_i : hold_q;
  end
  assign p_o = p_q;
endmodule
