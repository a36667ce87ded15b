// Written by scripts/contract from contract/parameters.toml; change it there.
  // stored coefficient, unsigned; 4..12
  parameter int CoefBits     = 8,
  // coefficient less its bias, signed; 5..13
  parameter int DeltaBits    = 9,
  // integer bits of a light coordinate, sign included; 1..3
  parameter int LightInt     = 2,
  // fraction bits of a light coordinate; 4..14
  parameter int LightFrac    = 8,
  // fraction bits kept of the quadratic basis lu*lu, lv*lv, lu*lv; 4..2 * LightFrac
  parameter int BasisFrac    = 8,
  // fraction bits in the accumulator; 0..12
  parameter int Guard        = 4,
  // how every narrowing rounds; 0: truncate, 1: nearest
  parameter int RoundNearest = 1,
  // integer bits of luminance after the clamp, unsigned; 8..12
  parameter int LumBits      = 10,
  // fraction bits of luminance; 0..4
  parameter int LumFrac      = 0,
  // lowest shift built for, which bounds the width of the sum; the highest is 15; -8..0
  parameter int ShiftMin     = -4,
  // six shifts, or three: a0 a1 a2, a3 a4, a5; 3, 6
  parameter int ShiftGroups  = 6,
  // fraction bits that filtering leaves on coefficients and colour; 0..4
  parameter int FilterFrac   = 0
