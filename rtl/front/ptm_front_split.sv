// A3: sends a beat to T, as several sub-beats where tiles or texels of a TMU collide in a bank.
//
// The beat is split along every direction in which any TMU collides: in u into taps {00, 01} then
// {10, 11}; in v into {00, 10} then {01, 11}; in both into four. One sub-beat a cycle; A3 is
// emptied with the last. docs/spec/unit-timing.md, Seam split.
//
// TMU t has word group * Tmus + t of the draw: the map's planes, the colour texture, the sets'
// planes, which are the map's behind its own.
module ptm_front_split #(
  parameter int CoefBits  = 8,
  parameter int Tmus      = 3,
  parameter int ExtraSets = 0,  // 0..4
  localparam int AWord = ptm_pkg::coefficients_a_word(CoefBits),
  localparam int PlaneBits = ptm_front_pkg::PlaneBits
) (
  input  logic                        clk_i,
  input  logic                        rst_ni,
  // A3
  input  logic                        valid_i,
  output logic                        ready_o,  // with the last sub-beat
  input  ptm_unit_pkg::beat_t         beat_i,
  input  logic [ptm_format_pkg::PlanesBits-1:0] planes_i,  // the map's own
  input  logic [2:0]                  sets_i,     // two planes more each, or three
  input  logic                        color_i,
  input  ptm_front_pkg::texels_t map_i,
  input  ptm_front_pkg::texels_t color_texels_i,
  // Sub-beat
  input  logic                        ready_i,
  output ptm_unit_pkg::beat_t         beat_o,
  output logic [3:0]                  taps_o,     // of both directions' halves
  // By TMU: what its word is
  output logic [Tmus-1:0]             fetched_o,  // it has one, and its texture has taps
  output logic [Tmus-1:0]             color_o,    // of the colour texture
  output logic [Tmus*PlaneBits-1:0]   plane_o,
  // Counters' increments, in the cycle in which a sub-beat leaves
  output logic                        inc_conflicts_o,
  output logic [1:0]                  inc_words_o,
  output logic [3:0]                  inc_taps_o,
  output logic [3:0]                  inc_multiplies_o
);
  logic [4:0] first_word, past_word;  // of the beat
  assign first_word = 5'(beat_i.group) * 5'(Tmus);
  assign past_word  = first_word + 5'(Tmus);
  logic has_map, has_color;  // words of the beat, fetched or not
  logic [4:0] set_words, past_words;   // the first of the sets' words, and past the last
  if (ExtraSets == 0) begin : gen_own
    assign has_map    = first_word < 5'(planes_i);
    assign set_words  = '0;
    assign past_words = '0;
    logic unused_sets;
    assign unused_sets = ^{sets_i, set_words, past_words};
  end else begin : gen_sets
    assign set_words  = 5'(planes_i) + 5'(color_i);
    assign past_words = set_words + {1'b0, sets_i, 1'b0} + (AWord == 3 ? 5'd0 : 5'(sets_i));
    assign has_map    = first_word < 5'(planes_i) || (sets_i != '0 && set_words < past_word);
  end
  assign has_color = color_i && first_word <= 5'(planes_i) && 5'(planes_i) < past_word;

  logic reads_map, reads_color, split_u, split_v;
  assign reads_map   = has_map && beat_i.ptm.fetched;
  assign reads_color = has_color && beat_i.color.fetched;
  assign split_u     = (reads_map && map_i.collides_u) ||
                       (reads_color && color_texels_i.collides_u);
  assign split_v     = (reads_map && map_i.collides_v) ||
                       (reads_color && color_texels_i.collides_v);

  logic [1:0] sub_q;
  logic       last;
  assign last    = sub_q == {split_u && split_v, split_u || split_v};
  assign ready_o = ready_i && last;
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) sub_q <= '0;
    else if (valid_i && ready_i) sub_q <= last ? '0 : sub_q + 2'd1;
  end

  always_comb begin
    unique case ({split_v, split_u})
      2'b00: taps_o = 4'b1111;
      2'b01: taps_o = sub_q[0] ? 4'b1010 : 4'b0101;
      2'b10: taps_o = sub_q[0] ? 4'b1100 : 4'b0011;
      2'b11: taps_o = 4'b0001 << sub_q;
    endcase
  end

  for (genvar t = 0; t < Tmus; t++) begin : gen_tmu
    logic [4:0] word;
    assign word = first_word + 5'(t);
    if (ExtraSets == 0) begin : gen_word
      assign color_o[t]   = word >= 5'(planes_i);
      assign fetched_o[t] = color_o[t] ? reads_color && word == 5'(planes_i) : reads_map;
      assign plane_o[t*PlaneBits +: PlaneBits] = color_o[t] ? '0 : word;
    end else begin : gen_set_word
      logic       of_set;
      logic [4:0] plane;
      assign of_set       = word >= set_words && word < past_words;
      assign color_o[t]   = word >= 5'(planes_i) && !of_set;
      assign fetched_o[t] = color_o[t] ? reads_color && word == 5'(planes_i) : reads_map;
      assign plane        = of_set && color_i ? word - 5'd1 : word;
      assign plane_o[t*PlaneBits +: PlaneBits] = color_o[t] ? '0 : plane;
    end
  end

  always_comb begin
    beat_o          = beat_i;
    beat_o.sub_last = last;
  end

  // Counters
  logic leaves, leaves_first;
  assign leaves          = valid_i && ready_i;
  assign leaves_first    = leaves && sub_q == 2'd0;
  assign inc_conflicts_o = leaves && sub_q != 2'd0;
  logic [3:0] multiplies;
  assign multiplies = (beat_i.probes_log2 != 3'd0 ? 4'd2 : 4'd0) + (has_map ? 4'd4 : 4'd0) +
                      (has_color ? 4'd4 : 4'd0);
  assign inc_multiplies_o = leaves_first ? multiplies : 4'd0;
  // Of a texture, how many of the sub-beat's taps are fetched
  function automatic logic [2:0] count(input logic columns, input logic rows,
                                       input logic [3:0] taps);
    count = 3'(taps[0]) + 3'(taps[1] && columns) + 3'(taps[2] && rows) +
            3'(taps[3] && columns && rows);
  endfunction
  logic [2:0] taps_map, taps_color;
  always_comb begin  // of a texture that is not read nothing is simulated
    taps_map   = '0;
    taps_color = '0;
    if (reads_map) taps_map = count(map_i.columns, map_i.rows, taps_o);
    if (reads_color) taps_color = count(color_texels_i.columns, color_texels_i.rows, taps_o);
  end
  always_comb begin
    inc_words_o = 2'd0;
    inc_taps_o  = 4'd0;
    for (int t = 0; t < Tmus; t++) begin
      if (leaves && fetched_o[t]) begin
        if (sub_q == 2'd0) inc_words_o = inc_words_o + 2'd1;
        inc_taps_o = inc_taps_o + (color_o[t] ? 4'(taps_color) : 4'(taps_map));
      end
    end
  end
endmodule
