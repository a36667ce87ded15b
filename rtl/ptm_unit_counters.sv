// The unit's counters: docs/spec/unit-timing.md, Counters, numbers 0 to 36.
//
// Cycles count from the first fragment accepted; those in which nothing is inside are added, as
// `input_empty`, when the next fragment is accepted. An increment counts in its cycle
// (but not in the first after reset).
module ptm_unit_counters #(
  parameter int Tmus = 3,
  localparam int Counters = ptm_unit_pkg::Counters
) (
  input  logic        clk_i,
  input  logic        rst_ni,
  input  logic        clear_i,
  // Fragments in, pixels out
  input  logic        accepted_i,
  input  logic        taken_i,
  output logic        busy_o,  // fragments are inside
  // K and T
  input  logic        k_leaves_i,
  input  logic        k_holds_i,
  input  logic        f_accepts_i,
  input  logic        t_waits_for_slots_i,
  // Increments
  input  logic        inc_conflicts_i,
  input  logic [1:0]  inc_words_i,
  input  logic [3:0]  inc_taps_i,
  input  logic        inc_lines_i,
  input  logic [2:0]  inc_palette_i,
  input  logic [3:0]  inc_multiplies_address_i,
  input  logic [7:0]  inc_multiplies_filter_i,
  input  logic [4:0]  inc_multiplies_eval_i,
  input  logic [2:0]  inc_multiplies_combine_i,
  // Look-ups of T, by TMU and bank
  input  logic                              looked_i,
  input  logic [Tmus*4-1:0]                 hits_i,
  input  logic [Tmus*4-1:0]                 misses_i,
  input  logic [Tmus*4-1:0]                 duplicates_i,
  input  logic [Tmus-1:0]                   color_i,
  input  logic [ptm_unit_pkg::DrawBits-1:0] draw_i,
  input  logic [5:0]                        number_i,
  output logic [63:0]                       value_o  // of that counter, 0 if there is none
);
  localparam int Wide = 8;  // of an increment

  // Cycles
  logic        started_q;
  logic [15:0] inside_q;
  logic [63:0] idle_q;  // cycles with nothing inside since the last pixel was taken
  logic        working, counts;
  assign working = inside_q != '0;
  assign busy_o = working;
  assign counts = working || accepted_i;
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      started_q <= 1'b0;
      inside_q  <= '0;
      idle_q    <= '0;
    end else begin
      inside_q <= inside_q + 16'(accepted_i) - 16'(taken_i);
      if (clear_i) begin
        started_q <= 1'b0;
        idle_q    <= '0;
      end else if (counts) begin
        started_q <= 1'b1;
        idle_q    <= '0;
      end else if (started_q) begin
        idle_q <= idle_q + 64'd1;
      end
    end
  end

  function automatic logic [3:0] ones(input logic [Tmus*4-1:0] by_bank,
                                      input logic [Tmus-1:0] of);
    ones = 4'd0;
    for (int t = 0; t < Tmus; t++) begin
      for (int b = 0; b < 4; b++) ones = ones + 4'(of[t] && by_bank[t*4 + b]);
    end
  endfunction

  logic [Counters*Wide-1:0] step;
  logic [3:0] hits_map, hits_color, misses_map, misses_color, duplicates;
  always_comb begin
    hits_map     = 4'd0;
    hits_color   = 4'd0;
    misses_map   = 4'd0;
    misses_color = 4'd0;
    duplicates   = 4'd0;
    if (looked_i) begin
      hits_map   = ones(hits_i, ~color_i);
      hits_color = ones(hits_i, color_i);
      if (misses_i != '0) begin
        misses_map   = ones(misses_i, ~color_i);
        misses_color = ones(misses_i, color_i);
        duplicates   = ones(duplicates_i, '1);
      end
    end
  end

  assign step[0*Wide +: Wide]  = Wide'(accepted_i);
  assign step[1*Wide +: Wide]  = Wide'(taken_i);
  assign step[2*Wide +: Wide]  = Wide'(counts);
  assign step[3*Wide +: Wide]  = Wide'(counts && k_leaves_i);
  assign step[4*Wide +: Wide]  = Wide'(counts && k_holds_i && !k_leaves_i && !f_accepts_i);
  assign step[5*Wide +: Wide]  = Wide'(counts && k_holds_i && !k_leaves_i && f_accepts_i);
  assign step[6*Wide +: Wide]  = Wide'(counts && !k_holds_i && t_waits_for_slots_i);
  assign step[7*Wide +: Wide]  = Wide'(counts && !k_holds_i && !t_waits_for_slots_i);
  assign step[8*Wide +: Wide]  = Wide'(k_leaves_i);
  assign step[9*Wide +: Wide]  = Wide'(inc_conflicts_i);
  assign step[10*Wide +: Wide] = Wide'(inc_words_i);
  assign step[11*Wide +: Wide] = Wide'(inc_taps_i);
  assign step[12*Wide +: Wide] = Wide'(hits_map) + Wide'(hits_color);
  assign step[13*Wide +: Wide] = Wide'(misses_map) + Wide'(misses_color);
  assign step[14*Wide +: Wide] = Wide'(inc_lines_i);
  assign step[15*Wide +: Wide] = Wide'(duplicates);
  assign step[16*Wide +: Wide] = Wide'(inc_palette_i);
  assign step[17*Wide +: Wide] = Wide'(inc_multiplies_address_i);
  assign step[18*Wide +: Wide] = Wide'(inc_multiplies_filter_i);
  assign step[19*Wide +: Wide] = Wide'(inc_multiplies_eval_i);
  assign step[20*Wide +: Wide] = Wide'(inc_multiplies_combine_i);
  for (genvar d = 0; d < ptm_unit_pkg::Draws; d++) begin : gen_draw
    logic here;
    assign here            = draw_i == ptm_unit_pkg::DrawBits'(d);
    assign step[(21+4*d)*Wide +: Wide]    = here ? Wide'(hits_map) : '0;
    assign step[(21+4*d+1)*Wide +: Wide]  = here ? Wide'(misses_map) : '0;
    assign step[(21+4*d+2)*Wide +: Wide]  = here ? Wide'(hits_color) : '0;
    assign step[(21+4*d+3)*Wide +: Wide]  = here ? Wide'(misses_color) : '0;
  end

  // Only those that move are written. The cycles bring the idle time before them. What stands in
  // them after reset is cleared in the cycle after it.
  logic fresh_q, clear;
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) fresh_q <= 1'b1;
    else fresh_q <= 1'b0;
  end
  assign clear = clear_i || fresh_q;
  logic [63:0] count_q [Counters];
  for (genvar n = 0; n < Counters; n++) begin : gen_counter
    logic [63:0] sum;
    assign sum = count_q[n] + 64'(step[n*Wide +: Wide]) + (n == 2 || n == 7 ? idle_q : 64'd0);
    always_ff @(posedge clk_i) begin
      if (clear || step[n*Wide +: Wide] != '0) count_q[n] <= clear ? 64'd0 : sum;
    end
  end
  assign value_o = number_i < 6'(Counters) ? count_q[number_i] : 64'd0;
endmodule
