// Written by scripts/contract from contract/registers.toml and its neighbours.
// Case items over the offset in an instance of the block `draw`: what a register of draw d shows of
// draws_i in data_o.
6'd0: begin  // draw_control
  data_o[2:0] = draws_i[d*ptm_register_pkg::DrawW+891 +: 3];
  data_o[4:3] = draws_i[d*ptm_register_pkg::DrawW+888 +: 2];
  data_o[5] = draws_i[d*ptm_register_pkg::DrawW+890 +: 1];
  data_o[7:6] = draws_i[d*ptm_register_pkg::DrawW+886 +: 2];
  data_o[9:8] = draws_i[d*ptm_register_pkg::DrawW+884 +: 2];
  data_o[12:10] = draws_i[d*ptm_register_pkg::DrawW+881 +: 3];
  data_o[13] = draws_i[d*ptm_register_pkg::DrawW+880 +: 1];
  data_o[15:14] = draws_i[d*ptm_register_pkg::DrawW+27 +: 2];
end
6'd1: begin  // draw_map_size
  data_o[12:0] = draws_i[d*ptm_register_pkg::DrawW+854 +: 13];
  data_o[28:16] = draws_i[d*ptm_register_pkg::DrawW+841 +: 13];
end
6'd2: begin  // draw_color_size
  data_o[12:0] = draws_i[d*ptm_register_pkg::DrawW+486 +: 13];
  data_o[28:16] = draws_i[d*ptm_register_pkg::DrawW+473 +: 13];
end
6'd3: begin  // draw_levels
  data_o[3:0] = draws_i[d*ptm_register_pkg::DrawW+837 +: 4];
  data_o[11:8] = draws_i[d*ptm_register_pkg::DrawW+469 +: 4];
  data_o[28:16] = draws_i[d*ptm_register_pkg::DrawW+867 +: 13];
end
6'd4: begin  // draw_coefficient
  data_o[11:0] = draws_i[d*ptm_register_pkg::DrawW+59 +: 12];
  data_o[20:16] = draws_i[d*ptm_register_pkg::DrawW+29 +: 5];
end
6'd5: begin  // draw_coefficient
  data_o[11:0] = draws_i[d*ptm_register_pkg::DrawW+71 +: 12];
  data_o[20:16] = draws_i[d*ptm_register_pkg::DrawW+34 +: 5];
end
6'd6: begin  // draw_coefficient
  data_o[11:0] = draws_i[d*ptm_register_pkg::DrawW+83 +: 12];
  data_o[20:16] = draws_i[d*ptm_register_pkg::DrawW+39 +: 5];
end
6'd7: begin  // draw_coefficient
  data_o[11:0] = draws_i[d*ptm_register_pkg::DrawW+95 +: 12];
  data_o[20:16] = draws_i[d*ptm_register_pkg::DrawW+44 +: 5];
end
6'd8: begin  // draw_coefficient
  data_o[11:0] = draws_i[d*ptm_register_pkg::DrawW+107 +: 12];
  data_o[20:16] = draws_i[d*ptm_register_pkg::DrawW+49 +: 5];
end
6'd9: begin  // draw_coefficient
  data_o[11:0] = draws_i[d*ptm_register_pkg::DrawW+119 +: 12];
  data_o[20:16] = draws_i[d*ptm_register_pkg::DrawW+54 +: 5];
end
6'd10: begin  // draw_weights
  data_o[8:0] = draws_i[d*ptm_register_pkg::DrawW+18 +: 9];
  data_o[17:9] = draws_i[d*ptm_register_pkg::DrawW+9 +: 9];
  data_o[26:18] = draws_i[d*ptm_register_pkg::DrawW+0 +: 9];
end
6'd16: begin  // draw_map_base
  data_o[25:0] = draws_i[d*ptm_register_pkg::DrawW+499 +: 26];
end
6'd17: begin  // draw_map_base
  data_o[25:0] = draws_i[d*ptm_register_pkg::DrawW+525 +: 26];
end
6'd18: begin  // draw_map_base
  data_o[25:0] = draws_i[d*ptm_register_pkg::DrawW+551 +: 26];
end
6'd19: begin  // draw_map_base
  data_o[25:0] = draws_i[d*ptm_register_pkg::DrawW+577 +: 26];
end
6'd20: begin  // draw_map_base
  data_o[25:0] = draws_i[d*ptm_register_pkg::DrawW+603 +: 26];
end
6'd21: begin  // draw_map_base
  data_o[25:0] = draws_i[d*ptm_register_pkg::DrawW+629 +: 26];
end
6'd22: begin  // draw_map_base
  data_o[25:0] = draws_i[d*ptm_register_pkg::DrawW+655 +: 26];
end
6'd23: begin  // draw_map_base
  data_o[25:0] = draws_i[d*ptm_register_pkg::DrawW+681 +: 26];
end
6'd24: begin  // draw_map_base
  data_o[25:0] = draws_i[d*ptm_register_pkg::DrawW+707 +: 26];
end
6'd25: begin  // draw_map_base
  data_o[25:0] = draws_i[d*ptm_register_pkg::DrawW+733 +: 26];
end
6'd26: begin  // draw_map_base
  data_o[25:0] = draws_i[d*ptm_register_pkg::DrawW+759 +: 26];
end
6'd27: begin  // draw_map_base
  data_o[25:0] = draws_i[d*ptm_register_pkg::DrawW+785 +: 26];
end
6'd28: begin  // draw_map_base
  data_o[25:0] = draws_i[d*ptm_register_pkg::DrawW+811 +: 26];
end
6'd32: begin  // draw_color_base
  data_o[25:0] = draws_i[d*ptm_register_pkg::DrawW+131 +: 26];
end
6'd33: begin  // draw_color_base
  data_o[25:0] = draws_i[d*ptm_register_pkg::DrawW+157 +: 26];
end
6'd34: begin  // draw_color_base
  data_o[25:0] = draws_i[d*ptm_register_pkg::DrawW+183 +: 26];
end
6'd35: begin  // draw_color_base
  data_o[25:0] = draws_i[d*ptm_register_pkg::DrawW+209 +: 26];
end
6'd36: begin  // draw_color_base
  data_o[25:0] = draws_i[d*ptm_register_pkg::DrawW+235 +: 26];
end
6'd37: begin  // draw_color_base
  data_o[25:0] = draws_i[d*ptm_register_pkg::DrawW+261 +: 26];
end
6'd38: begin  // draw_color_base
  data_o[25:0] = draws_i[d*ptm_register_pkg::DrawW+287 +: 26];
end
6'd39: begin  // draw_color_base
  data_o[25:0] = draws_i[d*ptm_register_pkg::DrawW+313 +: 26];
end
6'd40: begin  // draw_color_base
  data_o[25:0] = draws_i[d*ptm_register_pkg::DrawW+339 +: 26];
end
6'd41: begin  // draw_color_base
  data_o[25:0] = draws_i[d*ptm_register_pkg::DrawW+365 +: 26];
end
6'd42: begin  // draw_color_base
  data_o[25:0] = draws_i[d*ptm_register_pkg::DrawW+391 +: 26];
end
6'd43: begin  // draw_color_base
  data_o[25:0] = draws_i[d*ptm_register_pkg::DrawW+417 +: 26];
end
6'd44: begin  // draw_color_base
  data_o[25:0] = draws_i[d*ptm_register_pkg::DrawW+443 +: 26];
end
