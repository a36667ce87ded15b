// Written by scripts/contract from contract/formats.toml.
// Words of a draw behind the map's planes, for where ptm_filter_words.svh stands.
// The beat brings the colour texture on TMU t: the word behind the map's planes
function automatic logic brings_color(input logic [2:0] format,
                                      input logic [GroupBits-1:0] group, input int t);
  case (format)
    ptm_unit_pkg::FormatNone: brings_color = brings(group, 0, t);
    ptm_unit_pkg::FormatLrgb: brings_color = brings(group, AWord == 3 ? 3 : 4, t);
    ptm_unit_pkg::FormatRgb: brings_color = brings(group, AWord == 3 ? 6 : 9, t);
    default: brings_color = brings(group, 1, t);
  endcase
endfunction
// The beat brings word j of the sets' on TMU t: they lie behind the colour texture
function automatic logic brings_set(input logic [2:0] format, input logic color,
                                    input logic [GroupBits-1:0] group, input int j,
                                    input int t);
  case (format)
    ptm_unit_pkg::FormatNone: brings_set = color ? brings(group, j + (1), t)
        : brings(group, j + (0), t);
    ptm_unit_pkg::FormatLrgb: brings_set = color ? brings(group, j + (AWord == 3 ? 4 : 5), t)
        : brings(group, j + (AWord == 3 ? 3 : 4), t);
    ptm_unit_pkg::FormatRgb: brings_set = color ? brings(group, j + (AWord == 3 ? 7 : 10), t)
        : brings(group, j + (AWord == 3 ? 6 : 9), t);
    default: brings_set = color ? brings(group, j + (2), t)
        : brings(group, j + (1), t);
  endcase
endfunction
