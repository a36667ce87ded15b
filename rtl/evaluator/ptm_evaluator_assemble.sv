// Makes one pixel of an RGB map's three passes; an LRGB pixel goes through unchanged.
//
// A pass that is not the last moves into the assembly register in the cycle in which it is offered,
// whatever ready_i says; the last pass (channel 2) offers the whole pixel. The passes of a pixel
// are successive beats: channel 0, 1, 2, nothing in between. Entry c of lum_o is the luminance that
// channel c was made from, so for LRGB all three are the same one. valid_o and ready_o are
// combinational; latency 0.
`include "ptm_assert.svh"
module ptm_evaluator_assemble #(
  parameter int LumW = 10
) (
  input  logic              clk_i,
  input  logic              rst_ni,
  // One pass, or an LRGB pixel
  input  logic              valid_i,
  output logic              ready_o,
  input  logic              rgb_map_i,
  input  logic [1:0]        channel_i,          // RGB map: 0, 1, 2
  input  logic [LumW-1:0]   lum_i,
  input  logic              lum_saturated_i,
  input  logic [23:0]       rgb_i,              // RGB map: the channel's value in all three places
  input  logic              color_saturated_i,
  // The pixel
  output logic              valid_o,
  input  logic              ready_i,
  output logic [3*LumW-1:0] lum_o,
  output logic              lum_saturated_o,    // RGB map: any pass's
  output logic [23:0]       rgb_o,
  output logic              color_saturated_o   // any channel's
);
  logic last;
  assign last    = !rgb_map_i || channel_i == 2'd2;
  assign ready_o = !last || ready_i;
  assign valid_o = valid_i && last;

  logic [LumW-1:0] lum0_q, lum1_q;
  logic [7:0] red_q, green_q;
  logic lum_saturated_q, color_saturated_q;  // of the passes so far

  always_ff @(posedge clk_i) begin
    if (valid_i && !last) begin
      if (channel_i == 2'd0) begin
        lum0_q            <= lum_i;
        red_q             <= rgb_i[7:0];
        lum_saturated_q   <= lum_saturated_i;
        color_saturated_q <= color_saturated_i;
      end else begin
        lum1_q            <= lum_i;
        green_q           <= rgb_i[15:8];
        lum_saturated_q   <= lum_saturated_q || lum_saturated_i;
        color_saturated_q <= color_saturated_q || color_saturated_i;
      end
    end
  end

  assign lum_o             = rgb_map_i ? {lum_i, lum1_q, lum0_q} : {3{lum_i}};
  assign rgb_o             = rgb_map_i ? {rgb_i[23:16], green_q, red_q} : rgb_i;
  assign lum_saturated_o   = lum_saturated_i || (rgb_map_i && lum_saturated_q);
  assign color_saturated_o = color_saturated_i || (rgb_map_i && color_saturated_q);

  // Passes come in order; next_channel_q is what a pass must carry.
  logic [1:0] next_channel_q;
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) next_channel_q <= 2'd0;
    else if (valid_i && ready_o) next_channel_q <= last ? 2'd0 : channel_i + 2'd1;
  end
  `PTM_ASSERT(PassesInOrder_A, !valid_i || (rgb_map_i ? channel_i : 2'd0) == next_channel_q)
endmodule
