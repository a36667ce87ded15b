// Written by scripts/contract from contract/registers.toml and its neighbours.
// Case items over the offset in an instance of the block `draw`: what a register of draw d writes
// into effects_q from reg_wdata_i.
6'd12: begin  // draw_passes
  if (ExtraPasses > 0) effects_q[d*ptm_register_pkg::EffectW+467 +: 3] <= reg_wdata_i[2:0];
  if (ExtraPasses > 0) effects_q[d*ptm_register_pkg::EffectW+451 +: 3] <= reg_wdata_i[6:4];
  if (ExtraPasses > 1) effects_q[d*ptm_register_pkg::EffectW+455 +: 3] <= reg_wdata_i[10:8];
  if (ExtraPasses > 2) effects_q[d*ptm_register_pkg::EffectW+459 +: 3] <= reg_wdata_i[14:12];
  if (ExtraPasses > 3) effects_q[d*ptm_register_pkg::EffectW+463 +: 3] <= reg_wdata_i[18:16];
  if (ExtraPasses > 0) effects_q[d*ptm_register_pkg::EffectW+454 +: 1] <= reg_wdata_i[7];
  if (ExtraPasses > 1) effects_q[d*ptm_register_pkg::EffectW+458 +: 1] <= reg_wdata_i[11];
  if (ExtraPasses > 2) effects_q[d*ptm_register_pkg::EffectW+462 +: 1] <= reg_wdata_i[15];
  if (ExtraPasses > 3) effects_q[d*ptm_register_pkg::EffectW+466 +: 1] <= reg_wdata_i[19];
end
6'd13: begin  // draw_effects
  if (ExtraSets > 0) effects_q[d*ptm_register_pkg::EffectW+448 +: 3] <= reg_wdata_i[2:0];
  if (Stages > 0) effects_q[d*ptm_register_pkg::EffectW+440 +: 8] <= reg_wdata_i[15:8];
end
6'd14: begin  // draw_argument
  if (Stages > 0) effects_q[d*ptm_register_pkg::EffectW+408 +: 32] <= reg_wdata_i[31:0];
end
