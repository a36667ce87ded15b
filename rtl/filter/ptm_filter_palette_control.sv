// What a palettised beat does in D and Q: which taps are looked up in which cycle, through which
// ports, and which the palettes show in Q's.                docs/spec/unit-timing.md, Palette
//
// TMU 0's word of a footprint's first beat is the index of a palettised map; other beats have one
// look-up cycle, in which nothing is looked up.
module ptm_filter_palette_control #(
  parameter int LrgbPorts = 4,
  parameter int RgbPorts  = 1
) (
  input  logic                    clk_i,
  input  logic                    rst_ni,
  // The beat in D, of TMU 0
  input  logic                    valid_i,
  input  logic                    accept_i,     // Q accepts: the cycle is a look-up cycle
  input  logic                    sub_last_i,   // the beat is whole with it
  input  logic [2:0]              format_i,
  input  logic [1:0]              palette_i,
  input  logic [ptm_unit_pkg::GroupBits-1:0] group_i,
  input  logic [3:0]              fetched_i,
  input  logic [127:0]            words_i,      // a tap, 00 lowest
  output logic                    last_o,       // nothing is left to look up after a look-up cycle
  output logic [2:0]              taps_o,       // all that it looks up
  // What the palettes are asked for, a port
  output logic [LrgbPorts-1:0]    lrgb_read_o,
  output logic [LrgbPorts*10-1:0] lrgb_index_o,
  output logic [RgbPorts-1:0]     rgb_read_o,
  output logic [RgbPorts*12-1:0]  rgb_index_o,
  // What they show: the answers to the latest look-up cycle of a palettised beat
  output logic                    shown_rgb_o,  // of the RGB palette, not of the LRGB one
  output logic [3:0]              shown_o,      // taps
  output logic [7:0]              lrgb_port_o,  // 2 bits a tap: by which port
  output logic [7:0]              rgb_port_o,
  output logic                    hold_o        // they are to be kept now: the beat was not whole
);
  // The words are indices into that palette.
  logic lrgb, rgb;
  assign lrgb = ptm_format_pkg::indexes_lrgb(format_i) && group_i == '0;
  assign rgb  = ptm_format_pkg::indexes_rgb(format_i) && group_i == '0;

  logic [4*10-1:0] lrgb_index;
  logic [4*12-1:0] rgb_index;
  // Of other words' bits nothing is simulated
  always_comb begin
    lrgb_index = '0;
    rgb_index  = '0;
    if (lrgb) begin
      lrgb_index = {palette_i, words_i[96 +: 8], palette_i, words_i[64 +: 8],
                    palette_i, words_i[32 +: 8], palette_i, words_i[0 +: 8]};
    end
    if (rgb) begin
      rgb_index = {words_i[96 +: 12], words_i[64 +: 12], words_i[32 +: 12], words_i[0 +: 12]};
    end
  end

  logic [1:0]           cycle_q;  // look-up cycles that the beat in D has had
  logic                 step;     // this is one
  logic                 lrgb_last, rgb_last;
  logic [3:0]           lrgb_now, rgb_now;
  logic [7:0]           lrgb_port, rgb_port;
  logic [LrgbPorts-1:0] lrgb_read;
  logic [RgbPorts-1:0]  rgb_read;
  ptm_filter_palette_schedule #(.Ports(LrgbPorts), .IndexBits(10)) u_lrgb (
    .fetched_i(fetched_i & {4{lrgb}}), .step_i(cycle_q), .index_i(lrgb_index),
    .last_o(lrgb_last), .now_o(lrgb_now), .port_o(lrgb_port), .read_o(lrgb_read),
    .index_o(lrgb_index_o)
  );
  ptm_filter_palette_schedule #(.Ports(RgbPorts), .IndexBits(12)) u_rgb (
    .fetched_i(fetched_i & {4{rgb}}), .step_i(cycle_q), .index_i(rgb_index),
    .last_o(rgb_last), .now_o(rgb_now), .port_o(rgb_port), .read_o(rgb_read),
    .index_o(rgb_index_o)
  );
  assign step        = valid_i && accept_i;
  assign last_o      = lrgb_last && rgb_last;
  assign lrgb_read_o = step ? lrgb_read : '0;
  assign rgb_read_o  = step ? rgb_read : '0;

  // Behind a look-up cycle that does not make the beat whole comes another one before the beat's
  // answers are taken, so they are kept in the cycle in which they are shown.
  logic       shown_rgb_q, hold_q;
  logic [3:0] shown_q;
  logic [7:0] lrgb_port_q, rgb_port_q;
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      cycle_q <= 2'd0;
      hold_q  <= 1'b0;
    end else begin
      if (step) cycle_q <= last_o ? 2'd0 : cycle_q + 2'd1;
      hold_q <= step && (lrgb || rgb) && !(last_o && sub_last_i);
    end
  end
  always_ff @(posedge clk_i) begin
    if (step && (lrgb || rgb)) begin
      shown_rgb_q <= rgb;
      shown_q     <= lrgb_now | rgb_now;
      lrgb_port_q <= lrgb_port;
      rgb_port_q  <= rgb_port;
    end
  end
  assign shown_rgb_o = shown_rgb_q;
  assign shown_o     = shown_q;
  assign lrgb_port_o = lrgb_port_q;
  assign rgb_port_o  = rgb_port_q;
  assign hold_o      = hold_q;

  assign taps_o = lrgb || rgb ? 3'(fetched_i[0]) + 3'(fetched_i[1]) + 3'(fetched_i[2]) +
                                3'(fetched_i[3])
                              : 3'd0;
endmodule
