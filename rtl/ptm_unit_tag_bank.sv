// One tag bank of one TMU's cache: Sets sets of Ways ways, least recently used replaced first.
//
// A look-up is combinational, and a use: a hit touches its way at the end of the cycle, a miss
// allocates (an invalid way first, the lowest, else the one used longest ago). Invalidation clears
// all in a cycle. The miss ports tell whether a line that another TMU misses stands here, for the
// counter `duplicate_lines`. docs/spec/unit-timing.md, Tags.
module ptm_unit_tag_bank #(
  parameter int Sets   = 32,
  parameter int Ways   = 2,   // 1, 2, 4
  parameter int Tmus   = 3,
  parameter int Tmu    = 0,   // whose cache this is
  localparam int SetBits  = ptm_unit_front_pkg::SetBits,
  localparam int LineBits = ptm_unit_pkg::LineBits,
  localparam int PlaceW   = ptm_unit_front_pkg::PlaceBits
) (
  input  logic                     clk_i,
  input  logic                     rst_ni,
  input  logic                     invalidate_i,
  input  logic                     look_up_i,
  input  logic [SetBits-1:0]       set_i,
  input  logic [LineBits-1:0]      line_i,
  output logic                     hit_o,    // of a look-up; else 0
  output logic [PlaceW-1:0]        place_o,  // {set, way}
  // What this bank's like misses in each TMU
  input  logic                     any_miss_i,  // none of them: nothing is simulated
  input  logic [Tmus-1:0]          miss_i,
  input  logic [Tmus*SetBits-1:0]  miss_set_i,
  input  logic [Tmus*LineBits-1:0] miss_line_i,
  output logic [Tmus-1:0]          held_o       // another TMU's miss stands here
);
  localparam int Lines     = Sets * Ways;
  localparam int PlaceBits = Lines == 1 ? 1 : $clog2(Lines);
  localparam int WayBits   = $clog2(Ways);

  logic [Lines-1:0]    valid_q;          // {set, way}
  logic [LineBits-1:0] tag_q [Lines];
  // Bit {i, j} of a set: way i was used longer ago than way j. Right for every pair of which one
  // was used, so it needs no reset: it is asked only where all ways are valid.
  logic [Ways*Ways-1:0] older_q [Sets];

  localparam int SetIndexBits = Sets == 1 ? 1 : $clog2(Sets);
  logic [SetIndexBits-1:0] set;
  logic [PlaceBits-1:0]    first;  // way of the set
  assign set   = set_i[SetIndexBits-1:0];
  assign first = PlaceBits'(set_i) << WayBits;

  // Without a look-up nothing is read, and nothing simulated
  logic                 allocates;
  logic [1:0]           way;          // of the hit, or the one to be allocated
  logic [PlaceBits-1:0] place;        // likewise
  logic [Ways*Ways-1:0] older_after;  // the ways' order after this use
  always_comb begin
    hit_o       = 1'b0;
    allocates   = 1'b0;
    way         = 2'd0;
    place       = '0;
    older_after = '0;
    if (look_up_i) begin
      allocates = 1'b1;
      for (int w = 0; w < Ways; w++) begin
        if (valid_q[first | PlaceBits'(w)] && tag_q[first | PlaceBits'(w)] == line_i) begin
          hit_o     = 1'b1;
          allocates = 1'b0;
          way       = 2'(w);
        end
      end
      if (allocates) begin
        for (int w = Ways - 1; w >= 0; w--) begin
          if ((older_q[set][w*Ways +: Ways] | Ways'(1 << w)) == '1) way = 2'(w);
        end
        for (int w = Ways - 1; w >= 0; w--) begin
          if (!valid_q[first | PlaceBits'(w)]) way = 2'(w);
        end
      end
      place       = first | PlaceBits'(way);
      older_after = older_q[set];
      for (int w = 0; w < Ways; w++) begin
        for (int other = 0; other < Ways; other++) begin
          if (2'(w) == way) older_after[w*Ways + other] = 1'b0;
          else if (2'(other) == way) older_after[w*Ways + other] = 1'b1;
        end
      end
    end
  end
  assign place_o = PlaceW'(place);
  always_ff @(posedge clk_i) begin
    if (look_up_i) older_q[set] <= older_after;
    if (allocates) tag_q[place] <= line_i;
  end
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) valid_q <= '0;
    else if (invalidate_i) valid_q <= '0;
    else if (allocates) valid_q[place] <= 1'b1;
  end

  always_comb begin
    held_o = '0;
    if (any_miss_i) begin
      for (int t = 0; t < Tmus; t++) begin
        for (int w = 0; w < Ways; w++) begin
          if (t != Tmu && miss_i[t] &&
              valid_q[(PlaceBits'(miss_set_i[t*SetBits +: SetBits]) << WayBits) | PlaceBits'(w)] &&
              tag_q[(PlaceBits'(miss_set_i[t*SetBits +: SetBits]) << WayBits) | PlaceBits'(w)] ==
                  miss_line_i[t*LineBits +: LineBits]) begin
            held_o[t] = 1'b1;
          end
        end
      end
    end
  end
endmodule
