// Formats of the texture unit's streams and descriptors: docs/spec/unit.md and unit-timing.md.
// Widths that depend on EvalConfig are the largest it may ask for. Twin: model/reference/unit/.
package ptm_unit_pkg;
  // Sizes, codes and addresses of the register port, and the layouts draw_t, texture_t and effect_t
  `include "contract/ptm_registers.svh"

  localparam int PixelBits = 14;  // x, y
  localparam int CoordBits = 29;  // Q8.20 with a sign
  localparam int LodBits   = 12;  // Q4.8
  localparam int LightMax  = 17;  // light_int + light_frac
  localparam int IndexBits = 12;  // of a texel in its row
  localparam int Fields    = 26;  // of a filtered fragment
  localparam int GroupBits = 5;   // of a beat's number in its footprint: 22 words, one TMU
  // Effects: the most that a unit may be built with (docs/spec/effects.md)
  localparam int PassesMax = ExtraPassesMax;
  localparam int AddendW   = 13;  // Q9.4
  // Widths of the structs below
  localparam int TapsW    = 4 + 4 * 32;
  localparam int BeatW    = 2 * PixelBits + 2 * LightMax + 1 + DrawBits + 3 + 2 + GroupBits +
                            2 * 25 + 2;

  // A pixel behind the combine stage
  typedef struct packed {
    logic [PixelBits-1:0] x;
    logic [PixelBits-1:0] y;
    logic [DrawBits-1:0]  draw;
    logic [2:0][7:0]      rgb;    // red lowest
    logic [7:0]           alpha;
    logic [1:0]           flags;  // lum_saturated, color_saturated
  } pixel_t;

  typedef struct packed {
    logic [PixelBits-1:0]        x;
    logic [PixelBits-1:0]        y;
    logic signed [CoordBits-1:0] u;
    logic signed [CoordBits-1:0] v;
    logic [LodBits-1:0]          lod;
    logic signed [CoordBits-1:0] axis_u;
    logic signed [CoordBits-1:0] axis_v;
    logic [2:0]                  probes_log2;
    logic signed [LightMax-1:0]  lu;
    logic signed [LightMax-1:0]  lv;
    logic                        lit;
    logic [DrawBits-1:0]         draw;
  } fragment_t;

  // Weights and taps of one texture in one footprint
  typedef struct packed {
    logic [7:0] wu;       // along u, 0 for point sampling
    logic [7:0] wv;
    logic [7:0] f;        // level weight of U2; not 0: the texture has two footprints
    logic       fetched;  // 0: the second footprint of a texture whose f is 0
  } weights_t;

  // What travels with a beat (or sub-beat) from A3 to O, beside its look-ups and taps
  typedef struct packed {
    logic [PixelBits-1:0]       x;
    logic [PixelBits-1:0]       y;
    logic signed [LightMax-1:0] lu;
    logic signed [LightMax-1:0] lv;
    logic                       lit;
    logic [DrawBits-1:0]        draw;
    logic [2:0]                 probes_log2;
    logic                       first_probe;  // of the fragment
    logic                       second;       // footprint m = 1
    logic [GroupBits-1:0]       group;        // beat of the footprint: words group * tmus ..
    weights_t                   ptm;
    weights_t                   color;
    logic                       last;         // beat of the fragment
    logic                       sub_last;     // sub-beat of its beat
  } beat_t;

  // What D hands to the palette stage and the filter, beside beat_t: for each TMU its four taps
  // 00 10 01 11 (tap t's word at [t]) and which of them this sub-beat fetched.
  typedef struct packed {
    logic [3:0]       fetched;
    logic [3:0][31:0] word;
  } taps_t;
endpackage
