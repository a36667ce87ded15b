// U2 and what follows from it, one texture: level and weight of the fragment's footprints, and the
// size and place of the level that this footprint lies in.
//
//   W_l = max(1, W >> l)                                           docs/spec/unit.md, U2, U4
//
// A texture that the draw has not has f = 0 and is not fetched. Combinational.
module ptm_front_footprint (
  input  ptm_unit_pkg::texture_t             texture_i,
  input  logic                               has_i,     // the draw has this texture
  input  logic [1:0]                         mip_i,
  input  logic [ptm_unit_pkg::LodBits-1:0]   lod_i,
  input  logic                               second_i,  // footprint m = 1
  output logic [7:0]                         weight_o,  // f
  output logic                               fetched_o,
  output ptm_front_pkg::level_t         level_o
);
  logic [3:0] chosen, level;
  logic [7:0] weight;
  ptm_front_level u_level (
    .mip_i(mip_i), .lod_i(lod_i), .levels_i(texture_i.levels), .level_o(chosen),
    .weight_o(weight)
  );
  assign weight_o  = has_i ? weight : 8'd0;
  assign fetched_o = has_i && (!second_i || weight != 8'd0);
  assign level     = chosen + 4'(second_i && weight != 8'd0);

  logic [12:0] width, height;
  assign width  = texture_i.width >> level;
  assign height = texture_i.height >> level;
  assign level_o = {level, width == 13'd0 ? 13'd1 : width, height == 13'd0 ? 13'd1 : height,
                    texture_i.base[level]};
endmodule
