// What ptm_stream_chain promises its owner, for every pattern of valid and ready, for all time.
//
// The payloads lie with the owner and move where load_o says so. `holds_q` follows them: whether
// stage n's register holds an item that has not yet moved on.
module ptm_stream_chain_properties #(
  parameter int Stages = 7
) (
  input  logic clk_i,
  input  logic valid_i,
  input  logic ready_i,
  output logic bad_o
);
  logic running_q = 1'b0;  // cycle 0 is reset
  always_ff @(posedge clk_i) running_q <= 1'b1;

  logic            ready, valid;
  logic [1:Stages] load;
  ptm_stream_chain #(
    .Stages(Stages)
  ) u_chain (
    .clk_i(clk_i), .rst_ni(running_q), .valid_i(valid_i), .ready_o(ready), .load_o(load),
    .valid_o(valid), .ready_i(ready_i)
  );

  // Item n: 0 is offered from in front, n is in register n. It leaves when the next register loads
  // it, the last one's when it is taken.
  logic [1:Stages] holds_q = '0;
  logic [0:Stages] holds, leaves;
  assign holds  = {valid_i, holds_q};
  assign leaves = {load, valid && ready_i};
  always_ff @(posedge clk_i) begin
    if (running_q) holds_q <= load | (holds_q & ~leaves[1:Stages]);
  end

  logic made_up, overwritten, wrong_valid, wrong_ready, idle;
  assign made_up     = |(leaves & ~holds);                           // loads what is not there
  assign overwritten = |(load & holds_q & ~leaves[1:Stages]);        // loads over what stays
  assign wrong_valid = valid != holds_q[Stages];
  assign wrong_ready = (valid_i && ready) != load[1];
  // Moves whatever can: a register keeps its item only if it and all behind it are full and the
  // end refuses.
  logic [1:Stages] blocked;
  for (genvar n = 1; n <= Stages; n++) begin : gen_blocked
    assign blocked[n] = &holds_q[n:Stages] && !ready_i;
  end
  assign idle = (holds_q & ~leaves[1:Stages]) != blocked || ready != !blocked[1];

  assign bad_o = running_q && (made_up || overwritten || wrong_valid || wrong_ready || idle);
endmodule
