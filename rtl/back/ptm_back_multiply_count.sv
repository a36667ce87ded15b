// Multiplies that a beat or a fragment does; docs/spec/unit.md, What counts as a multiply.
//
// A set's word counts as the map's coefficient words; an extra pass is 8 multiplies.
// A word that fetches a tap does 3 a field if the draw is bilinear, 1 a field if its texture is in
// its second footprint. Combinational.
module ptm_back_multiply_count #(
  parameter int CoefBits    = 8,
  parameter int Tmus        = 3,
  parameter int ExtraSets   = 0,  // 0..4
  parameter int ExtraPasses = 0   // 0..4
) (
  // A beat
  input  logic [2:0] format_i,
  input  logic       bilinear_i,
  input  logic       color_i,
  input  logic [ptm_unit_pkg::GroupBits-1:0] group_i,
  input  logic [2:0] sets_i,
  input  logic       second_i,
  input  logic       map_fetched_i,
  input  logic       color_fetched_i,
  output logic [7:0] filter_o,
  // A fragment
  input  logic [2:0] o_format_i,
  input  logic [2:0] o_combine_i,
  input  logic [2:0] o_passes_i,  // extra ones
  output logic [5:0] eval_o,
  output logic [2:0] combine_o
);
  localparam int GroupBits = ptm_unit_pkg::GroupBits;
  localparam int AWord     = ptm_pkg::coefficients_a_word(CoefBits);
  localparam int WordsMax  = ptm_format_pkg::words_max(AWord);
  // Fields of the map's words in the beat, and of the colour texture's
  logic [5:0] map_fields, color_fields, fields;
  logic [ptm_format_pkg::PlanesBits-1:0] planes;
  logic [5*WordsMax-1:0] word_fields;  // 0 beyond the map's words
  assign planes = ptm_format_pkg::planes(AWord, format_i);
  if (AWord == 3) begin : gen_three
    assign word_fields = ptm_format_pkg::word_fields_3(format_i);
  end else begin : gen_two
    assign word_fields = ptm_format_pkg::word_fields_2(format_i);
  end
  always_comb begin
    map_fields = '0;
    for (int w = 0; w < WordsMax; w++) begin
      if (group_i == GroupBits'(w / Tmus)) map_fields = map_fields + 6'(word_fields[5*w +: 5]);
    end
    color_fields = '0;
    for (int w = 0; w <= WordsMax; w++) begin
      if (color_i && 4'(w) == planes && group_i == GroupBits'(w / Tmus)) color_fields = 6'd4;
    end
  end
  if (ExtraSets == 0) begin : gen_own
    assign fields = (map_fetched_i ? map_fields : '0) + (color_fetched_i ? color_fields : '0);
    logic unused_sets;
    assign unused_sets = ^sets_i;
  end else begin : gen_sets
    logic [4:0] first, past;  // of the sets' words
    logic [5:0] set_fields;
    assign first = 5'(planes) + 5'(color_i);
    assign past  = first + {1'b0, sets_i, 1'b0} + (AWord == 3 ? 5'd0 : 5'(sets_i));
    always_comb begin
      set_fields = '0;
      for (int w = 1; w < WordsMax + 1 + 6 / AWord * ExtraSets; w++) begin
        if (5'(w) >= first && 5'(w) < past && group_i == GroupBits'(w / Tmus)) begin
          set_fields = set_fields + 6'(AWord);
        end
      end
    end
    assign fields = (map_fetched_i ? map_fields + set_fields : '0) +
                    (color_fetched_i ? color_fields : '0);
  end
  assign filter_o = (bilinear_i ? 8'(fields) + {1'b0, fields, 1'b0} : '0) +
                    (second_i ? 8'(fields) : '0);

  logic [4:0] eval;  // of the map's own passes
  if (ExtraPasses == 0) begin : gen_own_passes
    assign eval_o = 6'(eval);
    logic unused_passes;
    assign unused_passes = ^o_passes_i;
  end else begin : gen_passes
    assign eval_o = 6'(eval) + {o_passes_i, 3'd0};
  end
  always_comb begin
    eval = ptm_format_pkg::eval_multiplies(o_format_i);
    case (o_combine_i)
      ptm_unit_pkg::CombineModulate: combine_o = 3'd3;
      ptm_unit_pkg::CombineDecal,
      ptm_unit_pkg::CombineBlend: combine_o = 3'd6;
      default: combine_o = 3'd0;
    endcase
  end
endmodule
