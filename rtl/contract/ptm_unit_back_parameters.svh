// Written by scripts/contract from contract/parameters.toml; change it there.
  // stored coefficient, unsigned; 4..12
  parameter int CoefBits         = 8,
  // coefficient less its bias, signed; 5..13
  parameter int DeltaBits        = 9,
  // integer bits of a light coordinate, sign included; 1..3
  parameter int LightInt         = 2,
  // fraction bits of a light coordinate; 4..14
  parameter int LightFrac        = 8,
  // fraction bits kept of the quadratic basis lu*lu, lv*lv, lu*lv; 4..2 * LightFrac
  parameter int BasisFrac        = 8,
  // fraction bits in the accumulator; 0..12
  parameter int Guard            = 4,
  // how every narrowing rounds; 0: truncate, 1: nearest
  parameter int RoundNearest     = 1,
  // integer bits of luminance after the clamp, unsigned; 8..12
  parameter int LumBits          = 10,
  // fraction bits of luminance; 0..4
  parameter int LumFrac          = 0,
  // lowest shift built for, which bounds the width of the sum; the highest is 15; -8..0
  parameter int ShiftMin         = -4,
  // six shifts, or three: a0 a1 a2, a3 a4, a5; 3, 6
  parameter int ShiftGroups      = 6,
  // fraction bits that filtering leaves on coefficients and colour; 0..4
  parameter int FilterFrac       = 0,
  // words fetched side by side, each with a cache of its own; 1..3
  parameter int Tmus             = 3,
  // look-ups a cycle in the palettes of LRGB maps; 1, 2, 4
  parameter int PaletteLrgbPorts = 4,
  // look-ups a cycle in the palette of RGB maps; 1, 2, 4
  parameter int PaletteRgbPorts  = 1,
  // evaluators side by side; with three, one a channel of an RGB map; 1, 3
  parameter int EvalLanes        = 1,
  // coefficient sets of a texel beyond the map's, for effects; 0..ExtraPasses
  parameter int ExtraSets        = 0,
  // evaluator passes of a fragment beyond the map's, for effects; 0..4
  parameter int ExtraPasses      = 0,
  // fragments bring (hu, hv), for effects; 0, 1; needs ExtraPasses
  parameter int HalfVector       = 0,
  // mask of effect stages behind the combine stage; a mask
  parameter int Stages           = 0
