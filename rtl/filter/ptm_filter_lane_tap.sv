// One tap's value of field number Field of a TMU's word, as it enters U7: x << FilterFrac.
//
//   word of the planes   three coefficients of FieldW bits (two above 10), or four bytes
//   palettised LRGB      0..5 its entry's coefficients, 6..8 the word's bytes 1..3
//   palettised RGB       0..17 its entry's coefficients                docs/spec/unit.md, Words
//
// Indexed: the TMU is the one that fetches palettised words. Combinational.
module ptm_filter_lane_tap #(
  parameter int FieldW     = 8,
  parameter int FilterFrac = 0,
  parameter int Field      = 0,
  parameter int Indexed    = 1,
  localparam int AWord = ptm_pkg::coefficients_a_word(FieldW)
) (
  input  logic [31:0]                  word_i,
  input  logic [3*FieldW-1:0]          entry_i,  // the palette's word that holds the field
  input  logic                         bytes_i,  // the word holds four bytes
  input  logic                         lrgb_i,   // it is an index into that palette
  input  logic                         rgb_i,
  output logic [FieldW+FilterFrac-1:0] value_o
);
  logic [FieldW-1:0] plain, entry, value;
  assign entry = entry_i[FieldW*(Field%3) +: FieldW];
  if (Field < AWord) begin : gen_coef
    assign plain = bytes_i ? FieldW'(word_i[8*Field +: 8]) : word_i[FieldW*Field +: FieldW];
  end else if (Field < 4) begin : gen_byte
    assign plain = FieldW'(word_i[8*Field +: 8]);
  end else if (Field >= 6 && Field < 9) begin : gen_indexed_byte
    assign plain = FieldW'(word_i[8*(Field-5) +: 8]);
  end else begin : gen_entry
    assign plain = entry;
  end
  if (Indexed == 0) begin : gen_plain
    assign value = plain;
  end else if (Field < 6) begin : gen_either
    assign value = lrgb_i || rgb_i ? entry : plain;
  end else begin : gen_rgb
    assign value = rgb_i ? entry : plain;
  end
  assign value_o = (FieldW+FilterFrac)'(value) << FilterFrac;
endmodule
