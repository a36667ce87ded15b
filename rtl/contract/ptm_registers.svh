// Written by scripts/contract from contract/registers.toml and its neighbours.
//
// The register port of the texture unit: docs/spec/unit.md and docs/spec/effects.md, Registers. For
// inside a package, where Yosys 0.23 knows no constants of another one.
  localparam int Draws = 4;  // draws whose descriptors the unit holds
  localparam int DrawBits = 2;  // bits of a draw's number
  localparam int LevelsMax = 13;  // levels that a texture has at most
  localparam int LineBits = 26;  // bits of a line's address
  localparam int SideBits = 13;  // bits of a texture's width or height
  localparam int LargestSide = 4096;  // texels that a texture has a side at most
  localparam int ProbesLog2Max = 4;  // largest log2 of a fragment's probes
  localparam int LrgbPalettes = 4;  // palettes of LRGB
  localparam int LrgbIndexBits = 8;  // log2 of the entries of a palette of LRGB
  localparam int RgbIndexBits = 12;  // log2 of the entries of the palette of RGB
  localparam int ExtraSetsMax = 4;  // coefficient sets that effects add at most
  localparam int ExtraPassesMax = 4;  // evaluator passes that effects add at most
  localparam int StagesMax = 8;  // stages behind the combine stage at most
  localparam int TableEntries = 256;  // entries of a draw's table for stages
  localparam int Counters = 38;  // counters.toml
  localparam int
    CountFragments = 0, CountPixels = 1, CountCycles = 2, CountCyclesMoved = 3,
    CountCyclesOutputBlocked = 4, CountCyclesLineWait = 5, CountCyclesRingFull = 6,
    CountCyclesInputEmpty = 7, CountBeats = 8, CountBankConflicts = 9, CountWords = 10,
    CountTaps = 11, CountTagHits = 12, CountTagMisses = 13, CountLinesRead = 14,
    CountDuplicateLines = 15, CountPaletteLookups = 16, CountMultipliesAddress = 17,
    CountMultipliesFilter = 18, CountMultipliesEval = 19, CountMultipliesCombine = 20,
    CountHitsD0Map = 21, CountMissesD0Map = 22, CountHitsD0Color = 23, CountMissesD0Color = 24,
    CountHitsD1Map = 25, CountMissesD1Map = 26, CountHitsD1Color = 27, CountMissesD1Color = 28,
    CountHitsD2Map = 29, CountMissesD2Map = 30, CountHitsD2Color = 31, CountMissesD2Color = 32,
    CountHitsD3Map = 33, CountMissesD3Map = 34, CountHitsD3Color = 35, CountMissesD3Color = 36,
    CountMultipliesEffects = 37;

  // Codes: format of a map's texels
  localparam logic [2:0]
    FormatNone = 3'd0, FormatLrgb = 3'd1, FormatRgb = 3'd2, FormatPaletteLrgb = 3'd3,
    FormatPaletteRgb = 3'd4, FormatLast = 3'd4;
  // Codes: which levels of a texture are filtered
  localparam logic [1:0]
    MipNone = 2'd0, MipNearest = 2'd1, MipLinear = 2'd2, MipLast = 2'd2;
  // Codes: what lies beyond a texture's edge
  localparam logic [1:0]
    WrapRepeat = 2'd0, WrapMirror = 2'd1, WrapClamp = 2'd2, WrapLast = 2'd2;
  // Codes: what becomes of the map's colour and the colour texture's
  localparam logic [2:0]
    CombineNone = 3'd0, CombineModulate = 3'd1, CombineDecal = 3'd2, CombineBlend = 3'd3,
    CombineAdd = 3'd4, CombineReplace = 3'd5, CombineLast = 3'd5;

  // Blocks of registers: the first address, addresses, from one instance to the next
  // draw descriptors
  localparam logic [15:0] DrawBlock = 16'h0000;
  localparam int DrawSize = 256, DrawStride = 64;
  // command, state, events, identification, capabilities
  localparam logic [15:0] UnitBlock = 16'h1000;
  localparam int UnitSize = 32, UnitStride = 32;
  // counters; 0 if one is not built in
  localparam logic [15:0] CounterBlock = 16'h2000;
  localparam int CounterSize = 128, CounterStride = 2;
  // coefficient sets of draws
  localparam logic [15:0] SetBlock = 16'h2800;
  localparam int SetSize = 128, SetStride = 32;
  // tables of effect stages
  localparam logic [15:0] TableBlock = 16'h3000;
  localparam int TableSize = 1024, TableStride = 256;
  // palettised LRGB: entry e = 256 palette + index
  localparam logic [15:0] LrgbPaletteBlock = 16'h4000;
  localparam int LrgbPaletteSize = 2048, LrgbPaletteStride = 2;
  // palettised RGB
  localparam logic [15:0] RgbPaletteBlock = 16'h8000;
  localparam int RgbPaletteSize = 32768, RgbPaletteStride = 8;

  // Registers: addresses, and offsets in an instance of their block; fields: the lowest
  // bit and the width
  localparam logic [5:0] DrawControlOffset = 6'd0;
  localparam int DrawControlFormatLow = 0, DrawControlFormatW = 3;
  localparam int DrawControlMipLow = 3, DrawControlMipW = 2;
  localparam int DrawControlBilinearLow = 5, DrawControlBilinearW = 1;
  localparam int DrawControlWrapULow = 6, DrawControlWrapUW = 2;
  localparam int DrawControlWrapVLow = 8, DrawControlWrapVW = 2;
  localparam int DrawControlCombineLow = 10, DrawControlCombineW = 3;
  localparam int DrawControlColorLow = 13, DrawControlColorW = 1;
  localparam int DrawControlPaletteLow = 14, DrawControlPaletteW = 2;
  localparam logic [5:0] DrawMapSizeOffset = 6'd1;
  localparam int DrawMapSizeWidthLow = 0, DrawMapSizeWidthW = 13;
  localparam int DrawMapSizeHeightLow = 16, DrawMapSizeHeightW = 13;
  localparam logic [5:0] DrawColorSizeOffset = 6'd2;
  localparam int DrawColorSizeWidthLow = 0, DrawColorSizeWidthW = 13;
  localparam int DrawColorSizeHeightLow = 16, DrawColorSizeHeightW = 13;
  localparam logic [5:0] DrawLevelsOffset = 6'd3;
  localparam int DrawLevelsMapLow = 0, DrawLevelsMapW = 4;
  localparam int DrawLevelsColorLow = 8, DrawLevelsColorW = 4;
  localparam int DrawLevelsColorLodLow = 16, DrawLevelsColorLodW = 13;
  localparam logic [5:0] DrawCoefficientOffset = 6'd4;
  localparam int DrawCoefficientBiasLow = 0, DrawCoefficientBiasW = 12;
  localparam int DrawCoefficientShiftLow = 16, DrawCoefficientShiftW = 5;
  localparam logic [5:0] DrawWeightsOffset = 6'd10;
  localparam int DrawWeightsKaLow = 0, DrawWeightsKaW = 9;
  localparam int DrawWeightsKdLow = 9, DrawWeightsKdW = 9;
  localparam int DrawWeightsKsLow = 18, DrawWeightsKsW = 9;
  localparam logic [5:0] DrawPassesOffset = 6'd12;
  localparam int DrawPassesPassesLow = 0, DrawPassesPassesW = 3;
  localparam int DrawPassesSetLow = 4, DrawPassesSetW = 3;
  localparam int DrawPassesHalfLow = 7, DrawPassesHalfW = 1;
  localparam int DrawPassesSetStep = 4;
  localparam int DrawPassesHalfStep = 4;
  localparam logic [5:0] DrawEffectsOffset = 6'd13;
  localparam int DrawEffectsSetsLow = 0, DrawEffectsSetsW = 3;
  localparam int DrawEffectsStagesLow = 8, DrawEffectsStagesW = 8;
  localparam logic [5:0] DrawArgumentOffset = 6'd14;
  localparam int DrawArgumentArgumentLow = 0, DrawArgumentArgumentW = 32;
  localparam logic [5:0] DrawMapBaseOffset = 6'd16;
  localparam int DrawMapBaseBaseLow = 0, DrawMapBaseBaseW = 26;
  localparam logic [5:0] DrawColorBaseOffset = 6'd32;
  localparam int DrawColorBaseBaseLow = 0, DrawColorBaseBaseW = 26;
  localparam logic [15:0] CommandAddr = 16'h1000;
  localparam logic [4:0] CommandOffset = 5'd0;
  localparam int CommandInvalidateLow = 0, CommandInvalidateW = 1;
  localparam int CommandClearLow = 1, CommandClearW = 1;
  localparam logic [15:0] MemoryLinesAddr = 16'h1001;
  localparam logic [4:0] MemoryLinesOffset = 5'd1;
  localparam int MemoryLinesLinesLow = 0, MemoryLinesLinesW = 27;
  localparam logic [15:0] ErrorsAddr = 16'h1002;
  localparam logic [4:0] ErrorsOffset = 5'd2;
  localparam int ErrorsDrawLow = 0, ErrorsDrawW = 4;
  localparam int ErrorsDrawStep = 8;
  localparam logic [15:0] StateAddr = 16'h1003;
  localparam logic [4:0] StateOffset = 5'd3;
  localparam int StateBusyLow = 0, StateBusyW = 1;
  localparam int StateWrongTagLow = 1, StateWrongTagW = 1;
  localparam int StateDrainingLow = 2, StateDrainingW = 1;
  localparam int StateTagLow = 8, StateTagW = 8;
  localparam logic [15:0] MemoryBaseAddr = 16'h1004;
  localparam logic [4:0] MemoryBaseOffset = 5'd4;
  localparam int MemoryBaseBaseLow = 0, MemoryBaseBaseW = 26;
  localparam logic [15:0] PaletteUpperAddr = 16'h1005;
  localparam logic [4:0] PaletteUpperOffset = 5'd5;
  localparam int PaletteUpperBitsLow = 0, PaletteUpperBitsW = 4;
  localparam logic [15:0] EventsAddr = 16'h1008;
  localparam logic [4:0] EventsOffset = 5'd8;
  localparam int EventsIdleLow = 0, EventsIdleW = 1;
  localparam int EventsDrawErrorLow = 1, EventsDrawErrorW = 1;
  localparam int EventsWrongTagLow = 2, EventsWrongTagW = 1;
  localparam int EventsFailedLineLow = 3, EventsFailedLineW = 1;
  localparam int EventsRefusedLow = 4, EventsRefusedW = 1;
  localparam int EventsW = 5;
  localparam logic [15:0] EnableAddr = 16'h1009;
  localparam logic [4:0] EnableOffset = 5'd9;
  localparam int EnableEventsLow = 0, EnableEventsW = 5;
  localparam logic [15:0] MagicAddr = 16'h1010;
  localparam logic [4:0] MagicOffset = 5'd16;
  localparam int MagicMagicLow = 0, MagicMagicW = 32;
  localparam logic [31:0] MagicReset = 32'h50544d55;
  localparam logic [15:0] VersionAddr = 16'h1011;
  localparam logic [4:0] VersionOffset = 5'd17;
  localparam int VersionMinorLow = 0, VersionMinorW = 16;
  localparam int VersionMajorLow = 16, VersionMajorW = 16;
  localparam logic [31:0] VersionReset = 32'h00010001;
  localparam logic [15:0] BuiltUnitAddr = 16'h1012;
  localparam logic [4:0] BuiltUnitOffset = 5'd18;
  localparam int BuiltUnitTmusLow = 0, BuiltUnitTmusW = 2;
  localparam int BuiltUnitWaysLow = 4, BuiltUnitWaysW = 3;
  localparam int BuiltUnitCacheKibLow = 8, BuiltUnitCacheKibW = 7;
  localparam int BuiltUnitPaletteLrgbPortsLow = 16, BuiltUnitPaletteLrgbPortsW = 3;
  localparam int BuiltUnitPaletteRgbPortsLow = 20, BuiltUnitPaletteRgbPortsW = 3;
  localparam int BuiltUnitEvalLanesLow = 24, BuiltUnitEvalLanesW = 2;
  localparam int BuiltUnitCountersLow = 28, BuiltUnitCountersW = 1;
  localparam int BuiltUnitDuplicateLinesLow = 29, BuiltUnitDuplicateLinesW = 1;
  localparam logic [15:0] BuiltFifosAddr = 16'h1013;
  localparam logic [4:0] BuiltFifosOffset = 5'd19;
  localparam int BuiltFifosFragmentFifoLow = 0, BuiltFifosFragmentFifoW = 11;
  localparam int BuiltFifosMissFifoLow = 16, BuiltFifosMissFifoW = 9;
  localparam logic [15:0] BuiltEffectsAddr = 16'h1014;
  localparam logic [4:0] BuiltEffectsOffset = 5'd20;
  localparam int BuiltEffectsExtraSetsLow = 0, BuiltEffectsExtraSetsW = 3;
  localparam int BuiltEffectsExtraPassesLow = 4, BuiltEffectsExtraPassesW = 3;
  localparam int BuiltEffectsHalfVectorLow = 8, BuiltEffectsHalfVectorW = 1;
  localparam int BuiltEffectsStagesLow = 16, BuiltEffectsStagesW = 8;
  localparam logic [15:0] ChoicesAddr = 16'h1015;
  localparam logic [4:0] ChoicesOffset = 5'd21;
  localparam int ChoicesFormatLow = 0, ChoicesFormatW = 8;
  localparam int ChoicesMipLow = 8, ChoicesMipW = 3;
  localparam int ChoicesWrapLow = 12, ChoicesWrapW = 3;
  localparam int ChoicesCombineLow = 16, ChoicesCombineW = 6;
  localparam int ChoicesBilinearLow = 24, ChoicesBilinearW = 1;
  localparam int ChoicesProbesLog2Low = 28, ChoicesProbesLog2W = 3;
  localparam logic [15:0] SizesAddr = 16'h1016;
  localparam logic [4:0] SizesOffset = 5'd22;
  localparam int SizesLargestSideLow = 0, SizesLargestSideW = 13;
  localparam int SizesLevelsLow = 16, SizesLevelsW = 4;
  localparam int SizesDrawsLow = 24, SizesDrawsW = 3;
  localparam int SizesLineBitsLow = 27, SizesLineBitsW = 5;
  localparam logic [15:0] PalettesAddr = 16'h1017;
  localparam logic [4:0] PalettesOffset = 5'd23;
  localparam int PalettesLrgbPalettesLow = 0, PalettesLrgbPalettesW = 3;
  localparam int PalettesLrgbIndexBitsLow = 4, PalettesLrgbIndexBitsW = 4;
  localparam int PalettesRgbIndexBitsLow = 8, PalettesRgbIndexBitsW = 4;
  localparam logic [15:0] BuiltEvaluatorAddr = 16'h1018;
  localparam logic [4:0] BuiltEvaluatorOffset = 5'd24;
  localparam int BuiltEvaluatorCoefBitsLow = 0, BuiltEvaluatorCoefBitsW = 4;
  localparam int BuiltEvaluatorDeltaBitsLow = 4, BuiltEvaluatorDeltaBitsW = 4;
  localparam int BuiltEvaluatorLightIntLow = 8, BuiltEvaluatorLightIntW = 2;
  localparam int BuiltEvaluatorLightFracLow = 12, BuiltEvaluatorLightFracW = 4;
  localparam int BuiltEvaluatorBasisFracLow = 16, BuiltEvaluatorBasisFracW = 5;
  localparam int BuiltEvaluatorGuardLow = 24, BuiltEvaluatorGuardW = 4;
  localparam int BuiltEvaluatorRoundingLow = 28, BuiltEvaluatorRoundingW = 1;
  localparam logic [15:0] BuiltLuminanceAddr = 16'h1019;
  localparam logic [4:0] BuiltLuminanceOffset = 5'd25;
  localparam int BuiltLuminanceLumBitsLow = 0, BuiltLuminanceLumBitsW = 4;
  localparam int BuiltLuminanceLumFracLow = 4, BuiltLuminanceLumFracW = 3;
  localparam int BuiltLuminanceShiftMinLow = 8, BuiltLuminanceShiftMinW = 4;
  localparam int BuiltLuminanceShiftGroupsLow = 12, BuiltLuminanceShiftGroupsW = 3;
  localparam int BuiltLuminanceFilterFracLow = 16, BuiltLuminanceFilterFracW = 3;
  localparam logic [0:0] CounterLowOffset = 1'd0;
  localparam int CounterLowCountLow = 0, CounterLowCountW = 32;
  localparam logic [0:0] CounterHighOffset = 1'd1;
  localparam int CounterHighCountLow = 0, CounterHighCountW = 32;
  localparam logic [4:0] SetCoefficientOffset = 5'd0;
  localparam int SetCoefficientBiasLow = 0, SetCoefficientBiasW = 12;
  localparam int SetCoefficientShiftLow = 16, SetCoefficientShiftW = 5;
  localparam logic [7:0] TableEntryOffset = 8'd0;
  localparam int TableEntryEntryLow = 0, TableEntryEntryW = 12;
  localparam logic [0:0] LrgbPaletteWordOffset = 1'd0;
  localparam int LrgbPaletteWordCoefficientsLow = 0, LrgbPaletteWordCoefficientsW = 32;
  localparam logic [2:0] RgbPaletteWordOffset = 3'd0;
  localparam int RgbPaletteWordCoefficientsLow = 0, RgbPaletteWordCoefficientsW = 32;
  localparam logic [4:0] CapabilitiesOffset = 5'd18;
  localparam int CapabilityWords = 8;

  // Packed vectors: widths, places of their parts (of element 0), structs. Ports that
  // hold several are plain vectors, item 0 lowest: Yosys 0.23 reads `draw_t [3:0] port`
  // as one draw_t, without a word.
  localparam int TextureW = 368;
  localparam int
    TextureWidthAt = 355, TextureHeightAt = 342, TextureLevelsAt = 338, TextureBaseAt = 0;
  localparam int
    TextureWidthW = 13, TextureHeightW = 13, TextureLevelsW = 4, TextureBaseW = 26;
  // one texture as the unit addresses it
  typedef struct packed {
    logic [12:0] width;
    logic [12:0] height;
    logic [3:0] levels;
    logic [12:0][25:0] base;
  } texture_t;

  localparam int DrawW = 894;
  localparam int
    DrawFormatAt = 891, DrawBilinearAt = 890, DrawMipAt = 888, DrawWrapUAt = 886, DrawWrapVAt = 884,
    DrawCombineAt = 881, DrawColorAt = 880, DrawColorLodAt = 867, DrawPtmAt = 499,
    DrawColorTextureAt = 131, DrawBiasAt = 59, DrawShiftAt = 29, DrawPaletteAt = 27, DrawKaAt = 18,
    DrawKdAt = 9, DrawKsAt = 0;
  localparam int
    DrawFormatW = 3, DrawBilinearW = 1, DrawMipW = 2, DrawWrapUW = 2, DrawWrapVW = 2,
    DrawCombineW = 3, DrawColorW = 1, DrawColorLodW = 13, DrawPtmW = 368, DrawColorTextureW = 368,
    DrawBiasW = 12, DrawShiftW = 5, DrawPaletteW = 2, DrawKaW = 9, DrawKdW = 9, DrawKsW = 9;
  // a draw's descriptor
  typedef struct packed {
    logic [2:0] format;
    logic bilinear;
    logic [1:0] mip;
    logic [1:0] wrap_u;
    logic [1:0] wrap_v;
    logic [2:0] combine;
    logic color;
    logic signed [12:0] color_lod;
    texture_t ptm;
    texture_t color_texture;
    logic [5:0][11:0] bias;
    logic [5:0][4:0] shift;
    logic [1:0] palette;
    logic [8:0] ka;
    logic [8:0] kd;
    logic [8:0] ks;
  } draw_t;

  localparam int EffectW = 470;
  localparam int
    EffectPassesAt = 467, EffectPassAt = 451, EffectSetsAt = 448, EffectStagesAt = 440,
    EffectArgumentAt = 408, EffectBiasAt = 120, EffectShiftAt = 0;
  localparam int
    EffectPassesW = 3, EffectPassW = 4, EffectSetsW = 3, EffectStagesW = 8, EffectArgumentW = 32,
    EffectBiasW = 12, EffectShiftW = 5;
  // what effects add to a draw; a part that is not built in is 0
  typedef struct packed {
    logic [2:0] passes;
    logic [3:0][3:0] pass;
    logic [2:0] sets;
    logic [7:0] stages;
    logic [31:0] argument;
    logic [23:0][11:0] bias;
    logic [23:0][4:0] shift;
  } effect_t;

