// What ptm_stream_fifo2 promises: with the registers that its header asks of the owner, items leave
// in the order in which they came, none lost, none twice, for every pattern of valid and ready.
//
// The control does not look at the items, so two bits stand for any payload.
module ptm_stream_fifo2_properties (
  input  logic       clk_i,
  input  logic       valid_i,
  input  logic       ready_i,
  input  logic [1:0] data_i,
  output logic       bad_o
);
  logic running_q = 1'b0;  // cycle 0 is reset
  always_ff @(posedge clk_i) running_q <= 1'b1;

  logic ready, valid, load_head, load_tail, advance;
  ptm_stream_fifo2 u_fifo (
    .clk_i(clk_i), .rst_ni(running_q), .valid_i(valid_i), .ready_o(ready), .load_head_o(load_head),
    .load_tail_o(load_tail), .advance_o(advance), .valid_o(valid), .ready_i(ready_i)
  );

  logic [1:0] head_q, tail_q;
  always_ff @(posedge clk_i) begin
    if (load_head) head_q <= data_i;
    else if (advance) head_q <= tail_q;
    if (load_tail) tail_q <= data_i;
  end

  // A queue of two, as one would write it down
  logic [1:0] count_q = 2'd0, older_q, newer_q;
  logic push, pop;
  assign push = valid_i && ready;
  assign pop  = valid && ready_i;
  always_ff @(posedge clk_i) begin
    if (running_q) begin
      count_q <= count_q + 2'(push) - 2'(pop);
      if (push && (count_q == 2'd0 || pop)) older_q <= data_i;
      else if (pop) older_q <= newer_q;
      if (push) newer_q <= data_i;
    end
  end

  assign bad_o = running_q
      && (valid != (count_q != 2'd0) || ready != (count_q != 2'd2) || (valid && head_q != older_q));
endmodule
