// What a palettised beat does in D: which taps are looked up in which cycle, through which ports.
//
// TMU 0's word of a footprint's first beat is the index of a palettised map; other beats stay one
// cycle.                                                         docs/spec/unit-timing.md, D
module ptm_palette_control #(
  parameter int LrgbPorts = 4,
  parameter int RgbPorts  = 1
) (
  input  logic                    clk_i,
  input  logic                    rst_ni,
  // The beat in D, of TMU 0
  input  logic                    valid_i,
  input  logic                    leave_i,      // it leaves in this cycle
  input  logic [2:0]              format_i,
  input  logic [1:0]              palette_i,
  input  logic [ptm_unit_pkg::GroupBits-1:0] group_i,
  input  logic [3:0]              fetched_i,
  input  logic [127:0]            words_i,      // a tap, 00 lowest
  output logic                    last_o,       // nothing is left to look up after this cycle
  output logic [2:0]              taps_o,       // all that it looks up
  output logic                    lrgb_o,       // its words are indices into that palette
  output logic                    rgb_o,
  // In this cycle: taps, 2 bits a tap for its port, an index a port
  output logic [3:0]              lrgb_now_o,
  output logic [7:0]              lrgb_port_o,
  output logic [LrgbPorts*10-1:0] lrgb_read_o,
  output logic [3:0]              rgb_now_o,
  output logic [7:0]              rgb_port_o,
  output logic [RgbPorts*12-1:0]  rgb_read_o
);
  assign lrgb_o = format_i == ptm_unit_pkg::FormatPaletteLrgb && group_i == '0;
  assign rgb_o  = format_i == ptm_unit_pkg::FormatPaletteRgb && group_i == '0;

  logic [4*10-1:0] lrgb_index;
  logic [4*12-1:0] rgb_index;
  // Of other words' bits nothing is simulated
  always_comb begin
    lrgb_index = '0;
    rgb_index  = '0;
    if (lrgb_o) begin
      lrgb_index = {palette_i, words_i[96 +: 8], palette_i, words_i[64 +: 8],
                    palette_i, words_i[32 +: 8], palette_i, words_i[0 +: 8]};
    end
    if (rgb_o) begin
      rgb_index = {words_i[96 +: 12], words_i[64 +: 12], words_i[32 +: 12], words_i[0 +: 12]};
    end
  end

  logic [1:0] cycle_q;  // of the beat in D
  logic       lrgb_last, rgb_last;
  ptm_palette_schedule #(.Ports(LrgbPorts), .IndexBits(10)) u_lrgb (
    .fetched_i(fetched_i & {4{lrgb_o}}), .step_i(cycle_q), .index_i(lrgb_index),
    .last_o(lrgb_last), .now_o(lrgb_now_o), .port_o(lrgb_port_o), .index_o(lrgb_read_o)
  );
  ptm_palette_schedule #(.Ports(RgbPorts), .IndexBits(12)) u_rgb (
    .fetched_i(fetched_i & {4{rgb_o}}), .step_i(cycle_q), .index_i(rgb_index),
    .last_o(rgb_last), .now_o(rgb_now_o), .port_o(rgb_port_o), .index_o(rgb_read_o)
  );
  assign last_o = lrgb_last && rgb_last;
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) cycle_q <= 2'd0;
    else if (valid_i && leave_i) cycle_q <= 2'd0;
    else if (valid_i && !last_o) cycle_q <= cycle_q + 2'd1;
  end

  assign taps_o = lrgb_o || rgb_o ? 3'(fetched_i[0]) + 3'(fetched_i[1]) + 3'(fetched_i[2]) +
                                    3'(fetched_i[3])
                                  : 3'd0;
endmodule
