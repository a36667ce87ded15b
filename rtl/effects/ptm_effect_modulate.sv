// X3, the addend times a value of an extra pass; one register.        docs/spec/effects.md, X3
//
//   m = min(255, narrow(value[1 + c], LumFrac)) with argument bit 0, else of value[1]
//   addend[c] = narrow(addend[c] * (m + (m >> 7)), 8)
//
// Three multiplies. Twin: model/reference/effects/modulate.h.
module ptm_effect_modulate #(
  parameter int LumBits      = 10,  // EvalConfig
  parameter int LumFrac      = 0,
  parameter int RoundNearest = 1,
  localparam int LumW    = ptm_pkg::lum_bits(LumBits, LumFrac),
  localparam int Draws   = ptm_unit_pkg::Draws,
  localparam int AddendW = ptm_unit_pkg::AddendW,
  localparam int ValuesW = ptm_unit_pkg::PassesMax * LumW
) (
  input  logic                 clk_i,
  input  logic                 rst_ni,
  // Registers by draw, draw 0 lowest; the port that writes the table
  input  logic [Draws*9-1:0]   ks_i,
  input  logic [Draws*32-1:0]  argument_i,
  input  logic [Draws-1:0]     acts_i,
  input  logic                 table_we_i,
  input  logic [9:0]           table_addr_i,  // draw, entry
  input  logic [11:0]          table_data_i,
  // Stream in and out: pixel, addend of red green blue, values of the extra passes
  input  logic                 valid_i,
  output logic                 ready_o,
  input  ptm_unit_pkg::pixel_t pixel_i,
  input  logic [3*AddendW-1:0] addend_i,
  input  logic [ValuesW-1:0]   value_i,
  output logic                 valid_o,
  input  logic                 ready_i,
  output ptm_unit_pkg::pixel_t pixel_o,
  output logic [3*AddendW-1:0] addend_o,
  output logic [ValuesW-1:0]   value_o,
  // Multiplies of the pixel that enters
  output logic [2:0]           inc_o
);
  logic                 acts, load, channels;  // a value a channel
  ptm_unit_pkg::pixel_t pixel_q;
  logic [3*AddendW-1:0] addend, addend_q;
  logic [ValuesW-1:0]   value_q;
  ptm_stream_reg u_reg (
    .clk_i(clk_i), .rst_ni(rst_ni), .valid_i(valid_i), .ready_o(ready_o), .load_o(load),
    .valid_o(valid_o), .ready_i(ready_i)
  );
  assign acts     = acts_i[pixel_i.draw];
  assign channels = argument_i[{pixel_i.draw, 5'd0}];
  assign inc_o    = !(load && acts) ? 3'd0 : channels ? 3'd3 : 3'd1;

  for (genvar c = 0; c < 3; c++) begin : gen_channel
    logic [LumW-1:0]               value;
    logic signed [LumW:0]          levels;
    logic [7:0]                    m;
    logic [8:0]                    factor;
    logic signed [AddendW+9:0]     product, narrowed;
    assign value = channels ? value_i[(1+c)*LumW +: LumW] : value_i[LumW +: LumW];
    ptm_arith_narrow #(
      .InBits(LumW + 1), .AmountBits(3), .OutBits(LumW + 1), .RoundNearest(RoundNearest)
    ) u_levels (
      .x_i({1'b0, value}), .amount_i(3'(LumFrac)), .y_o(levels)
    );
    assign m       = levels[LumW:8] != '0 ? 8'd255 : levels[7:0];
    assign factor  = {1'b0, m} + {8'd0, m[7]};
    assign product = signed'({1'b0, (AddendW+9)'(addend_i[c*AddendW +: AddendW]) *
                                    (AddendW+9)'(factor)});
    ptm_arith_narrow #(
      .InBits(AddendW + 10), .AmountBits(4), .OutBits(AddendW + 10), .RoundNearest(RoundNearest)
    ) u_narrow (
      .x_i(product), .amount_i(4'd8), .y_o(narrowed)
    );
    assign addend[c*AddendW +: AddendW] = acts ? narrowed[AddendW-1:0]
                                               : addend_i[c*AddendW +: AddendW];
    logic unused_sign;
    assign unused_sign = ^narrowed[AddendW+9:AddendW];
  end

  always_ff @(posedge clk_i) begin
    if (load) begin
      pixel_q  <= pixel_i;
      addend_q <= addend;
      value_q  <= value_i;
    end
  end
  assign pixel_o  = pixel_q;
  assign addend_o = addend_q;
  assign value_o  = value_q;

  logic unused;
  assign unused = ^{ks_i, argument_i, table_we_i, table_addr_i, table_data_i};
endmodule
