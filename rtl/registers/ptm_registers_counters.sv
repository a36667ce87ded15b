// The unit's counters: docs/spec/unit-timing.md, Counters; their numbers are those of the table
// contract/counters.toml. The one of docs/spec/effects.md is 0 in a unit without stages.
//
// Cycles count from the first fragment accepted; those in which nothing is inside are added, as
// `input_empty`, when the next fragment is accepted. An increment counts in its cycle
// (but not in the first after reset).
module ptm_registers_counters #(
  parameter int Tmus   = 3,
  parameter int Stages = 0   // mask of effect stages
) (
  input  logic        clk_i,
  input  logic        rst_ni,
  input  logic        clear_i,
  // Fragments in, pixels out
  input  logic        accepted_i,
  input  logic        taken_i,
  input  logic        inside_i,  // fragments are inside
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
  input  logic [5:0]  inc_multiplies_eval_i,
  input  logic [2:0]  inc_multiplies_combine_i,
  input  logic [5:0]  inc_multiplies_effects_i,
  // Look-ups of T, by TMU and bank
  input  logic                              looked_i,
  input  logic [Tmus*4-1:0]                 hits_i,
  input  logic [Tmus*4-1:0]                 misses_i,
  input  logic [Tmus*4-1:0]                 duplicates_i,  // in a cycle of their own
  input  logic [Tmus-1:0]                   color_i,
  input  logic [ptm_unit_pkg::DrawBits-1:0] draw_i,
  input  logic [5:0]                        number_i,
  output logic [63:0]                       value_o  // of that counter, 0 if there is none
);
  localparam int Wide   = 8;   // of an increment
  // Counters that no draw has of its own lie before those of draws, and those of effects behind.
  localparam int Shared = ptm_register_pkg::CountHitsD0Map;
  localparam int Effects = ptm_register_pkg::CountMultipliesEffects;

  // Cycles
  logic        started_q;
  logic [63:0] idle_q;  // cycles with nothing inside since the last pixel was taken
  logic        counts;
  assign counts = inside_i || accepted_i;
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      started_q <= 1'b0;
      idle_q    <= '0;
    end else begin
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

  // Look-ups by texture: those of a TMU are its word's
  logic [3:0] hits_map, hits_color, misses_map, misses_color, duplicates;
  function automatic logic [3:0] ones(input logic [3:0] by_bank);
    ones = 4'(by_bank[0]) + 4'(by_bank[1]) + 4'(by_bank[2]) + 4'(by_bank[3]);
  endfunction
  always_comb begin
    hits_map     = 4'd0;
    hits_color   = 4'd0;
    misses_map   = 4'd0;
    misses_color = 4'd0;
    if (looked_i) begin
      for (int t = 0; t < Tmus; t++) begin
        if (color_i[t]) hits_color = hits_color + ones(hits_i[t*4 +: 4]);
        else hits_map = hits_map + ones(hits_i[t*4 +: 4]);
      end
      if (misses_i != '0) begin
        for (int t = 0; t < Tmus; t++) begin
          if (color_i[t]) misses_color = misses_color + ones(misses_i[t*4 +: 4]);
          else misses_map = misses_map + ones(misses_i[t*4 +: 4]);
        end
      end
    end
  end
  always_comb begin
    duplicates = 4'd0;
    if (duplicates_i != '0) begin
      for (int t = 0; t < Tmus; t++) duplicates = duplicates + ones(duplicates_i[t*4 +: 4]);
    end
  end

  logic [Shared*Wide-1:0] step;
  assign step[ptm_register_pkg::CountFragments*Wide +: Wide] = Wide'(accepted_i);
  assign step[ptm_register_pkg::CountPixels*Wide +: Wide] = Wide'(taken_i);
  assign step[ptm_register_pkg::CountCycles*Wide +: Wide] = Wide'(counts);
  assign step[ptm_register_pkg::CountCyclesMoved*Wide +: Wide] = Wide'(counts && k_leaves_i);
  assign step[ptm_register_pkg::CountCyclesOutputBlocked*Wide +: Wide] =
      Wide'(counts && k_holds_i && !k_leaves_i && !f_accepts_i);
  assign step[ptm_register_pkg::CountCyclesLineWait*Wide +: Wide] =
      Wide'(counts && k_holds_i && !k_leaves_i && f_accepts_i);
  assign step[ptm_register_pkg::CountCyclesRingFull*Wide +: Wide] =
      Wide'(counts && !k_holds_i && t_waits_for_slots_i);
  assign step[ptm_register_pkg::CountCyclesInputEmpty*Wide +: Wide] =
      Wide'(counts && !k_holds_i && !t_waits_for_slots_i);
  assign step[ptm_register_pkg::CountBeats*Wide +: Wide] = Wide'(k_leaves_i);
  assign step[ptm_register_pkg::CountBankConflicts*Wide +: Wide] = Wide'(inc_conflicts_i);
  assign step[ptm_register_pkg::CountWords*Wide +: Wide] = Wide'(inc_words_i);
  assign step[ptm_register_pkg::CountTaps*Wide +: Wide] = Wide'(inc_taps_i);
  assign step[ptm_register_pkg::CountTagHits*Wide +: Wide] = Wide'(hits_map) + Wide'(hits_color);
  assign step[ptm_register_pkg::CountTagMisses*Wide +: Wide] =
      Wide'(misses_map) + Wide'(misses_color);
  assign step[ptm_register_pkg::CountLinesRead*Wide +: Wide] = Wide'(inc_lines_i);
  assign step[ptm_register_pkg::CountDuplicateLines*Wide +: Wide] = Wide'(duplicates);
  assign step[ptm_register_pkg::CountPaletteLookups*Wide +: Wide] = Wide'(inc_palette_i);
  assign step[ptm_register_pkg::CountMultipliesAddress*Wide +: Wide] =
      Wide'(inc_multiplies_address_i);
  assign step[ptm_register_pkg::CountMultipliesFilter*Wide +: Wide] =
      Wide'(inc_multiplies_filter_i);
  assign step[ptm_register_pkg::CountMultipliesEval*Wide +: Wide] = Wide'(inc_multiplies_eval_i);
  assign step[ptm_register_pkg::CountMultipliesCombine*Wide +: Wide] =
      Wide'(inc_multiplies_combine_i);

  // Only those that move are written. The cycles bring the idle time before them. What stands in
  // them after reset is cleared in the cycle after it.
  logic fresh_q, clear;
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) fresh_q <= 1'b1;
    else fresh_q <= 1'b0;
  end
  assign clear = clear_i || fresh_q;
  // (Blocking assignments, as in ptm_memory_ram: nothing reads them at the edge but what writes
  // them, and the simulation copies no arrays.)
  /* verilator lint_off BLKSEQ */
  logic [63:0] count_q [Shared];
  for (genvar n = 0; n < Shared; n++) begin : gen_counter
    localparam bit Idle = n == ptm_register_pkg::CountCycles ||
                          n == ptm_register_pkg::CountCyclesInputEmpty;
    logic [Wide-1:0] increment;
    assign increment = step[n*Wide +: Wide];
    always_ff @(posedge clk_i) begin
      if (clear) begin
        count_q[n] = 64'd0;
      end else if (increment != '0) begin
        count_q[n] = count_q[n] + 64'(increment) + (Idle ? idle_q : 64'd0);
      end
    end
  end

  // A draw's own: hits and misses of its map, of its colour texture
  logic [63:0] draw_count_q [4*ptm_unit_pkg::Draws];
  for (genvar d = 0; d < ptm_unit_pkg::Draws; d++) begin : gen_draw
    always_ff @(posedge clk_i) begin
      if (clear) begin
        draw_count_q[4*d]   = 64'd0;
        draw_count_q[4*d+1] = 64'd0;
        draw_count_q[4*d+2] = 64'd0;
        draw_count_q[4*d+3] = 64'd0;
      end else if (looked_i) begin
        if (draw_i == ptm_unit_pkg::DrawBits'(d)) begin
          draw_count_q[4*d]   = draw_count_q[4*d] + 64'(hits_map);
          draw_count_q[4*d+1] = draw_count_q[4*d+1] + 64'(misses_map);
          draw_count_q[4*d+2] = draw_count_q[4*d+2] + 64'(hits_color);
          draw_count_q[4*d+3] = draw_count_q[4*d+3] + 64'(misses_color);
        end
      end
    end
  end
  /* verilator lint_on BLKSEQ */

  logic [5:0]  of_draws;
  logic [63:0] value;
  assign of_draws = number_i - 6'(Shared);
  always_comb begin
    value = 64'd0;
    if (number_i < 6'(Shared)) value = count_q[number_i[4:0]];
    else if (number_i < 6'(Effects)) value = draw_count_q[of_draws[3:0]];
  end

  if (Stages == 0) begin : gen_no_effects
    assign value_o = value;
    logic unused_effects;
    assign unused_effects = ^inc_multiplies_effects_i;
  end else begin : gen_effects
    logic [63:0] effects_q;
    always_ff @(posedge clk_i) begin
      if (clear) effects_q <= 64'd0;
      else if (inc_multiplies_effects_i != '0) effects_q <= effects_q + 64'(inc_multiplies_effects_i);
    end
    assign value_o = number_i == 6'(Effects) ? effects_q : value;
  end

  logic unused_bits;
  assign unused_bits = ^of_draws[5:4];
endmodule
