// What goes into ptm_evaluator leaves it as ptm_evaluator_steps makes it, beat after beat, an RGB
// map's three passes as one pixel; eight cycles later, or when the taker is ready.
//
// Cycle 0 is reset; from then on a beat is offered in every cycle, its operands free. The taker is
// ready but in the cycles StallFrom to StallTo. In cycle Due the pixel whose last beat came Age
// cycles before must be there. Registers hold anything when reset begins. What holds for every
// pattern of stalls is in docs/verification/proofs.md.
module ptm_evaluator_flow #(
  parameter int RgbMap       = 0,   // 1: three passes a pixel
  parameter int Due          = 11,  // up to 31
  parameter int Age          = 8,   // 8 if nothing stalls
  parameter int StallFrom    = 31,
  parameter int StallTo      = 0,   // below StallFrom: never
  `include "contract/ptm_evaluator_parameters.svh"
  ,
  localparam int SidebandBits = 4,
  localparam int StoredW = ptm_pkg::stored_bits(CoefBits, FilterFrac),
  localparam int LightW  = ptm_pkg::light_bits(LightInt, LightFrac),
  localparam int RgbW    = ptm_pkg::rgb_bits(FilterFrac),
  localparam int LumW    = ptm_pkg::lum_bits(LumBits, LumFrac)
) (
  input  logic                            clk_i,
  input  logic [6*StoredW-1:0]            coef_i,
  input  logic [6*CoefBits-1:0]           bias_i,
  input  logic [6*ptm_pkg::ShiftBits-1:0] shift_i,
  input  logic [3*RgbW-1:0]               rgb_i,
  input  logic signed [LightW-1:0]        lu_i,
  input  logic signed [LightW-1:0]        lv_i,
  input  logic [SidebandBits-1:0]         sideband_i,
  output logic                            differ_o  // in cycle Due
);
  logic [4:0] cycle_q = 5'd0;
  always_ff @(posedge clk_i) cycle_q <= cycle_q + 5'd1;

  // Cycle 1, 2, 3: channel 0, 1, 2
  logic       running;
  logic [1:0] channel;
  logic       taken;
  assign running = cycle_q != 5'd0;
  assign taken   = cycle_q < 5'(StallFrom) || cycle_q > 5'(StallTo);
  assign channel = RgbMap == 0 ? 2'd0 : 2'((cycle_q + 5'd2) % 5'd3);

  logic                    ready, valid, lum_saturated, color_saturated;
  logic [3*LumW-1:0]       lum;
  logic [23:0]             rgb;
  logic [SidebandBits-1:0] sideband;
  ptm_evaluator #(
    `include "contract/ptm_evaluator_map.svh"
    ,
    .SidebandBits(SidebandBits)
  ) u_evaluator (
    .clk_i(clk_i), .rst_ni(running), .valid_i(running), .ready_o(ready), .coef_i(coef_i),
    .bias_i(bias_i), .shift_i(shift_i), .rgb_i(rgb_i), .lu_i(lu_i), .lv_i(lv_i),
    .rgb_map_i(RgbMap != 0), .channel_i(channel), .sideband_i(sideband_i), .valid_o(valid),
    .ready_i(taken), .lum_o(lum), .lum_saturated_o(lum_saturated), .rgb_o(rgb),
    .color_saturated_o(color_saturated), .sideband_o(sideband)
  );

  typedef struct packed {
    logic [LumW-1:0]         lum;
    logic                    lum_saturated;
    logic [23:0]             rgb;
    logic                    color_saturated;
    logic [SidebandBits-1:0] sideband;
  } beat_t;
  beat_t beat;
  ptm_evaluator_steps #(
    `include "contract/ptm_evaluator_map.svh"
  ) u_steps (
    .coef_i(coef_i), .bias_i(bias_i), .shift_i(shift_i), .rgb_i(rgb_i), .lu_i(lu_i), .lv_i(lv_i),
    .rgb_map_i(RgbMap != 0), .lum_o(beat.lum), .lum_saturated_o(beat.lum_saturated),
    .rgb_o(beat.rgb), .color_saturated_o(beat.color_saturated)
  );
  assign beat.sideband = sideband_i;

  // The beats of the cycles before
  logic [(Age+2)*$bits(beat)-1:0] beats_q;
  always_ff @(posedge clk_i) beats_q <= {beats_q[(Age+1)*$bits(beat)-1:0], beat};
  beat_t last, middle, first;
  assign last   = beats_q[(Age-1)*$bits(beat) +: $bits(beat)];
  assign middle = beats_q[Age*$bits(beat) +: $bits(beat)];
  assign first  = beats_q[(Age+1)*$bits(beat) +: $bits(beat)];

  logic [3*LumW-1:0] due_lum;
  logic [23:0]       due_rgb;
  logic              due_lum_saturated, due_color_saturated;
  if (RgbMap != 0) begin : gen_rgb
    assign due_lum = {last.lum, middle.lum, first.lum};
    assign due_rgb = {last.rgb[23:16], middle.rgb[15:8], first.rgb[7:0]};
    assign due_lum_saturated =
        last.lum_saturated || middle.lum_saturated || first.lum_saturated;
    assign due_color_saturated =
        last.color_saturated || middle.color_saturated || first.color_saturated;
  end else begin : gen_lrgb
    assign due_lum             = {3{last.lum}};
    assign due_rgb             = last.rgb;
    assign due_lum_saturated   = last.lum_saturated;
    assign due_color_saturated = last.color_saturated;
  end

  assign differ_o = cycle_q == 5'(Due)
      && ((!ready && StallFrom > StallTo) || !valid || lum != due_lum || rgb != due_rgb
          || lum_saturated != due_lum_saturated || color_saturated != due_color_saturated
          || sideband != last.sideband);
endmodule
