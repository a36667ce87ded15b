// The event register, its enable register and the interrupt: docs/spec/unit.md, Events.
//
// A bit is set at the end of the cycle in which its cause is seen and stays until it is cleared by
// writing 1 to it; one that is set and cleared in the same cycle is set. irq_o is high while any
// bit is set whose enable bit is. It depends on registers alone.
module ptm_registers_events #(
  localparam int Events = ptm_register_pkg::EventsW
) (
  input  logic              clk_i,
  input  logic              rst_ni,
  input  logic [Events-1:0] causes_i,
  input  logic              we_events_i,  // clears the bits that are 1 in wdata_i
  input  logic              we_enable_i,
  input  logic [Events-1:0] wdata_i,
  output logic [Events-1:0] events_o,
  output logic [Events-1:0] enable_o,
  output logic              irq_o
);
  logic [Events-1:0] events_q, enable_q;
  assign events_o = events_q;
  assign enable_o = enable_q;
  assign irq_o    = (events_q & enable_q) != '0;

  logic [Events-1:0] kept;
  assign kept = we_events_i ? events_q & ~wdata_i : events_q;
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      events_q <= '0;
      enable_q <= '0;
    end else begin
      if (we_events_i || causes_i != '0) events_q <= kept | causes_i;
      if (we_enable_i) enable_q <= wdata_i;
    end
  end
endmodule
