// One tag bank of one TMU's cache: Sets sets of Ways ways, least recently used replaced first.
//
// A look-up is combinational. With update_i it is a use: a hit touches its way at the end of the
// cycle, a miss allocates (an invalid way first, the lowest, else the one used longest ago).
// Invalidation clears all in a cycle. The snoop ports tell whether a line that another TMU misses
// stands here, for the counter `duplicate_lines`. docs/spec/unit-timing.md, Tags.
module ptm_unit_tag_bank #(
  parameter int Sets   = 32,
  parameter int Ways   = 2,   // 1, 2, 4
  parameter int Snoops = 2,   // 1 or more
  localparam int SetBits  = ptm_unit_front_pkg::SetBits,
  localparam int LineBits = ptm_unit_pkg::LineBits
) (
  input  logic                            clk_i,
  input  logic                            rst_ni,
  input  logic                            invalidate_i,
  input  logic                            update_i,
  input  logic [SetBits-1:0]              set_i,
  input  logic [LineBits-1:0]             line_i,
  output logic                            hit_o,
  output logic [ptm_unit_front_pkg::PlaceBits-1:0] place_o,  // {set, way}
  input  logic [Snoops-1:0]               snoop_i,
  input  logic [Snoops*SetBits-1:0]       snoop_set_i,
  input  logic [Snoops*LineBits-1:0]      snoop_line_i,
  output logic [Snoops-1:0]               snoop_held_o
);
  localparam int Lines    = Sets * Ways;
  localparam int PlaceBits = Lines == 1 ? 1 : $clog2(Lines);

  logic [Lines-1:0]    valid_q;          // {set, way}
  logic [LineBits-1:0] tag_q [Lines];
  // Bit {i, j} of a set: way i was used longer ago than way j. Right for every pair of which one
  // was used, so it needs no reset: it is asked only where all ways are valid.
  logic [Ways*Ways-1:0] older_q [Sets];

  function automatic logic [PlaceBits-1:0] place(input logic [SetBits-1:0] of_set,
                                                 input logic [1:0] of_way);
    place = PlaceBits'(32'(of_set) * Ways + 32'(of_way));
  endfunction

  localparam int SetIndexBits = Sets == 1 ? 1 : $clog2(Sets);
  logic [SetIndexBits-1:0] set;
  assign set = set_i[SetIndexBits-1:0];

  // Without a look-up nothing is read, and nothing simulated
  logic       hit;
  logic [1:0] way;  // of the hit, or the one to be allocated
  always_comb begin
    hit = 1'b0;
    way = 2'd0;
    if (update_i) begin
      for (int w = 0; w < Ways; w++) begin
        if (valid_q[place(set_i, 2'(w))] && tag_q[place(set_i, 2'(w))] == line_i) begin
          hit = 1'b1;
          way = 2'(w);
        end
      end
      if (!hit) begin
        for (int w = Ways - 1; w >= 0; w--) begin
          if ((older_q[set][w*Ways +: Ways] | Ways'(1 << w)) == '1) way = 2'(w);
        end
        for (int w = Ways - 1; w >= 0; w--) begin
          if (!valid_q[place(set_i, 2'(w))]) way = 2'(w);
        end
      end
    end
  end
  assign hit_o   = hit;
  assign place_o = ptm_unit_front_pkg::PlaceBits'(place(set_i, way));
  // The ways' order after this use
  logic [Ways*Ways-1:0] older_after;
  always_comb begin
    older_after = '0;
    if (update_i) begin
      older_after = older_q[set];
      for (int w = 0; w < Ways; w++) begin
        for (int other = 0; other < Ways; other++) begin
          if (2'(w) == way) older_after[w*Ways + other] = 1'b0;
          else if (2'(other) == way) older_after[w*Ways + other] = 1'b1;
        end
      end
    end
  end
  always_ff @(posedge clk_i) begin
    if (update_i) begin
      older_q[set] <= older_after;
      if (!hit) tag_q[place(set_i, way)] <= line_i;
    end
  end
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) valid_q <= '0;
    else if (invalidate_i) valid_q <= '0;
    else if (update_i && !hit) valid_q[place(set_i, way)] <= 1'b1;
  end

  for (genvar s = 0; s < Snoops; s++) begin : gen_snoop
    logic [SetBits-1:0]  other_set;
    logic [LineBits-1:0] other_line;
    assign other_set  = snoop_set_i[s*SetBits +: SetBits];
    assign other_line = snoop_line_i[s*LineBits +: LineBits];
    always_comb begin
      snoop_held_o[s] = 1'b0;
      if (snoop_i[s]) begin
        for (int w = 0; w < Ways; w++) begin
          if (valid_q[place(other_set, 2'(w))]) begin
            if (tag_q[place(other_set, 2'(w))] == other_line) snoop_held_o[s] = 1'b1;
          end
        end
      end
    end
  end
endmodule
