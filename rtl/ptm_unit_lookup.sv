// What one texture's taps of a (sub-)beat need looked up: their distinct tiles, by tag bank.
//
//   set = ({ty'[ky-1:0], tx'[kx-1:0]} xor (plane + 3 * level + 5 * texture + (tx' >> kx)
//         + (ty' >> ky))) mod Sets                       docs/spec/unit-timing.md, Tags
//
// The word's plane is an input, so this is one TMU's. Taps of one (sub-)beat never want two tiles
// of one bank, nor two texels of one data bank: A3 has split what would. Combinational.
module ptm_unit_lookup #(
  parameter int Sets = 32  // of one tag bank, a power of two
) (
  input  ptm_unit_front_pkg::texels_t texels_i,
  input  logic                        color_i,   // 0: the map
  input  logic                        fetched_i, // the TMU has a word, and its texture has taps
  input  logic [2:0]                  plane_i,
  input  logic [3:0]                  taps_i,    // of the sub-beat
  output ptm_unit_front_pkg::lookup_t lookup_o
);
  localparam int SetBits = ptm_unit_front_pkg::SetBits;
  localparam int K       = $clog2(Sets);
  localparam int Kx      = (K + 1) / 2;
  localparam int Ky      = K - Kx;

  logic [3:0] fetched;
  assign fetched = {texels_i.columns && texels_i.rows, texels_i.rows, texels_i.columns, 1'b1} &
                   taps_i & {4{fetched_i}};

  logic [9:0] tx0, tx1, ty0, ty1;
  logic       same_x, same_y;
  assign tx0    = texels_i.i[0][11:2];
  assign tx1    = texels_i.i[1][11:2];
  assign ty0    = texels_i.j[0][11:2];
  assign ty1    = texels_i.j[1][11:2];
  assign same_x = tx0 == tx1;
  assign same_y = ty0 == ty1;

  logic [3:0] first;
  assign first[0] = fetched[0];
  assign first[1] = fetched[1] && !(fetched[0] && same_x);
  assign first[2] = fetched[2] && !(fetched[0] && same_y) && !(fetched[1] && same_x && same_y);
  assign first[3] = fetched[3] && !(fetched[0] && same_x && same_y) && !(fetched[1] && same_y) &&
                    !(fetched[2] && same_x);

  // The hash is a sum of a part for the word, one for the column and one for the row. Modulo
  // 2^SetBits, of which Sets is a factor.
  logic [SetBits-1:0] hash_word;
  logic [SetBits-1:0] hash_x [2];
  logic [SetBits-1:0] hash_y [2];
  logic [SetBits-1:0] low_x [2];
  logic [SetBits-1:0] low_y [2];
  assign hash_word = SetBits'(plane_i) + SetBits'(texels_i.level) +
                     (SetBits'(texels_i.level) << 1) + (color_i ? SetBits'(5) : '0);
  for (genvar c = 0; c < 2; c++) begin : gen_side
    logic [8:0] x, y;  // tx', ty': within the bank
    assign x         = texels_i.i[c][11:3];
    assign y         = texels_i.j[c][11:3];
    assign hash_x[c] = SetBits'(x >> Kx);
    assign hash_y[c] = SetBits'(y >> Ky);
    assign low_x[c]  = SetBits'(x & 9'((1 << Kx) - 1));
    assign low_y[c]  = SetBits'((y & 9'((1 << Ky) - 1)) << Kx);
  end

  logic [3:0][1:0]         bank;  // by tap
  logic [3:0][SetBits-1:0] set;
  for (genvar t = 0; t < 4; t++) begin : gen_tap
    assign bank[t] = {texels_i.j[t/2][2], texels_i.i[t%2][2]};
    assign set[t]  = ((low_y[t/2] | low_x[t%2]) ^ (hash_word + hash_x[t%2] + hash_y[t/2])) &
                     SetBits'(Sets - 1);
  end

  // To the banks
  logic [3:0]                               used;
  logic [3:0][ptm_unit_pkg::LineBits-1:0]   bank_line;
  logic [3:0][SetBits-1:0]                  bank_set;
  for (genvar b = 0; b < 4; b++) begin : gen_bank
    logic [3:0] here;
    for (genvar t = 0; t < 4; t++) begin : gen_here
      assign here[t] = fetched[t] && bank[t] == 2'(b);
    end
    logic [1:0] tap;  // any of them: they share the tile
    assign tap          = here[0] ? 2'd0 : here[1] ? 2'd1 : here[2] ? 2'd2 : 2'd3;
    assign used[b]      = here != 4'd0;
    assign bank_line[b] = texels_i.line[tap] + ptm_unit_pkg::LineBits'(plane_i);
    assign bank_set[b]  = set[tap];
  end

  always_comb begin
    lookup_o           = '0;
    lookup_o.fetched   = fetched;
    lookup_o.first     = first;
    lookup_o.bank      = bank;
    lookup_o.used      = used;
    lookup_o.line      = bank_line;
    lookup_o.set_index = bank_set;
    lookup_o.i         = {texels_i.i[1][1:0], texels_i.i[0][1:0]};
    lookup_o.j         = {texels_i.j[1][1:0], texels_i.j[0][1:0]};
    lookup_o.color     = color_i;
  end
endmodule
