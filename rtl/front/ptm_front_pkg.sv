// Formats between the stages of the texture unit's front, A0 to D: docs/spec/unit-timing.md.
// Widths are the largest that UnitConfig may ask for. Taps are 00 10 01 11 (bit 0 of a tap's number
// is its column, bit 1 its row); banks likewise: bit 0 is the parity in u, bit 1 in v.
//
// Several structs side by side are plain vectors, item 0 lowest, and struct variables stand outside
// generate blocks: Yosys 0.23 reads neither otherwise (ptm_unit_pkg.sv). Structs that move every
// cycle fit 64 bits, and a beat's parts travel as several: so the Verilated unit is faster.
package ptm_front_pkg;
  localparam int SetBits   = 8;   // of a tag bank: 64 KiB, direct mapped
  localparam int RowBits   = 10;  // of a data bank: a line's place, {tag bank, set, way}
  localparam int LineWidth = 512;
  localparam int PlaceBits = 8;   // {set, way} of a tag bank's line
  localparam int TakenW    = 16;
  localparam int ReadsW    = 6 + 4 * PlaceBits;
  localparam int PlaneBits = 5;   // of a word's plane within its texture: 21 planes

  // The level that a texture's footprint lies in (A1, A2)
  typedef struct packed {
    logic [3:0]  level;
    logic [12:0] width;
    logic [12:0] height;
    logic [25:0] base;
  } level_t;

  // One texture's texels in one footprint (A3)
  typedef struct packed {
    logic [1:0][11:0] i;           // columns, wrapped
    logic [1:0][11:0] j;           // rows
    logic [3:0]       level;
    logic             columns;     // both columns are fetched: wu is not 0
    logic             rows;
    logic             collides_u;  // the banks forbid both columns in one beat
    logic             collides_v;
  } texels_t;

  // Their tiles' lines: of tap {row, column} it is row_line[row] + column_line[column] + plane
  typedef struct packed {
    logic [1:0][25:0] row;
  } row_lines_t;
  typedef struct packed {
    logic [1:0][14:0] column;
  } column_lines_t;

  // Which of one texture's taps a (sub-)beat fetches, and where they lie; the same for all of its
  // words. Of a texel's place bit 2 chooses the tag bank, bit 1 the word in the data bank's row,
  // bit 0 the data bank.
  typedef struct packed {
    logic [1:0] columns;  // that are fetched
    logic [1:0] rows;
    logic [2:0] i1;       // places of columns 1 and 0
    logic [2:0] i0;
    logic [2:0] j1;       // of rows
    logic [2:0] j0;
  } taken_t;

  // The same by data bank and by tap (F)
  typedef struct packed {
    logic [3:0]  fetched;  // by tap
    logic [7:0]  bank;     // by tap: its data bank
    logic [3:0]  here;     // by data bank: it is read
    logic [15:0] at;       // by data bank: {tag bank of the tile, word in the row}
  } sources_t;

  // What a TMU reads, and which of it is on the way (fragment FIFO, K, F)
  typedef struct packed {
    logic                      fetched;  // it has a word that is fetched
    logic                      color;    // of the colour texture
    logic [3:0]                missed;   // first taps whose line comes through the miss ring
    logic [3:0][PlaceBits-1:0] place;    // by tag bank
  } reads_t;
endpackage
