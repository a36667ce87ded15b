// Written by scripts/contract from contract/registers.toml and its neighbours.
// Case items over the offset in an instance of the block `set`: what a register of draw d shows of
// effects_i in data_o.
5'd0: begin  // set_coefficient
  data_o[11:0] = effects_i[d*ptm_register_pkg::EffectW+120 +: 12];
  data_o[20:16] = effects_i[d*ptm_register_pkg::EffectW+0 +: 5];
end
5'd1: begin  // set_coefficient
  data_o[11:0] = effects_i[d*ptm_register_pkg::EffectW+132 +: 12];
  data_o[20:16] = effects_i[d*ptm_register_pkg::EffectW+5 +: 5];
end
5'd2: begin  // set_coefficient
  data_o[11:0] = effects_i[d*ptm_register_pkg::EffectW+144 +: 12];
  data_o[20:16] = effects_i[d*ptm_register_pkg::EffectW+10 +: 5];
end
5'd3: begin  // set_coefficient
  data_o[11:0] = effects_i[d*ptm_register_pkg::EffectW+156 +: 12];
  data_o[20:16] = effects_i[d*ptm_register_pkg::EffectW+15 +: 5];
end
5'd4: begin  // set_coefficient
  data_o[11:0] = effects_i[d*ptm_register_pkg::EffectW+168 +: 12];
  data_o[20:16] = effects_i[d*ptm_register_pkg::EffectW+20 +: 5];
end
5'd5: begin  // set_coefficient
  data_o[11:0] = effects_i[d*ptm_register_pkg::EffectW+180 +: 12];
  data_o[20:16] = effects_i[d*ptm_register_pkg::EffectW+25 +: 5];
end
5'd8: begin  // set_coefficient
  data_o[11:0] = effects_i[d*ptm_register_pkg::EffectW+192 +: 12];
  data_o[20:16] = effects_i[d*ptm_register_pkg::EffectW+30 +: 5];
end
5'd9: begin  // set_coefficient
  data_o[11:0] = effects_i[d*ptm_register_pkg::EffectW+204 +: 12];
  data_o[20:16] = effects_i[d*ptm_register_pkg::EffectW+35 +: 5];
end
5'd10: begin  // set_coefficient
  data_o[11:0] = effects_i[d*ptm_register_pkg::EffectW+216 +: 12];
  data_o[20:16] = effects_i[d*ptm_register_pkg::EffectW+40 +: 5];
end
5'd11: begin  // set_coefficient
  data_o[11:0] = effects_i[d*ptm_register_pkg::EffectW+228 +: 12];
  data_o[20:16] = effects_i[d*ptm_register_pkg::EffectW+45 +: 5];
end
5'd12: begin  // set_coefficient
  data_o[11:0] = effects_i[d*ptm_register_pkg::EffectW+240 +: 12];
  data_o[20:16] = effects_i[d*ptm_register_pkg::EffectW+50 +: 5];
end
5'd13: begin  // set_coefficient
  data_o[11:0] = effects_i[d*ptm_register_pkg::EffectW+252 +: 12];
  data_o[20:16] = effects_i[d*ptm_register_pkg::EffectW+55 +: 5];
end
5'd16: begin  // set_coefficient
  data_o[11:0] = effects_i[d*ptm_register_pkg::EffectW+264 +: 12];
  data_o[20:16] = effects_i[d*ptm_register_pkg::EffectW+60 +: 5];
end
5'd17: begin  // set_coefficient
  data_o[11:0] = effects_i[d*ptm_register_pkg::EffectW+276 +: 12];
  data_o[20:16] = effects_i[d*ptm_register_pkg::EffectW+65 +: 5];
end
5'd18: begin  // set_coefficient
  data_o[11:0] = effects_i[d*ptm_register_pkg::EffectW+288 +: 12];
  data_o[20:16] = effects_i[d*ptm_register_pkg::EffectW+70 +: 5];
end
5'd19: begin  // set_coefficient
  data_o[11:0] = effects_i[d*ptm_register_pkg::EffectW+300 +: 12];
  data_o[20:16] = effects_i[d*ptm_register_pkg::EffectW+75 +: 5];
end
5'd20: begin  // set_coefficient
  data_o[11:0] = effects_i[d*ptm_register_pkg::EffectW+312 +: 12];
  data_o[20:16] = effects_i[d*ptm_register_pkg::EffectW+80 +: 5];
end
5'd21: begin  // set_coefficient
  data_o[11:0] = effects_i[d*ptm_register_pkg::EffectW+324 +: 12];
  data_o[20:16] = effects_i[d*ptm_register_pkg::EffectW+85 +: 5];
end
5'd24: begin  // set_coefficient
  data_o[11:0] = effects_i[d*ptm_register_pkg::EffectW+336 +: 12];
  data_o[20:16] = effects_i[d*ptm_register_pkg::EffectW+90 +: 5];
end
5'd25: begin  // set_coefficient
  data_o[11:0] = effects_i[d*ptm_register_pkg::EffectW+348 +: 12];
  data_o[20:16] = effects_i[d*ptm_register_pkg::EffectW+95 +: 5];
end
5'd26: begin  // set_coefficient
  data_o[11:0] = effects_i[d*ptm_register_pkg::EffectW+360 +: 12];
  data_o[20:16] = effects_i[d*ptm_register_pkg::EffectW+100 +: 5];
end
5'd27: begin  // set_coefficient
  data_o[11:0] = effects_i[d*ptm_register_pkg::EffectW+372 +: 12];
  data_o[20:16] = effects_i[d*ptm_register_pkg::EffectW+105 +: 5];
end
5'd28: begin  // set_coefficient
  data_o[11:0] = effects_i[d*ptm_register_pkg::EffectW+384 +: 12];
  data_o[20:16] = effects_i[d*ptm_register_pkg::EffectW+110 +: 5];
end
5'd29: begin  // set_coefficient
  data_o[11:0] = effects_i[d*ptm_register_pkg::EffectW+396 +: 12];
  data_o[20:16] = effects_i[d*ptm_register_pkg::EffectW+115 +: 5];
end
