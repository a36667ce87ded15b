// U8 to U10 of the fields of the coefficient sets that effects add, L2 to O, six a set; those of
// one set are chosen for the pass in O.
//
//   |L2| lanes to fields, U8 |L3| U9, U10 |O| operands of an extra pass
//                                                             docs/spec/effects.md, Draw and X1
//
// Words of set s are 2 s and 2 s + 1 (with two coefficients a word 3 s to 3 s + 2) behind the map's
// planes and the colour texture, and lie, like any word w, on TMU w mod Tmus in group w / Tmus. A
// set that the draw does not have holds anything. Multiplies: 6 a set. Control is the caller's
// (ptm_filter). Twin: shade() in model/reference/unit/shade.h.
module ptm_filter_sets #(
  parameter int CoefBits     = 8,
  parameter int RoundNearest = 1,
  parameter int FilterFrac   = 0,
  parameter int Tmus         = 3,
  parameter int ExtraSets    = 1,  // 1..4
  localparam int ValueW    = ptm_pkg::larger(8, CoefBits) + FilterFrac,
  localparam int StoredW   = ptm_pkg::stored_bits(CoefBits, FilterFrac),
  localparam int Lanes0    = 18,                     // of TMU 0
  localparam int Lanes     = Lanes0 + 4 * (Tmus - 1),
  localparam int GroupBits = ptm_unit_pkg::GroupBits,
  localparam int AWord     = ptm_pkg::coefficients_a_word(CoefBits)
) (
  input  logic                    clk_i,
  // The beat in L2
  input  logic                    load_l3_i,
  input  logic [Lanes*ValueW-1:0] l2_i,          // TMU 0's lanes lowest
  input  logic [2:0]              l2_format_i,
  input  logic                    l2_color_i,    // the draw has a colour texture
  input  logic [GroupBits-1:0]    l2_group_i,
  input  logic                    l2_second_i,
  input  logic [7:0]              l2_map_f_i,
  // The beat in L3
  input  logic                    leave_l3_i,
  input  logic                    l3_first_probe_i,
  input  logic [2:0]              l3_probes_log2_i,
  input  logic                    l3_lit_i,
  input  logic [ExtraSets*6*12-1:0] l3_bias_i,   // set 0 lowest
  // The fragment that enters O, and the one in O
  input  logic                    load_o_i,
  input  logic [2:0]              set_i,         // 0: anything, s: set s - 1
  output logic [6*StoredW-1:0]    coef_o
);
  `include "filter/ptm_filter_words.svh"

  logic [ValueW-1:0] field [6*ExtraSets];
  for (genvar j = 0; j < 6 / AWord * ExtraSets; j++) begin : gen_word
    logic [Tmus-1:0] on;  // the TMU that has the word
    for (genvar t = 0; t < Tmus; t++) begin : gen_tmu
      assign on[t] = brings_set(l2_format_i, l2_color_i, l2_group_i, j, t);
    end
    logic here, adds_q;
    assign here = load_l3_i && on != '0;
    always_ff @(posedge clk_i) begin
      if (load_l3_i) adds_q <= on != '0 && l2_second_i == (l2_map_f_i != 8'd0);
    end

    // The value of a field that the beat does not bring stands still, at 0.
    for (genvar i = 0; i < AWord; i++) begin : gen_field
      localparam int N = AWord * j + i;
      logic [ValueW-1:0] value;
      always_comb begin
        value = '0;
        if (here) begin
          for (int t = 0; t < Tmus; t++) begin
            if (on[t]) value = l2_i[lane(t, i)*ValueW +: ValueW];
          end
        end
      end
      ptm_filter_field #(.Width(ValueW), .RoundNearest(RoundNearest)) u_field (
        .clk_i(clk_i), .brings_i(here), .second_i(l2_second_i), .f_i(l2_map_f_i),
        .value_i(value), .leave_l3_i(leave_l3_i), .adds_i(adds_q),
        .first_probe_i(l3_first_probe_i), .probes_log2_i(l3_probes_log2_i),
        .load_o_i(load_o_i), .replace_i(!l3_lit_i),
        .replacement_i(ValueW'(l3_bias_i[12*N +: CoefBits]) << FilterFrac), .field_o(field[N])
      );
    end
  end

  for (genvar i = 0; i < 6; i++) begin : gen_operand
    always_comb begin
      coef_o[StoredW*i +: StoredW] = '0;
      for (int s = 0; s < ExtraSets; s++) begin
        if (set_i == 3'(s + 1)) coef_o[StoredW*i +: StoredW] = field[6*s+i][StoredW-1:0];
      end
    end
  end
endmodule
