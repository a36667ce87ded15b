// The registers of one draw; offsets in docs/spec/unit.md, Registers.
//
// Reset leaves a draw of format none and size 0, and nobody has checked it: not written, it is not
// an error. The offsets that hold nothing are not written.
module ptm_draw_registers (
  input  logic        clk_i,
  input  logic        rst_ni,
  input  logic        we_i,
  input  logic [5:0]  addr_i,
  input  logic [31:0] data_i,
  output logic        we_control_o,  // control is being written
  output logic [ptm_unit_pkg::DrawW-1:0] draw_o  // a draw_t
);
  localparam int LineBits  = ptm_unit_pkg::LineBits;
  localparam int SideBits  = ptm_unit_pkg::SideBits;
  localparam int LevelsMax = ptm_unit_pkg::LevelsMax;

  logic [15:0]                   control_q;
  logic [2*SideBits-1:0]         map_size_q, color_size_q;  // height, width
  logic [3:0]                    map_levels_q, color_levels_q;
  logic [12:0]                   color_lod_q;
  logic [6*12-1:0]               bias_q;
  logic [6*5-1:0]                shift_q;
  logic [26:0]                   weights_q;  // ks, kd, ka
  logic [LevelsMax*LineBits-1:0] map_base_q, color_base_q;

  assign we_control_o = we_i && addr_i == 6'd0;
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      control_q      <= '0;
      map_size_q     <= '0;
      color_size_q   <= '0;
      map_levels_q   <= '0;
      color_levels_q <= '0;
      color_lod_q    <= '0;
      weights_q      <= '0;
    end else if (we_i) begin
      case (addr_i)
        6'd0: control_q <= data_i[15:0];
        6'd1: map_size_q <= {data_i[16 +: SideBits], data_i[0 +: SideBits]};
        6'd2: color_size_q <= {data_i[16 +: SideBits], data_i[0 +: SideBits]};
        6'd3: begin
          map_levels_q   <= data_i[3:0];
          color_levels_q <= data_i[11:8];
          color_lod_q    <= data_i[28:16];
        end
        6'd10: weights_q <= data_i[26:0];
        default: ;
      endcase
    end
  end
  always_ff @(posedge clk_i) begin
    if (we_i) begin
      for (int i = 0; i < 6; i++) begin
        if (addr_i == 6'(4 + i)) begin
          bias_q[12*i +: 12] <= data_i[11:0];
          shift_q[5*i +: 5]  <= data_i[20:16];
        end
      end
      for (int l = 0; l < LevelsMax; l++) begin
        if (addr_i == 6'(16 + l)) map_base_q[l*LineBits +: LineBits] <= data_i[LineBits-1:0];
        if (addr_i == 6'(32 + l)) color_base_q[l*LineBits +: LineBits] <= data_i[LineBits-1:0];
      end
    end
  end

  // In the order of draw_t
  assign draw_o = {
    control_q[2:0], control_q[5], control_q[4:3], control_q[7:6], control_q[9:8],
    control_q[12:10], control_q[13], color_lod_q,
    map_size_q[0 +: SideBits], map_size_q[SideBits +: SideBits], map_levels_q, map_base_q,
    color_size_q[0 +: SideBits], color_size_q[SideBits +: SideBits], color_levels_q, color_base_q,
    bias_q, shift_q, control_q[15:14], weights_q[8:0], weights_q[17:9], weights_q[26:18]
  };
endmodule
