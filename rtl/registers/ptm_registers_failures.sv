// Whether a pixel is made of a line that could not be read: for each fragment, from D to the unit's
// output beside all else, since fragments keep their order.
//
// The bits of a fragment's beats are gathered as they leave D, and kept with its last one until its
// pixel is taken, at least ten cycles later. Between D and the output there are at most 17
// fragments, and one more for each register of effect stages.
// docs/spec/unit-timing.md, Commit and fetch.
`include "ptm_assert.svh"
module ptm_registers_failures (
  input  logic clk_i,
  input  logic rst_ni,
  input  logic leaves_i,  // a beat or sub-beat leaves D
  input  logic failed_i,  // it has such a tap
  input  logic last_i,    // it is the fragment's last
  input  logic taken_i,   // a pixel is taken
  output logic failed_o   // the oldest's
);
  localparam int Depth = 32;

  logic             failed_q;  // of the fragment whose last beat is still to come
  logic [Depth-1:0] kept_q;
  logic [5:0]       write_q, read_q;
  assign failed_o = kept_q[read_q[4:0]];
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      failed_q <= 1'b0;
      kept_q   <= '0;
      write_q  <= '0;
      read_q   <= '0;
    end else begin
      if (leaves_i) begin
        failed_q <= !last_i && (failed_q || failed_i);
        if (last_i) begin
          kept_q[write_q[4:0]] <= failed_q || failed_i;
          write_q              <= write_q + 1'b1;
        end
      end
      if (taken_i) read_q <= read_q + 1'b1;
    end
  end

  `PTM_ASSERT(NeverTooFull_A, 6'(write_q - read_q) <= 6'(Depth))
  `PTM_ASSERT(HoldsWhatIsTaken_A, !taken_i || write_q != read_q)
endmodule
