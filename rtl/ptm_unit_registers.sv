// The unit's registers. Skeleton, the ports are final.
module ptm_unit_registers (
  input  logic        clk_i,
  input  logic        rst_ni,
  // The register port: a write a cycle; reading is combinational
  input  logic        reg_we_i,
  input  logic [15:0] reg_addr_i,
  input  logic [31:0] reg_wdata_i,
  output logic [31:0] reg_rdata_o,
  output logic [ptm_unit_pkg::Draws*ptm_unit_pkg::DrawW-1:0] draws_o,  // draw_t, draw 0 lowest
  output logic        error_o,       // a draw that was written is illegal
  output logic        checking_o,    // a draw is being looked at
  input  logic        busy_i,        // fragments inside
  output logic        invalidate_o,  // the caches; in the cycle of the write
  output logic        clear_o,       // the counters; in the cycle of the write
  input  logic        mem_error_i,   // a response came with a tag that is not outstanding
  input  logic [7:0]  mem_error_tag_i,
  input  logic [ptm_unit_pkg::Counters*64-1:0] counters_i,  // counter 0 lowest
  // Palettes
  output logic        pal_lrgb_we_o,
  output logic [10:0] pal_lrgb_addr_o,
  output logic        pal_rgb_we_o,
  output logic [14:0] pal_rgb_addr_o,
  output logic [31:0] pal_data_o
);
  assign reg_rdata_o = '0;
  assign draws_o     = '0;
  assign {error_o, checking_o, invalidate_o, clear_o} = '0;
  assign {pal_lrgb_we_o, pal_lrgb_addr_o, pal_rgb_we_o, pal_rgb_addr_o, pal_data_o} = '0;
endmodule
