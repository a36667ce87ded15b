// What one TMU looks up for its word of a (sub-)beat: the taps' distinct tiles, by tag bank.
//
//   set = ({ty'[ky-1:0], tx'[kx-1:0]} xor (plane + 3 * level + 5 * texture + (tx' >> kx)
//         + (ty' >> ky))) mod Sets                       docs/spec/unit-timing.md, Tags
//
// Taps of one (sub-)beat never want two tiles of one tag bank, nor two texels of one data bank: A3
// has split what would. Combinational.
module ptm_unit_lookup #(
  parameter int Sets = 32  // of one tag bank, a power of two
) (
  input  ptm_unit_front_pkg::texels_t texels_map_i,
  input  ptm_unit_front_pkg::texels_t texels_color_i,
  input  logic                        color_i,    // the word's texture; 0: the map
  input  logic                        fetched_i,  // the TMU has a word, and its texture has taps
  input  logic [2:0]                  plane_i,
  input  logic [3:0]                  taps_i,     // of the sub-beat
  output ptm_unit_front_pkg::lookup_t lookup_o,
  output logic [2:0]                  taps_o      // how many are fetched
);
  localparam int SetBits  = ptm_unit_front_pkg::SetBits;
  localparam int LineBits = ptm_unit_pkg::LineBits;
  localparam int K        = $clog2(Sets);
  localparam int Kx       = (K + 1) / 2;
  localparam int Ky       = K - Kx;

  ptm_unit_front_pkg::texels_t texels;
  assign texels = color_i ? texels_color_i : texels_map_i;

  logic [3:0] fetched;
  assign fetched = {texels.columns && texels.rows, texels.rows, texels.columns, 1'b1} & taps_i &
                   {4{fetched_i}};
  assign taps_o  = 3'(fetched[0]) + 3'(fetched[1]) + 3'(fetched[2]) + 3'(fetched[3]);

  logic [11:0] i0, i1, j0, j1;
  logic        same_x, same_y;  // the columns' tiles
  assign i0     = texels.i[0];
  assign i1     = texels.i[1];
  assign j0     = texels.j[0];
  assign j1     = texels.j[1];
  assign same_x = i0[11:2] == i1[11:2];
  assign same_y = j0[11:2] == j1[11:2];

  logic [3:0] first;
  assign first[0] = fetched[0];
  assign first[1] = fetched[1] && !(fetched[0] && same_x);
  assign first[2] = fetched[2] && !(fetched[0] && same_y) && !(fetched[1] && same_x && same_y);
  assign first[3] = fetched[3] && !(fetched[0] && same_x && same_y) && !(fetched[1] && same_y) &&
                    !(fetched[2] && same_x);

  // The hash is a sum of a part for the word, one for the column and one for the row. Modulo
  // 2^SetBits, of which Sets is a factor.
  logic [SetBits-1:0] hash_word;
  assign hash_word = SetBits'(plane_i) + SetBits'(texels.level) + (SetBits'(texels.level) << 1) +
                     (color_i ? SetBits'(5) : '0);

  logic [7:0]           bank;  // by tap
  logic [4*SetBits-1:0] set_index;
  for (genvar t = 0; t < 4; t++) begin : gen_tap
    logic [8:0]         x, y;  // tx', ty': within the bank
    logic [SetBits-1:0] low, hash;
    assign x    = t % 2 == 1 ? i1[11:3] : i0[11:3];
    assign y    = t / 2 == 1 ? j1[11:3] : j0[11:3];
    assign low  = SetBits'(((y & 9'((1 << Ky) - 1)) << Kx) | (x & 9'((1 << Kx) - 1)));
    assign hash = hash_word + SetBits'(x >> Kx) + SetBits'(y >> Ky);
    assign set_index[t*SetBits +: SetBits] = (low ^ hash) & SetBits'(Sets - 1);
    assign bank[t*2 +: 2] = {t / 2 == 1 ? j1[2] : j0[2], t % 2 == 1 ? i1[2] : i0[2]};
  end

  // To the banks
  logic [3:0]            used;
  logic [4*LineBits-1:0] bank_line;
  logic [4*SetBits-1:0]  bank_set;
  for (genvar b = 0; b < 4; b++) begin : gen_bank
    logic [3:0] here;
    for (genvar t = 0; t < 4; t++) begin : gen_here
      assign here[t] = fetched[t] && bank[t*2 +: 2] == 2'(b);
    end
    logic [1:0] tap;  // any of them: they share the tile
    assign tap     = here[0] ? 2'd0 : here[1] ? 2'd1 : here[2] ? 2'd2 : 2'd3;
    assign used[b] = here != 4'd0;
    assign bank_line[b*LineBits +: LineBits] = texels.line[tap] + LineBits'(plane_i);
    assign bank_set[b*SetBits +: SetBits]    = set_index[tap*SetBits +: SetBits];
  end

  always_comb begin
    lookup_o           = '0;
    lookup_o.fetched   = fetched;
    lookup_o.first     = first;
    lookup_o.bank      = bank;
    lookup_o.used      = used;
    lookup_o.line      = bank_line;
    lookup_o.set_index = bank_set;
    lookup_o.i         = {i1[1:0], i0[1:0]};
    lookup_o.j         = {j1[1:0], j0[1:0]};
    lookup_o.color     = color_i;
  end
endmodule
