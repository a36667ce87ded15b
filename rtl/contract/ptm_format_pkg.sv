// Written by scripts/contract from contract/formats.toml.
//
// What a texel format has: docs/spec/unit.md, Draw descriptor. Combinational functions.
package ptm_format_pkg;
  localparam int PlanesBits = 4;  // of a number of planes

  // Words of the format that has most, where a word holds AWord coefficients
  function automatic int words_max(input int AWord);
    words_max = AWord == 3 ? 6 : 9;
  endfunction

  // Planes of the map's own words
  function automatic logic [PlanesBits-1:0] planes(input int AWord,
                                                   input logic [2:0] format);
    case (format)
      ptm_register_pkg::FormatLrgb: planes = AWord == 3 ? 4'd3 : 4'd4;
      ptm_register_pkg::FormatRgb: planes = AWord == 3 ? 4'd6 : 4'd9;
      ptm_register_pkg::FormatPaletteLrgb: planes = 4'd1;
      ptm_register_pkg::FormatPaletteRgb: planes = 4'd1;
      default: planes = 4'd0;
    endcase
  endfunction

  // Fields of a filtered fragment that come of each word, five bits a word, word 0 lowest, where a
  // word holds 3 coefficients
  function automatic logic [29:0] word_fields_3(input logic [2:0] format);
    case (format)
      ptm_register_pkg::FormatNone: word_fields_3 = {
          5'd0, 5'd0, 5'd0, 5'd0, 5'd0, 5'd0};
      ptm_register_pkg::FormatLrgb: word_fields_3 = {
          5'd0, 5'd0, 5'd0, 5'd4, 5'd3, 5'd3};
      ptm_register_pkg::FormatRgb: word_fields_3 = {
          5'd3, 5'd3, 5'd3, 5'd3, 5'd3, 5'd3};
      ptm_register_pkg::FormatPaletteLrgb: word_fields_3 = {
          5'd0, 5'd0, 5'd0, 5'd0, 5'd0, 5'd9};
      ptm_register_pkg::FormatPaletteRgb: word_fields_3 = {
          5'd0, 5'd0, 5'd0, 5'd0, 5'd0, 5'd18};
      default: word_fields_3 = '0;
    endcase
  endfunction

  // Fields of a filtered fragment that come of each word, five bits a word, word 0 lowest, where a
  // word holds 2 coefficients
  function automatic logic [44:0] word_fields_2(input logic [2:0] format);
    case (format)
      ptm_register_pkg::FormatNone: word_fields_2 = {
          5'd0, 5'd0, 5'd0, 5'd0, 5'd0, 5'd0, 5'd0, 5'd0, 5'd0};
      ptm_register_pkg::FormatLrgb: word_fields_2 = {
          5'd0, 5'd0, 5'd0, 5'd0, 5'd0, 5'd4, 5'd2, 5'd2, 5'd2};
      ptm_register_pkg::FormatRgb: word_fields_2 = {
          5'd2, 5'd2, 5'd2, 5'd2, 5'd2, 5'd2, 5'd2, 5'd2, 5'd2};
      ptm_register_pkg::FormatPaletteLrgb: word_fields_2 = {
          5'd0, 5'd0, 5'd0, 5'd0, 5'd0, 5'd0, 5'd0, 5'd0, 5'd9};
      ptm_register_pkg::FormatPaletteRgb: word_fields_2 = {
          5'd0, 5'd0, 5'd0, 5'd0, 5'd0, 5'd0, 5'd0, 5'd0, 5'd18};
      default: word_fields_2 = '0;
    endcase
  endfunction

  // The evaluator runs three passes, one a channel, not one
  function automatic logic three_passes(input logic [2:0] format);
    case (format)
      ptm_register_pkg::FormatRgb: three_passes = 1'b1;
      ptm_register_pkg::FormatPaletteRgb: three_passes = 1'b1;
      default: three_passes = 1'b0;
    endcase
  endfunction

  // A texel has one polynomial, of luminance
  function automatic logic one_polynomial(input logic [2:0] format);
    case (format)
      ptm_register_pkg::FormatLrgb: one_polynomial = 1'b1;
      ptm_register_pkg::FormatPaletteLrgb: one_polynomial = 1'b1;
      default: one_polynomial = 1'b0;
    endcase
  endfunction

  // Word 0 holds an index of a palette of LRGB
  function automatic logic indexes_lrgb(input logic [2:0] format);
    case (format)
      ptm_register_pkg::FormatPaletteLrgb: indexes_lrgb = 1'b1;
      default: indexes_lrgb = 1'b0;
    endcase
  endfunction

  // Word 0 holds an index of the palette of RGB
  function automatic logic indexes_rgb(input logic [2:0] format);
    case (format)
      ptm_register_pkg::FormatPaletteRgb: indexes_rgb = 1'b1;
      default: indexes_rgb = 1'b0;
    endcase
  endfunction

  // Multiplies of the evaluator, a fragment
  function automatic logic [4:0] eval_multiplies(input logic [2:0] format);
    case (format)
      ptm_register_pkg::FormatLrgb: eval_multiplies = 5'd11;
      ptm_register_pkg::FormatRgb: eval_multiplies = 5'd24;
      ptm_register_pkg::FormatPaletteLrgb: eval_multiplies = 5'd11;
      ptm_register_pkg::FormatPaletteRgb: eval_multiplies = 5'd24;
      default: eval_multiplies = 5'd0;
    endcase
  endfunction

endpackage
