// Written by scripts/contract from contract/parameters.toml; change it there.
  // stored coefficient, unsigned; 4..12
  parameter int CoefBits       = 8,
  // words fetched side by side, each with a cache of its own; 1..3
  parameter int Tmus           = 3,
  // size of one TMU's cache; 1, 2, 4, 8, 16, 32, 64
  parameter int CacheKib       = 16,
  // ways of a cache; 1, 2, 4
  parameter int Ways           = 2,
  // beats between T and K; 4..1024
  parameter int FragmentFifo   = 192,
  // lines of the miss ring, reserved or outstanding; 4 * Tmus..256
  parameter int MissFifo       = 64,
  // coefficient sets of a texel beyond the map's, for effects; 0..ExtraPasses
  parameter int ExtraSets      = 0,
  // mask of effect stages behind the combine stage; a mask
  parameter int Stages         = 0,
  // the counters, which only tell of the unit's work; 0, 1
  parameter int Counters       = 1,
  // the counter of that name; 0, 1; needs Counters
  parameter int DuplicateLines = 1
