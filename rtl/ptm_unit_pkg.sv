// Formats of the texture unit's streams and descriptors: docs/spec/unit.md and unit-timing.md.
// Widths that depend on EvalConfig are the largest it may ask for. Twin: model/reference/unit/.
package ptm_unit_pkg;
  localparam int Draws     = 4;
  localparam int DrawBits  = 2;
  localparam int LevelsMax = 13;
  localparam int LineBits  = 26;
  localparam int PixelBits = 14;  // x, y
  localparam int CoordBits = 29;  // Q8.20 with a sign
  localparam int LodBits   = 12;  // Q4.8
  localparam int LightMax  = 17;  // light_int + light_frac
  localparam int SideBits  = 13;  // a texture's width or height
  localparam int IndexBits = 12;  // of a texel in its row
  localparam int Fields    = 26;  // of a filtered fragment
  localparam int Counters  = 38;
  localparam int GroupBits = 4;   // of a beat's number in its footprint: 15 words, one TMU
  localparam int LargestSide  = 4096;
  localparam int ProbesLog2   = 4;   // at most
  localparam int LrgbPalettes = Draws;
  localparam int LrgbBits     = 8;   // of an entry's number in its palette
  localparam int RgbBits      = 12;
  // Effects: the most that a unit may be built with (docs/spec/effects.md)
  localparam int SetsMax   = 4;
  localparam int PassesMax = 4;
  localparam int StagesMax = 8;
  localparam int AddendW   = 13;  // Q9.4
  // Widths of the structs below. Ports that hold several of them are plain vectors, item 0 lowest:
  // Yosys 0.23 reads `draw_t [3:0] port` as one draw_t, without a word.
  localparam int TextureW = 2 * SideBits + 4 + LevelsMax * LineBits;
  localparam int DrawW    = 27 + 2 * TextureW + 6 * 12 + 6 * 5 + 2 + 27;
  localparam int TapsW    = 4 + 4 * 32;
  localparam int BeatW    = 2 * PixelBits + 2 * LightMax + 1 + DrawBits + 3 + 2 + GroupBits +
                            2 * 25 + 2;
  localparam int EffectW  = 3 + 4 * PassesMax + 3 + StagesMax + 32 + SetsMax * (6 * 12 + 6 * 5);
  // Where a draw_t keeps what; a texture_t lies at DrawColorAt and at DrawMapAt
  localparam int DrawKsAt = 0, DrawKdAt = 9, DrawKaAt = 18, DrawPaletteAt = 27, DrawShiftAt = 29;
  localparam int DrawBiasAt = 59, DrawColorAt = 131, DrawMapAt = DrawColorAt + TextureW;
  localparam int DrawLodAt = DrawMapAt + TextureW, DrawHasColorAt = DrawLodAt + 13;
  localparam int DrawCombineAt = DrawLodAt + 14, DrawWrapVAt = DrawLodAt + 17;
  localparam int DrawWrapUAt = DrawLodAt + 19, DrawMipAt = DrawLodAt + 21;
  localparam int DrawBilinearAt = DrawLodAt + 23, DrawFormatAt = DrawLodAt + 24;
  localparam int LevelsAt = LevelsMax * LineBits;  // in a texture_t
  localparam int HeightAt = LevelsAt + 4, WidthAt = HeightAt + SideBits;
  // Where an effect_t keeps what
  localparam int EffectBiasAt = SetsMax * 6 * 5, EffectArgumentAt = EffectBiasAt + SetsMax * 6 * 12;
  localparam int EffectStagesAt = EffectArgumentAt + 32, EffectSetsAt = EffectStagesAt + StagesMax;
  localparam int EffectPassAt = EffectSetsAt + 3, EffectPassesAt = EffectPassAt + 4 * PassesMax;

  // Registers: docs/spec/unit.md, Registers
  localparam logic [31:0] Magic = 32'h50544d55;  // "PTMU"
  localparam logic [31:0] MapVersion = {16'd1, 16'd0};
  localparam int CapabilityWords = 8;
  localparam int Events = 5;  // bits of the event register
  localparam int EventIdle = 0, EventDraw = 1, EventTag = 2, EventLine = 3, EventRefused = 4;

  localparam logic [2:0] FormatNone = 0, FormatLrgb = 1, FormatRgb = 2, FormatPaletteLrgb = 3,
                         FormatPaletteRgb = 4;
  localparam logic [1:0] MipNone = 0, MipNearest = 1, MipLinear = 2;
  localparam logic [1:0] WrapRepeat = 0, WrapMirror = 1, WrapClamp = 2;
  localparam logic [2:0] CombineNone = 0, CombineModulate = 1, CombineDecal = 2, CombineBlend = 3,
                         CombineAdd = 4, CombineReplace = 5;

  typedef struct packed {
    logic [SideBits-1:0]                 width;
    logic [SideBits-1:0]                 height;
    logic [3:0]                          levels;
    logic [LevelsMax-1:0][LineBits-1:0]  base;
  } texture_t;

  typedef struct packed {
    logic [2:0]         format;
    logic               bilinear;
    logic [1:0]         mip;
    logic [1:0]         wrap_u;
    logic [1:0]         wrap_v;
    logic [2:0]         combine;
    logic               color;
    logic signed [12:0] color_lod;
    texture_t           ptm;
    texture_t           color_texture;
    logic [5:0][11:0]   bias;
    logic [5:0][4:0]    shift;
    logic [1:0]         palette;
    logic [8:0]         ka;
    logic [8:0]         kd;
    logic [8:0]         ks;
  } draw_t;

  // What effects add to a draw; a part that is not built in is 0
  typedef struct packed {
    logic [2:0]                passes;
    logic [PassesMax-1:0][3:0] pass;      // half, set [2:0]
    logic [2:0]                sets;
    logic [StagesMax-1:0]      stages;
    logic [31:0]               argument;
    logic [6*SetsMax-1:0][11:0] bias;     // six a set
    logic [6*SetsMax-1:0][4:0]  shift;
  } effect_t;

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
