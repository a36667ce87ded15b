// Where the words of a draw come by, and the lanes that take their fields: docs/spec/unit.md,
// Steps. For inside a module of the filter: they read its AWord, Tmus, Lanes0 and GroupBits.

// Lane of field i of TMU t's word
function automatic int lane(input int t, input int i);
  lane = t == 0 ? i : Lanes0 + 4 * (t - 1) + i;
endfunction
// The beat brings word w on TMU t
function automatic logic brings(input logic [GroupBits-1:0] group, input int w, input int t);
  brings = w % Tmus == t && group == GroupBits'(w / Tmus);
endfunction
`include "contract/ptm_format_words.svh"
