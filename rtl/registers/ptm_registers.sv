// The unit's registers: draws, palettes' addresses, status, events, counters; the check of what
// was written.
//
// Map: docs/spec/unit.md, Registers. A write takes one cycle and is never made to wait; reading is
// combinational. Addresses that hold nothing read as 0 and are not written. What fragments read is
// not written while fragments are inside, nor in the cycle in which one is accepted: such a write
// is ignored and sets an event bit. Writing a draw's control starts its check, which looks at one
// level a cycle, the map's 13 and then the colour texture's, in 26 cycles; draws whose control is
// written meanwhile wait, the lowest first.
module ptm_registers #(
  parameter int CoefBits    = 8,
  parameter int HalfVector  = 0,  // effects, as ptm_unit
  parameter int ExtraSets   = 0,
  parameter int ExtraPasses = 0,
  parameter int Stages      = 0
) (
  input  logic        clk_i,
  input  logic        rst_ni,
  // The register port
  input  logic        reg_we_i,
  input  logic [15:0] reg_addr_i,
  input  logic [31:0] reg_wdata_i,
  output logic [31:0] reg_rdata_o,
  output logic [ptm_unit_pkg::Draws*ptm_unit_pkg::DrawW-1:0] draws_o,  // draw_t, draw 0 lowest
  output logic [ptm_unit_pkg::Draws*ptm_unit_pkg::EffectW-1:0] effects_o,  // effect_t
  output logic        table_we_o,    // tables of effects
  output logic [9:0]  table_addr_o,
  output logic [11:0] table_data_o,
  output logic        error_o,       // a draw that was written is illegal
  output logic        checking_o,    // a draw is looked at, or waits for it
  output logic        irq_o,         // an event whose enable bit is set
  input  logic        busy_i,        // fragments inside
  input  logic        accepted_i,    // a fragment enters
  input  logic        last_taken_i,  // the last pixel of what is inside leaves
  output logic        invalidate_o,  // the caches; in the cycle of the write
  output logic        clear_o,       // the counters; in the cycle of the write
  input  logic        mem_error_i,   // a response came with a tag that is not outstanding
  input  logic [7:0]  mem_error_tag_i,
  input  logic        mem_failed_i,  // a response says that its line could not be read
  input  logic        draining_i,    // the memory owes answers from before the reset
  output logic [ptm_register_pkg::LineBits-1:0] mem_base_o,  // is added to every request's line
  output logic [5:0]  counter_number_o,  // which counter the read address asks for
  input  logic [63:0] counter_i,         // its value, 0 if there is none of that number
  input  logic [32*ptm_register_pkg::CapabilityWords-1:0] capabilities_i,  // word 0 lowest
  // Palettes
  output logic        pal_lrgb_we_o,
  output logic [10:0] pal_lrgb_addr_o,
  output logic        pal_rgb_we_o,
  output logic [14:0] pal_rgb_addr_o,
  output logic [31:0] pal_data_o,
  output logic [3:0]  pal_upper_o    // of the word, above pal_data_o: CoefBits above 10 only
);
  localparam int DrawW     = ptm_register_pkg::DrawW;
  localparam int Draws     = ptm_register_pkg::Draws;
  localparam int LastLevel = ptm_register_pkg::LevelsMax - 1;

  // Writes. What fragments read: draws, commands that invalidate, the memory's lines, palettes,
  // effects' sets and tables
  logic locked, shared, we_shared, refused;
  logic we_draws, we_command, we_lines, we_base, we_events, we_enable;
  `include "contract/ptm_shared_write.svh"
  // An address's block; blocks are as long as a power of two and aligned to it.
  localparam int DrawAt = $clog2(ptm_register_pkg::DrawSize);
  localparam int LrgbAt = $clog2(ptm_register_pkg::LrgbPaletteSize);
  localparam int RgbAt  = $clog2(ptm_register_pkg::RgbPaletteSize);
  localparam logic [15:0] DrawBlock = ptm_register_pkg::DrawBlock;
  localparam logic [15:0] LrgbBlock = ptm_register_pkg::LrgbPaletteBlock;
  localparam logic [15:0] RgbBlock  = ptm_register_pkg::RgbPaletteBlock;
  localparam int DrawStep = $clog2(ptm_register_pkg::DrawStride);  // of one draw's registers
  logic in_draws;
  assign in_draws = reg_addr_i[15:DrawAt] == DrawBlock[15:DrawAt];
  always_comb begin
    {shared, refused, we_shared}                         = '0;
    {we_draws, we_command, we_lines, we_base}            = '0;
    {we_events, we_enable}                               = '0;
    {pal_lrgb_we_o, pal_rgb_we_o, invalidate_o, clear_o} = '0;
    if (reg_we_i) begin
      we_command    = reg_addr_i == ptm_register_pkg::CommandAddr;
      we_events     = reg_addr_i == ptm_register_pkg::EventsAddr;
      we_enable     = reg_addr_i == ptm_register_pkg::EnableAddr;
      clear_o       = we_command && reg_wdata_i[ptm_register_pkg::CommandClearLow];
      shared        = is_shared_write(reg_addr_i, reg_wdata_i);
      refused       = shared && locked;
      we_shared     = shared && !locked;
      we_draws      = we_shared && in_draws;
      we_lines      = we_shared && reg_addr_i == ptm_register_pkg::MemoryLinesAddr;
      we_base       = we_shared && reg_addr_i == ptm_register_pkg::MemoryBaseAddr;
      pal_lrgb_we_o = we_shared && reg_addr_i[15:LrgbAt] == LrgbBlock[15:LrgbAt];
      pal_rgb_we_o  = we_shared && reg_addr_i[15:RgbAt] == RgbBlock[15:RgbAt];
      invalidate_o  = we_shared && we_command;
    end
  end
  assign locked          = busy_i || accepted_i;
  assign pal_lrgb_addr_o = reg_addr_i[10:0];
  assign pal_rgb_addr_o  = reg_addr_i[14:0];
  assign pal_data_o      = reg_wdata_i;

  // Three coefficients of more than 10 bits do not fit the 32 of a write.
  if (CoefBits <= 10) begin : gen_no_upper
    assign pal_upper_o = '0;
  end else begin : gen_upper
    logic [3:0] pal_upper_q;
    always_ff @(posedge clk_i or negedge rst_ni) begin
      if (!rst_ni) pal_upper_q <= '0;
      else if (we_shared && reg_addr_i == ptm_register_pkg::PaletteUpperAddr) begin
        pal_upper_q <= reg_wdata_i[ptm_register_pkg::PaletteUpperBitsW-1:0];
      end
    end
    assign pal_upper_o = pal_upper_q;
  end

  localparam int LinesW = ptm_register_pkg::MemoryLinesLinesW;
  logic [LinesW-1:0] memory_lines_q;
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) memory_lines_q <= '0;
    else if (we_lines) memory_lines_q <= reg_wdata_i[LinesW-1:0];
  end

  // Draws, as one vector that only writes touch: put together of registers it took a third of the
  // unit's simulation time.
  localparam int LineW = ptm_register_pkg::LineBits, SideW = ptm_register_pkg::SideBits;

  logic [Draws*DrawW-1:0] draws_q;
  logic [Draws-1:0]       we_control;
  assign draws_o = draws_q;
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) draws_q <= '0;
    else if (we_draws) begin
      for (int d = 0; d < Draws; d++) begin
        if (reg_addr_i[DrawAt-1:DrawStep] == 2'(d)) begin
          case (reg_addr_i[DrawStep-1:0])
            `include "contract/ptm_draw_write.svh"
            default: ;
          endcase
        end
      end
    end
  end
  always_comb begin
    we_control = '0;
    if (we_draws && reg_addr_i[DrawStep-1:0] == ptm_register_pkg::DrawControlOffset) begin
      we_control[reg_addr_i[DrawAt-1:DrawStep]] = 1'b1;
    end
  end

  // Effects
  localparam int EffectW = ptm_register_pkg::EffectW;
  logic               active_q;      // a draw is checked,
  logic [1:0]         check_draw_q;  // this one
  logic [EffectW-1:0] effect;        // its
  logic [31:0]        effect_word;   // read
  if (ExtraSets == 0 && ExtraPasses == 0 && Stages == 0) begin : gen_no_effects
    assign effects_o  = '0;
    assign table_we_o = 1'b0;
    assign {table_addr_o, table_data_o} = '0;
    assign effect      = '0;
    assign effect_word = '0;
  end else begin : gen_effects
    ptm_registers_effects #(
      .ExtraSets(ExtraSets), .ExtraPasses(ExtraPasses), .Stages(Stages)
    ) u_effect_registers (
      .clk_i(clk_i), .rst_ni(rst_ni), .reg_we_i(we_shared), .reg_addr_i(reg_addr_i),
      .reg_wdata_i(reg_wdata_i), .reg_rdata_o(effect_word), .effects_o(effects_o),
      .table_we_o(table_we_o), .table_addr_o(table_addr_o), .table_data_o(table_data_o)
    );
    ptm_registers_by_draw #(.Width(EffectW)) u_checked (
      .values_i(effects_o), .draw_i(check_draw_q), .value_o(effect)
    );
  end

  // The check: one level of one texture a cycle
  logic             texture_q;
  logic [3:0]       level_q;
  logic [Draws-1:0] waiting_q;
  logic [2:0]       seen_q;    // control, levels, size: errors so far
  logic             beyond_q;  // error 4 so far
  logic [4*Draws-1:0] errors_q;

  localparam int ColorAt  = ptm_register_pkg::DrawColorTextureAt;
  localparam int MapAt    = ptm_register_pkg::DrawPtmAt;
  localparam int WidthAt  = ptm_register_pkg::TextureWidthAt;  // in a texture_t
  localparam int HeightAt = ptm_register_pkg::TextureHeightAt;
  localparam int LevelsAt = ptm_register_pkg::TextureLevelsAt;
  localparam int BaseAt   = ptm_register_pkg::TextureBaseAt;
  logic [2:0]       format, combine;
  logic [1:0]       mip, wrap_u, wrap_v;
  logic             color;
  logic [SideW-1:0] width, height;
  logic [3:0]       levels;
  logic [LineW-1:0] base;
  always_comb begin
    {format, combine, mip, wrap_u, wrap_v, color} = '0;
    {width, height, levels, base}                 = '0;
    if (active_q) begin
      for (int d = 0; d < Draws; d++) begin
        if (check_draw_q == 2'(d)) begin
          format  = draws_q[d*DrawW+ptm_register_pkg::DrawFormatAt +: 3];
          combine = draws_q[d*DrawW+ptm_register_pkg::DrawCombineAt +: 3];
          mip     = draws_q[d*DrawW+ptm_register_pkg::DrawMipAt +: 2];
          wrap_u  = draws_q[d*DrawW+ptm_register_pkg::DrawWrapUAt +: 2];
          wrap_v  = draws_q[d*DrawW+ptm_register_pkg::DrawWrapVAt +: 2];
          color   = draws_q[d*DrawW+ptm_register_pkg::DrawColorAt];
          width   = texture_q ? draws_q[d*DrawW+ColorAt+WidthAt +: SideW]
                              : draws_q[d*DrawW+MapAt+WidthAt +: SideW];
          height  = texture_q ? draws_q[d*DrawW+ColorAt+HeightAt +: SideW]
                              : draws_q[d*DrawW+MapAt+HeightAt +: SideW];
          levels  = texture_q ? draws_q[d*DrawW+ColorAt+LevelsAt +: 4]
                              : draws_q[d*DrawW+MapAt+LevelsAt +: 4];
          for (int l = 0; l <= LastLevel; l++) begin
            if (level_q == 4'(l)) begin
              base = texture_q ? draws_q[d*DrawW+ColorAt+BaseAt+LineW*l +: LineW]
                               : draws_q[d*DrawW+MapAt+BaseAt+LineW*l +: LineW];
            end
          end
        end
      end
    end
  end

  logic bad_size, bad_levels, bad_control, beyond;
  ptm_registers_draw_check #(
    .CoefBits(CoefBits), .HalfVector(HalfVector), .ExtraSets(ExtraSets),
    .ExtraPasses(ExtraPasses), .Stages(Stages)
  ) u_check (
    .effect_i(effect),
    .format_i(format), .mip_i(mip), .wrap_u_i(wrap_u), .wrap_v_i(wrap_v), .combine_i(combine),
    .color_i(color), .texture_i(texture_q), .width_i(width), .height_i(height),
    .levels_i(levels), .level_i(level_q), .base_i(base), .memory_lines_i(memory_lines_q),
    .bad_size_o(bad_size), .bad_levels_o(bad_levels), .bad_control_o(bad_control),
    .beyond_o(beyond)
  );

  logic       last, beyond_all;
  logic [2:0] seen;
  logic [3:0] errors;
  assign last       = texture_q && level_q == 4'(LastLevel);
  always_comb begin
    seen       = '0;
    beyond_all = 1'b0;
    errors     = '0;
    if (active_q) begin
      seen       = seen_q | {bad_control, bad_levels, bad_size};
      beyond_all = beyond_q || beyond;
      if (last) errors = {seen[2], beyond_all && seen == '0, seen[1:0]};
    end
  end

  // A draw starts to be looked at
  logic       start;
  logic [1:0] next;
  assign start = !active_q && waiting_q != '0;
  always_comb begin
    next = '0;
    if (start) next = waiting_q[0] ? 2'd0 : waiting_q[1] ? 2'd1 : waiting_q[2] ? 2'd2 : 2'd3;
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      active_q  <= 1'b0;
      waiting_q <= '0;
      errors_q  <= '0;
    end else begin
      if (start) active_q <= 1'b1;
      else if (last) active_q <= 1'b0;
      if (start || we_draws) begin
        for (int d = 0; d < Draws; d++) begin
          if (we_control[d]) waiting_q[d] <= 1'b1;
          else if (start && next == 2'(d)) waiting_q[d] <= 1'b0;
        end
      end
      if (active_q && last) errors_q[4*check_draw_q +: 4] <= errors;
    end
  end
  always_ff @(posedge clk_i) begin
    if (start) begin
      check_draw_q <= next;
      texture_q    <= 1'b0;
      level_q      <= 4'd0;
      seen_q       <= '0;
      beyond_q     <= 1'b0;
    end else if (active_q) begin
      seen_q    <= seen;
      beyond_q  <= beyond_all;
      level_q   <= level_q == 4'(LastLevel) ? 4'd0 : level_q + 4'd1;
      texture_q <= texture_q || level_q == 4'(LastLevel);
    end
  end
  assign checking_o = active_q || waiting_q != '0;
  assign error_o    = errors_q != '0;

  // A response that nobody waits for: the first one's tag is kept until it is cleared.
  logic       mem_error_q;
  logic [7:0] mem_error_tag_q;
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) mem_error_q <= 1'b0;
    else if (clear_o) mem_error_q <= 1'b0;
    else if (mem_error_i) mem_error_q <= 1'b1;
  end
  always_ff @(posedge clk_i) begin
    if (clear_o) mem_error_tag_q <= 8'd0;
    else if (mem_error_i && !mem_error_q) mem_error_tag_q <= mem_error_tag_i;
  end

  // Events
  logic [ptm_register_pkg::EventsW-1:0] causes, events, enable;
  always_comb begin
    causes                                        = '0;
    causes[ptm_register_pkg::EventsIdleLow]       = last_taken_i;
    causes[ptm_register_pkg::EventsDrawErrorLow]  = errors != '0;
    causes[ptm_register_pkg::EventsWrongTagLow]   = mem_error_i;
    causes[ptm_register_pkg::EventsFailedLineLow] = mem_failed_i;
    causes[ptm_register_pkg::EventsRefusedLow]    = refused;
  end
  ptm_registers_events u_events (
    .clk_i(clk_i), .rst_ni(rst_ni), .causes_i(causes), .we_events_i(we_events),
    .we_enable_i(we_enable), .wdata_i(reg_wdata_i[ptm_register_pkg::EventsW-1:0]),
    .events_o(events), .enable_o(enable), .irq_o(irq_o)
  );

  // Where in the outer memory the unit's lines lie
  logic [ptm_register_pkg::LineBits-1:0] mem_base_q;
  assign mem_base_o = mem_base_q;
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) mem_base_q <= '0;
    else if (we_base) mem_base_q <= reg_wdata_i[ptm_register_pkg::LineBits-1:0];
  end

  // Reading
  logic [31:0] draw_word;
  ptm_registers_draw_word u_draw_word (
    .draws_i(draws_q), .read_i(in_draws), .addr_i(reg_addr_i[DrawAt-1:0]),
    .data_o(draw_word)
  );
  localparam int CounterAt = $clog2(ptm_register_pkg::CounterSize);
  localparam int UnitAt    = $clog2(ptm_register_pkg::UnitSize);
  localparam logic [15:0] CounterBlock = ptm_register_pkg::CounterBlock;
  localparam logic [15:0] UnitBlock    = ptm_register_pkg::UnitBlock;
  assign counter_number_o = reg_addr_i[6:1];
  always_comb begin
    reg_rdata_o = '0;
    if (reg_addr_i[15:CounterAt] == CounterBlock[15:CounterAt]) begin
      reg_rdata_o = reg_addr_i[0] == ptm_register_pkg::CounterHighOffset ? counter_i[63:32]
                                                                         : counter_i[31:0];
    end else if (reg_addr_i[15:UnitAt] == UnitBlock[15:UnitAt]) begin
      case (reg_addr_i[UnitAt-1:0])
        ptm_register_pkg::MemoryLinesOffset: reg_rdata_o = 32'(memory_lines_q);
        ptm_register_pkg::ErrorsOffset: begin
          for (int d = 0; d < Draws; d++) begin
            reg_rdata_o[ptm_register_pkg::ErrorsDrawLow+ptm_register_pkg::ErrorsDrawStep*d +: 4] =
                errors_q[4*d +: 4];
          end
        end
        ptm_register_pkg::StateOffset: begin
          reg_rdata_o[ptm_register_pkg::StateBusyLow]     = busy_i || checking_o;
          reg_rdata_o[ptm_register_pkg::StateWrongTagLow] = mem_error_q;
          reg_rdata_o[ptm_register_pkg::StateDrainingLow] = draining_i;
          reg_rdata_o[ptm_register_pkg::StateTagLow +: ptm_register_pkg::StateTagW] =
              mem_error_q ? mem_error_tag_q : 8'd0;
        end
        ptm_register_pkg::MemoryBaseOffset: reg_rdata_o = 32'(mem_base_q);
        ptm_register_pkg::PaletteUpperOffset: reg_rdata_o = 32'(pal_upper_o);
        ptm_register_pkg::EventsOffset: reg_rdata_o = 32'(events);
        ptm_register_pkg::EnableOffset: reg_rdata_o = 32'(enable);
        ptm_register_pkg::MagicOffset: reg_rdata_o = ptm_register_pkg::MagicReset;
        ptm_register_pkg::VersionOffset: reg_rdata_o = ptm_register_pkg::VersionReset;
        default: begin
          for (int n = 0; n < ptm_register_pkg::CapabilityWords; n++) begin
            if (reg_addr_i[UnitAt-1:0] == ptm_register_pkg::CapabilitiesOffset + UnitAt'(n)) begin
              reg_rdata_o = capabilities_i[32*n +: 32];
            end
          end
        end
      endcase
    end else begin
      reg_rdata_o = draw_word | effect_word;
    end
  end
endmodule
