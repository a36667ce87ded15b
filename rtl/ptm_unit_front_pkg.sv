// Formats between the stages of the texture unit's front, A0 to D: docs/spec/unit-timing.md.
// Widths are the largest that UnitConfig may ask for. Taps are 00 10 01 11 (bit 0 of a tap's number
// is its column, bit 1 its row); banks likewise: bit 0 is the parity in u, bit 1 in v.
//
// Several structs side by side are plain vectors, item 0 lowest, and struct variables stand outside
// generate blocks: Yosys 0.23 reads neither otherwise (ptm_unit_pkg.sv).
package ptm_unit_front_pkg;
  localparam int SetBits   = 8;   // of a tag bank: 64 KiB, direct mapped
  localparam int RowBits   = 10;  // of a data bank: a line's place, {tag bank, set, way}
  localparam int LineWidth = 512;
  localparam int BankWidth = 128; // a line's four words of one texel parity
  localparam int LookupW   = 21 + 4 * 26 + 4 * SetBits + 8;
  localparam int ReadsW    = 16 + 4 * RowBits;

  // The level that a texture's footprint lies in (A1, A2)
  typedef struct packed {
    logic [3:0]  level;
    logic [12:0] width;
    logic [12:0] height;
    logic [25:0] base;
  } level_t;

  // One texture's texels in one footprint (A3)
  typedef struct packed {
    logic             columns;  // both columns are fetched: wu is not 0
    logic             rows;
    logic [1:0][11:0] i;        // columns, wrapped
    logic [1:0][11:0] j;        // rows
    logic [3:0][25:0] line;     // of each tap's tile, plane 0
    logic [3:0]       level;
    logic             collides_u;  // the banks forbid both columns in one beat
    logic             collides_v;
  } texels_t;

  // What a TMU looks up for its word of a (sub-)beat (T)
  typedef struct packed {
    logic [3:0]              fetched;    // taps
    logic [3:0]              first;      // the tap is the first that needs its tile: a look-up
    logic [3:0][1:0]         bank;       // by tap: the tag bank of its tile
    logic [3:0]              used;       // by bank: it has a look-up, for this line in this set
    logic [3:0][25:0]        line;
    logic [3:0][SetBits-1:0] set_index;
    logic [1:0][1:0]         i;          // columns and rows within their tile
    logic [1:0][1:0]         j;
    logic                    color;      // 0: a word of the map
  } lookup_t;

  // What it reads, and which of it is on the way (fragment FIFO, K, F)
  typedef struct packed {
    logic [3:0]              fetched;  // taps
    logic [3:0]              missed;   // first taps whose line comes through the miss ring
    logic [3:0][RowBits-1:0] row;      // by tap
    logic [1:0][1:0]         i;
    logic [1:0][1:0]         j;
  } reads_t;
endpackage
