// U8 and U9 for one field of a fragment, registers L3 and O included: 1 multiply.
//
//   |L2| lerp(first, second, f) |L3| narrow(sum of the probes, probes_log2) |O|
//                                                                   docs/spec/unit.md, U8 and U9
//
// The first footprint's value is kept as its beat moves from L2 to L3. What a footprint adds to the
// sum is decided there too, by the caller: a texture with two footprints (f is not 0) adds the
// mixture with its second, one without adds its first. A field that the draw does not have holds
// anything.
// Twin: level and probe filtering in model/reference/unit/.
module ptm_filter_field #(
  parameter int Width        = 8,
  parameter int RoundNearest = 1
) (
  input  logic             clk_i,
  // The beat in L2 that enters L3
  input  logic             brings_i,       // it does, and brings this field
  input  logic             second_i,       // in its second footprint
  input  logic [7:0]       f_i,
  input  logic [Width-1:0] value_i,
  // The beat in L3
  input  logic             leave_l3_i,
  input  logic             adds_i,         // the field's value to the sum
  input  logic             first_probe_i,
  input  logic [2:0]       probes_log2_i,
  // The fragment that enters O
  input  logic             load_o_i,
  input  logic             replace_i,      // by this, U10
  input  logic [Width-1:0] replacement_i,
  output logic [Width-1:0] field_o
);
  localparam int SumW = Width + 4;  // of 16 probes

  logic [Width-1:0] first_q, mixed, l3_value_q, o_q;
  ptm_arith_lerp #(.Width(Width), .RoundNearest(RoundNearest))
    u_level (.a_i(first_q), .b_i(value_i), .f_i(f_i), .y_o(mixed));

  logic [SumW-1:0] sum_q, sum;
  assign sum = !adds_i ? sum_q : (first_probe_i ? '0 : sum_q) + SumW'(l3_value_q);

  logic signed [Width:0] mean;  // with a sign that stays 0
  ptm_arith_narrow #(
    .InBits(SumW + 1), .AmountBits(3), .OutBits(Width + 1), .RoundNearest(RoundNearest)
  ) u_narrow (
    .x_i({1'b0, sum}), .amount_i(probes_log2_i), .y_o(mean)
  );

  always_ff @(posedge clk_i) begin
    if (brings_i) begin
      l3_value_q <= second_i ? mixed : value_i;
      if (!second_i) first_q <= value_i;
    end
    if (leave_l3_i && adds_i) sum_q <= sum;
    if (load_o_i) o_q <= replace_i ? replacement_i : mean[Width-1:0];
  end
  assign field_o = o_q;

  logic unused_sign;
  assign unused_sign = mean[Width];
endmodule
