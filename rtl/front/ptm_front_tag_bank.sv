// One tag bank of one TMU's cache: Sets sets of Ways ways, least recently used replaced first.
//
// A beat's tags are read as it enters T, all ways of a set in a row; the look-up is in the cycle
// after, and a use: a hit touches its way at the end of that cycle, a miss allocates (an invalid
// way first, the lowest, else the one used longest ago) and writes the row back. A row that the
// beat before writes while it is read goes past the memory. Invalidation clears all in a cycle.
// docs/spec/unit-timing.md, Tags.
//
// DuplicateLines: whether a line that another TMU misses stands here, for the counter
// `duplicate_lines`. It needs a copy of the tags for each other TMU, which are read in the cycle of
// the look-up (and show what stood before it) and compared in the next.
module ptm_front_tag_bank #(
  parameter int Sets   = 32,
  parameter int Ways   = 2,   // 1, 2, 4
  parameter int Tmus   = 3,
  parameter int Tmu    = 0,   // whose cache this is
  parameter int DuplicateLines = 1,  // 0: held_o is 0
  localparam int SetBits  = ptm_front_pkg::SetBits,
  localparam int LineBits = ptm_unit_pkg::LineBits,
  localparam int PlaceW   = ptm_front_pkg::PlaceBits
) (
  input  logic                     clk_i,
  input  logic                     rst_ni,
  input  logic                     invalidate_i,
  input  logic                     read_i,      // a look-up in the next cycle
  input  logic [SetBits-1:0]       read_set_i,
  input  logic                     look_up_i,
  input  logic [SetBits-1:0]       set_i,       // what was read
  input  logic [LineBits-1:0]      line_i,
  output logic                     hit_o,    // of a look-up; else 0
  output logic [PlaceW-1:0]        place_o,  // {set, way}
  // What this bank's like misses in each TMU, and the lines a cycle later
  input  logic                     any_miss_i,   // in any TMU and bank: all are looked for
  input  logic [Tmus*SetBits-1:0]  miss_set_i,
  input  logic                     any_missed_i, // a cycle later
  input  logic [Tmus*LineBits-1:0] missed_line_i,
  output logic [Tmus-1:0]          held_o        // another TMU's line stood here a cycle ago
);
  localparam int Lines     = Sets * Ways;
  localparam int PlaceBits = Lines == 1 ? 1 : $clog2(Lines);
  localparam int WayBits   = $clog2(Ways);

  logic [Lines-1:0] valid_q;  // {set, way}

  localparam int SetIndexBits = Sets == 1 ? 1 : $clog2(Sets);
  logic [SetIndexBits-1:0] set, read_set;
  logic [PlaceBits-1:0]    first;  // way of the set
  assign set      = set_i[SetIndexBits-1:0];
  assign read_set = read_set_i[SetIndexBits-1:0];
  assign first    = PlaceBits'(set_i) << WayBits;

  // The set's tags: what was read, or written as it was read
  logic                     allocates;
  logic [Ways*LineBits-1:0] stored, tags, tags_after, late_tags_q;
  ptm_memory_ram #(
    .Depth(Sets), .Width(Ways * LineBits)
  ) u_tags (
    .clk_i(clk_i), .write_i(allocates), .write_address_i(set), .write_data_i(tags_after),
    .read_i(read_i), .read_address_i(read_set), .read_data_o(stored)
  );
  logic late_q;
  always_ff @(posedge clk_i) begin
    if (read_i) begin
      late_q <= allocates && read_set == set;
      if (allocates) late_tags_q <= tags_after;
    end
  end

  // Bit {i, j} of a set: way i was used longer ago than way j. Right for every pair of which one
  // was used, so it needs no reset: it is asked only where all ways are valid.
  logic [Ways*Ways-1:0] older, older_after;  // before and after this use
  ptm_memory_register_file #(
    .Depth(Sets), .Width(Ways * Ways)
  ) u_older (
    .clk_i(clk_i), .write_i(look_up_i), .write_address_i(set), .write_data_i(older_after),
    .read_address_i(set), .read_data_o(older)
  );

  // Without a look-up nothing is read, and nothing simulated
  logic [1:0]           way;    // of the hit, or the one to be allocated
  logic [PlaceBits-1:0] place;  // likewise
  always_comb begin
    hit_o       = 1'b0;
    allocates   = 1'b0;
    way         = 2'd0;
    place       = '0;
    tags        = '0;
    tags_after  = '0;
    older_after = '0;
    if (look_up_i) begin
      allocates = 1'b1;
      tags      = late_q ? late_tags_q : stored;
      for (int w = 0; w < Ways; w++) begin
        if (valid_q[first | PlaceBits'(w)] && tags[w*LineBits +: LineBits] == line_i) begin
          hit_o     = 1'b1;
          allocates = 1'b0;
          way       = 2'(w);
        end
      end
      if (allocates) begin
        for (int w = Ways - 1; w >= 0; w--) begin
          if ((older[w*Ways +: Ways] | Ways'(1 << w)) == '1) way = 2'(w);
        end
        for (int w = Ways - 1; w >= 0; w--) begin
          if (!valid_q[first | PlaceBits'(w)]) way = 2'(w);
        end
        tags_after = tags;
        for (int w = 0; w < Ways; w++) begin
          if (2'(w) == way) tags_after[w*LineBits +: LineBits] = line_i;
        end
      end
      place       = first | PlaceBits'(way);
      older_after = older;
      for (int w = 0; w < Ways; w++) begin
        for (int other = 0; other < Ways; other++) begin
          if (2'(w) == way) older_after[w*Ways + other] = 1'b0;
          else if (2'(other) == way) older_after[w*Ways + other] = 1'b1;
        end
      end
    end
  end
  assign place_o = PlaceW'(place);
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) valid_q <= '0;
    else if (invalidate_i) valid_q <= '0;
    else if (allocates) valid_q[place] <= 1'b1;
  end

  // Copies for what other TMUs miss
  for (genvar t = 0; t < Tmus; t++) begin : gen_copy
    if (DuplicateLines == 0 || t == Tmu) begin : gen_none
      assign held_o[t] = 1'b0;
    end else begin : gen_tags
      logic [SetIndexBits-1:0] miss_set;
      assign miss_set = miss_set_i[t*SetBits +: SetIndexBits];
      logic [Ways-1:0] valid;
      always_comb begin
        valid = '0;
        if (any_miss_i) begin
          valid = valid_q[PlaceBits'(miss_set_i[t*SetBits +: SetBits]) << WayBits +: Ways];
        end
      end
      ptm_front_tag_copy #(
        .Sets(Sets), .Ways(Ways)
      ) u_copy (
        .clk_i(clk_i), .write_i(allocates), .write_set_i(set), .write_tags_i(tags_after),
        .read_i(any_miss_i), .read_set_i(miss_set), .valid_i(valid), .show_i(any_missed_i),
        .line_i(missed_line_i[t*LineBits +: LineBits]), .held_o(held_o[t])
      );
    end
  end
  logic unused;
  assign unused = ^{any_miss_i, any_missed_i, miss_set_i, missed_line_i};
endmodule
