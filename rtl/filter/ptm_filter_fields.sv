// U8 to U10 of a fragment's 26 fields, L2 to O, and the operands that O's fragment gives a pass.
//
//   |L2| lanes to fields, U8 |L3| U9, U10 |O| operands of pass 0, 1, 2
//                                            docs/spec/unit.md
//
// Word w of a draw lies on TMU w mod Tmus in group w / Tmus; a field takes its value from the lane
// of its word there, or of the palette's word (TMU 0, group 0), and only from beats that bring it.
// Control is the caller's (ptm_filter). Twins: shade() in model/reference/unit/shade.h,
// own_word_use() in model/reference/unit/texel_fields.h.
module ptm_filter_fields #(
  parameter int CoefBits     = 8,
  parameter int RoundNearest = 1,
  parameter int FilterFrac   = 0,
  parameter int Tmus         = 3,
  parameter int EvalLanes    = 1,  // passes a cycle; 1, 3
  localparam int ValueW  = ptm_pkg::larger(8, CoefBits) + FilterFrac,
  localparam int StoredW = ptm_pkg::stored_bits(CoefBits, FilterFrac),
  localparam int RgbW    = ptm_pkg::rgb_bits(FilterFrac),
  localparam int Lanes0  = 18,                     // of TMU 0
  localparam int Lanes   = Lanes0 + 4 * (Tmus - 1)
) (
  input  logic                    clk_i,
  // The beat in L2
  input  logic                    load_l3_i,
  input  logic [Lanes*ValueW-1:0] l2_i,          // TMU 0's lanes lowest
  input  logic [2:0]              l2_format_i,
  input  logic [ptm_unit_pkg::GroupBits-1:0] l2_group_i,
  input  logic                    l2_second_i,
  input  logic [7:0]              l2_map_f_i,
  input  logic [7:0]              l2_color_f_i,
  // The beat in L3
  input  logic                    leave_l3_i,
  input  logic [2:0]              l3_format_i,
  input  logic                    l3_color_i,    // the draw has a colour texture
  input  logic                    l3_first_probe_i,
  input  logic [2:0]              l3_probes_log2_i,
  input  logic                    l3_lit_i,
  input  logic [6*12-1:0]         l3_bias_i,
  // The fragment that enters O, and the one in O
  input  logic                    load_o_i,
  input  logic [1:0]              pass_i,
  output logic [EvalLanes*6*StoredW-1:0] coef_o,  // lane 0 lowest
  output logic [3*RgbW-1:0]       rgb_o,
  output logic [7:0]              map_alpha_o,
  output logic [31:0]             color_o        // R G B A, R lowest
);
  localparam int AWord     = ptm_pkg::coefficients_a_word(CoefBits);
  localparam int LrgbColor = 6 / AWord;  // the word of LRGB that holds the colour
  localparam int RgbWords  = 18 / AWord;
  localparam int GroupBits = ptm_unit_pkg::GroupBits;

  `include "filter/ptm_filter_words.svh"

  // Lane by lane
  logic [ValueW-1:0] l2 [Lanes];
  for (genvar n = 0; n < Lanes; n++) begin : gen_lane
    assign l2[n] = l2_i[n*ValueW +: ValueW];
  end

  // U8 to U10
  logic              l3_none, l3_lrgb, l3_rgb;
  logic [ValueW-1:0] field [ptm_unit_pkg::Fields];
  assign l3_none  = l3_format_i == ptm_unit_pkg::FormatNone;
  assign l3_lrgb  = l3_format_i == ptm_unit_pkg::FormatLrgb;
  assign l3_rgb   = l3_format_i == ptm_unit_pkg::FormatRgb ||
                    l3_format_i == ptm_unit_pkg::FormatPaletteRgb;

  logic l2_lrgb, l2_rgb, l2_lrgb_index, l2_rgb_index;
  assign l2_lrgb       = l2_format_i == ptm_unit_pkg::FormatLrgb;
  assign l2_rgb        = l2_format_i == ptm_unit_pkg::FormatRgb;
  assign l2_lrgb_index = l2_format_i == ptm_unit_pkg::FormatPaletteLrgb &&
                         l2_group_i == '0;
  assign l2_rgb_index  = l2_format_i == ptm_unit_pkg::FormatPaletteRgb &&
                         l2_group_i == '0;
  logic [Tmus-1:0] l2_colors;
  logic            l2_color;
  for (genvar t = 0; t < Tmus; t++) begin : gen_l2_color
    assign l2_colors[t] = brings_color(l2_format_i, l2_group_i, t);
  end
  assign l2_color = l2_colors != '0;

  // Fields come in groups: the words of coefficients, LRGB's colour, its alpha, the colour texture.
  // Which of them the beat in L2 brings, from where, and whether it is added to the sum.
  localparam int Color = RgbWords, Alpha = Color + 1, Texture = Color + 2, Groups = Color + 3;
  // (A bit a group: packed into vectors they cost the simulation twice as much.)
  for (genvar g = 0; g < Groups; g++) begin : gen_group
    logic here, indexed, brings_it, adds_q;
    if (g < Color) begin : gen_coef
      assign indexed = (l2_lrgb_index && g < LrgbColor) || l2_rgb_index;
      assign here    = indexed || ((l2_rgb || (l2_lrgb && g < LrgbColor)) &&
                                   brings(l2_group_i, g, g % Tmus));
    end else if (g < Texture) begin : gen_color
      assign indexed = l2_lrgb_index && g == Color;
      assign here    = indexed || (l2_lrgb && brings(l2_group_i, LrgbColor, LrgbColor % Tmus));
    end else begin : gen_texture
      assign indexed = 1'b0;
      assign here    = l2_color;
      logic unused;
      assign unused = indexed;
    end
    assign brings_it = load_l3_i && here;
    always_ff @(posedge clk_i) begin
      if (load_l3_i) begin
        adds_q <= here && l2_second_i == ((g < Texture ? l2_map_f_i : l2_color_f_i) != 8'd0);
      end
    end
  end

  // The value of a field that the beat does not bring stands still, at 0.
  for (genvar n = 0; n < ptm_unit_pkg::Fields; n++) begin : gen_field
    localparam int Group = n < 18 ? n / AWord : n < 21 ? Color : n < 22 ? Alpha : Texture;
    logic              replace;
    logic [ValueW-1:0] value, replacement;
    if (n < 18) begin : gen_coef
      localparam int Tmu = Group % Tmus;
      always_comb begin
        value = '0;
        if (gen_group[Group].brings_it) begin
          value = gen_group[Group].indexed ? l2[n] : l2[lane(Tmu, n % AWord)];
        end
      end
      assign replace     = !l3_lit_i || l3_none;
      assign replacement = l3_none ? '0 : ValueW'(l3_bias_i[12*(n%6) +: CoefBits]) << FilterFrac;
    end else if (n < 22) begin : gen_color
      localparam int Tmu = LrgbColor % Tmus;
      always_comb begin
        value = '0;
        if (gen_group[Group].brings_it) begin
          value = gen_group[Group].indexed ? l2[n-12] : l2[lane(Tmu, n - 18)];
        end
      end
      if (n == 21) begin : gen_alpha
        assign replace     = !l3_lrgb;
        assign replacement = ValueW'(255) << FilterFrac;
      end else begin : gen_rgb
        assign replace     = l3_none || l3_rgb;
        assign replacement = '0;
      end
    end else begin : gen_texture
      always_comb begin
        value = '0;
        if (gen_group[Group].brings_it) begin
          case (l2_format_i)
            ptm_unit_pkg::FormatNone: value = l2[lane(0, n - 22)];
            ptm_unit_pkg::FormatLrgb: value = l2[lane((LrgbColor + 1) % Tmus, n - 22)];
            ptm_unit_pkg::FormatRgb:  value = l2[lane(RgbWords % Tmus, n - 22)];
            default:                  value = l2[lane(1 % Tmus, n - 22)];
          endcase
        end
      end
      assign replace     = !l3_color_i;
      assign replacement = '0;
    end
    ptm_filter_field #(.Width(ValueW), .RoundNearest(RoundNearest)) u_field (
      .clk_i(clk_i), .brings_i(gen_group[Group].brings_it), .second_i(l2_second_i),
      .f_i(n < 22 ? l2_map_f_i : l2_color_f_i), .value_i(value),
      .leave_l3_i(leave_l3_i), .adds_i(gen_group[Group].adds_q), .first_probe_i(l3_first_probe_i),
      .probes_log2_i(l3_probes_log2_i),
      .load_o_i(load_o_i && (n < 6 || n >= 18 || l3_rgb)), .replace_i(replace),
      .replacement_i(replacement), .field_o(field[n])
    );
  end

  // O: the operands of a pass, or of all three
  for (genvar i = 0; i < 6; i++) begin : gen_operand
    if (EvalLanes == 1) begin : gen_in_turn
      assign coef_o[StoredW*i +: StoredW] = pass_i == 2'd0 ? field[i][StoredW-1:0] :
                                            pass_i == 2'd1 ? field[6+i][StoredW-1:0] :
                                                             field[12+i][StoredW-1:0];
    end else begin : gen_at_once
      for (genvar e = 0; e < EvalLanes; e++) begin : gen_lane
        assign coef_o[StoredW*(6*e+i) +: StoredW] = field[6*e+i][StoredW-1:0];
      end
      logic unused;
      assign unused = ^pass_i;
    end
  end
  assign rgb_o = {field[20][RgbW-1:0], field[19][RgbW-1:0], field[18][RgbW-1:0]};

  // narrow(., FilterFrac) of what the evaluator does not see
  for (genvar n = 21; n < ptm_unit_pkg::Fields; n++) begin : gen_byte
    logic signed [ValueW:0] narrowed;
    ptm_arith_narrow #(
      .InBits(ValueW + 1), .AmountBits(3), .OutBits(ValueW + 1), .RoundNearest(RoundNearest)
    ) u_narrow (
      .x_i({1'b0, field[n]}), .amount_i(3'(FilterFrac)), .y_o(narrowed)
    );
    if (n == 21) begin : gen_map
      assign map_alpha_o = narrowed[7:0];
    end else begin : gen_color
      assign color_o[8*(n-22) +: 8] = narrowed[7:0];
    end
  end
endmodule
