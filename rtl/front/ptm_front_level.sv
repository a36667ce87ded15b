// U2, one texture: the level of detail's level and the weight of the next one.
//
//   mip none     l = 0, f = 0                                      docs/spec/unit.md, U2
//   mip nearest  l = min((lod + 128) >> 8, levels - 1), f = 0
//   mip linear   c = min(lod, (levels - 1) << 8), l = c >> 8, f = c & 255
//
// Twin: ptm::reference::choose_level() in model/reference/unit/beats.h. Combinational.
module ptm_front_level (
  input  logic [1:0]                        mip_i,
  input  logic [ptm_unit_pkg::LodBits-1:0]  lod_i,     // Q4.8
  input  logic [3:0]                        levels_i,  // 1..13
  output logic [3:0]                        level_o,
  output logic [7:0]                        weight_o   // f
);
  logic [3:0]                         last;
  logic [ptm_unit_pkg::LodBits:0]     rounded;  // lod + 128
  logic [4:0]                         nearest;
  logic                               linear_limited;
  assign last           = levels_i - 4'd1;
  assign rounded        = 13'(lod_i) + 13'd128;
  assign nearest        = rounded[12:8];
  assign linear_limited = lod_i[11:8] >= last;

  always_comb begin
    level_o  = 4'd0;
    weight_o = 8'd0;
    if (mip_i == ptm_unit_pkg::MipNearest) begin
      level_o = nearest < 5'(last) ? nearest[3:0] : last;
    end else if (mip_i == ptm_unit_pkg::MipLinear) begin
      level_o  = linear_limited ? last : lod_i[11:8];
      weight_o = linear_limited ? 8'd0 : lod_i[7:0];
    end
  end

  logic unused_fraction;
  assign unused_fraction = |rounded[7:0];
endmodule
