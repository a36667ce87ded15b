// Written by scripts/contract from contract/formats.toml.
//
// What a texel format has: docs/spec/unit.md, Draw descriptor. Combinational functions.
package ptm_format_pkg;
  localparam int WordsMax = 6;  // of a format

  // Planes of the map's own words
  function automatic logic [2:0] planes(input logic [2:0] format);
    case (format)
      ptm_register_pkg::FormatLrgb: planes = 3'd3;
      ptm_register_pkg::FormatRgb: planes = 3'd6;
      ptm_register_pkg::FormatPaletteLrgb: planes = 3'd1;
      ptm_register_pkg::FormatPaletteRgb: planes = 3'd1;
      default: planes = 3'd0;
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

  // Fields of a filtered fragment that come of each word, five bits a word, word 0 lowest
  function automatic logic [5*WordsMax-1:0] word_fields(input logic [2:0] format);
    case (format)
      ptm_register_pkg::FormatNone: word_fields = {5'd0, 5'd0, 5'd0, 5'd0, 5'd0, 5'd0};
      ptm_register_pkg::FormatLrgb: word_fields = {5'd0, 5'd0, 5'd0, 5'd4, 5'd3, 5'd3};
      ptm_register_pkg::FormatRgb: word_fields = {5'd3, 5'd3, 5'd3, 5'd3, 5'd3, 5'd3};
      ptm_register_pkg::FormatPaletteLrgb: word_fields = {5'd0, 5'd0, 5'd0, 5'd0, 5'd0, 5'd9};
      ptm_register_pkg::FormatPaletteRgb: word_fields = {5'd0, 5'd0, 5'd0, 5'd0, 5'd0, 5'd18};
      default: word_fields = '0;
    endcase
  endfunction

endpackage
