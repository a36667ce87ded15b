// X4, the addend on top of the pixel; one register.                   docs/spec/effects.md, X4
//
//   rgb[c] = min(255, rgb[c] + narrow(addend[c], 4))
//
// Twin: model/reference/effects/add.h.
module ptm_effect_add #(
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
  logic                 acts, load;
  ptm_unit_pkg::pixel_t pixel, pixel_q;
  logic [3*AddendW-1:0] addend_q;
  logic [ValuesW-1:0]   value_q;
  ptm_stream_reg u_reg (
    .clk_i(clk_i), .rst_ni(rst_ni), .valid_i(valid_i), .ready_o(ready_o), .load_o(load),
    .valid_o(valid_o), .ready_i(ready_i)
  );
  assign acts  = acts_i[pixel_i.draw];
  assign inc_o = 3'd0;

  logic [23:0] rgb;
  for (genvar c = 0; c < 3; c++) begin : gen_channel
    logic signed [AddendW:0] levels;
    logic [AddendW:0]        sum;
    ptm_arith_narrow #(
      .InBits(AddendW + 1), .AmountBits(3), .OutBits(AddendW + 1), .RoundNearest(RoundNearest)
    ) u_narrow (
      .x_i({1'b0, addend_i[c*AddendW +: AddendW]}), .amount_i(3'd4), .y_o(levels)
    );
    assign sum             = (AddendW+1)'(pixel_i.rgb[c]) + unsigned'(levels);
    assign rgb[8*c +: 8] = !acts ? pixel_i.rgb[c] : sum[AddendW:8] != '0 ? 8'd255 : sum[7:0];
  end
  always_comb begin
    pixel     = pixel_i;
    pixel.rgb = rgb;
  end

  always_ff @(posedge clk_i) begin
    if (load) begin
      pixel_q  <= pixel;
      addend_q <= addend_i;
      value_q  <= value_i;
    end
  end
  assign pixel_o  = pixel_q;
  assign addend_o = addend_q;
  assign value_o  = value_q;

  logic unused;
  assign unused = ^{ks_i, argument_i, table_we_i, table_addr_i, table_data_i};
endmodule
