// Written by scripts/contract from contract/registers.toml and its neighbours.
// Case items over the offset in an instance of the block `draw`: what a register of draw d shows of
// effects_i in data_o.
6'd12: begin  // draw_passes
  data_o[2:0] = effects_i[d*ptm_register_pkg::EffectW+467 +: 3];
  data_o[6:4] = effects_i[d*ptm_register_pkg::EffectW+451 +: 3];
  data_o[10:8] = effects_i[d*ptm_register_pkg::EffectW+455 +: 3];
  data_o[14:12] = effects_i[d*ptm_register_pkg::EffectW+459 +: 3];
  data_o[18:16] = effects_i[d*ptm_register_pkg::EffectW+463 +: 3];
  data_o[7] = effects_i[d*ptm_register_pkg::EffectW+454 +: 1];
  data_o[11] = effects_i[d*ptm_register_pkg::EffectW+458 +: 1];
  data_o[15] = effects_i[d*ptm_register_pkg::EffectW+462 +: 1];
  data_o[19] = effects_i[d*ptm_register_pkg::EffectW+466 +: 1];
end
6'd13: begin  // draw_effects
  data_o[2:0] = effects_i[d*ptm_register_pkg::EffectW+448 +: 3];
  data_o[15:8] = effects_i[d*ptm_register_pkg::EffectW+440 +: 8];
end
6'd14: begin  // draw_argument
  data_o[31:0] = effects_i[d*ptm_register_pkg::EffectW+408 +: 32];
end
