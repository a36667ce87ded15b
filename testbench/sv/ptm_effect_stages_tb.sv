// The stages of effects, each on its own behind pins that have the same C++ types for every
// variant; stage_i chooses whose outputs are shown and who gets valid and ready. No design logic.
module ptm_effect_stages_tb #(
  parameter int LumBits      = 10,
  parameter int LumFrac      = 0,
  parameter int RoundNearest = 1
) (
  input  logic         clk_i,
  input  logic         rst_ni,
  input  logic [1:0]   stage_i,      // power, modulate, add
  input  logic [3:0]   acts_i,       // by draw
  input  logic [15:0]  ks_i [4],
  input  logic [31:0]  argument_i [4],
  input  logic         table_we_i,
  input  logic [15:0]  table_addr_i,
  input  logic [15:0]  table_data_i,
  input  logic         valid_i,
  output logic         ready_o,
  input  logic [63:0]  pixel_i,      // pixel_t
  input  logic [15:0]  addend_i [3],
  input  logic [15:0]  value_i [4],
  output logic         valid_o,
  input  logic         ready_i,
  output logic [63:0]  pixel_o,
  output logic [15:0]  addend_o [3],
  output logic [15:0]  value_o [4],
  output logic [7:0]   inc_o
);
  localparam int LumW    = LumBits + LumFrac;
  localparam int AddendW = ptm_unit_pkg::AddendW;

  logic [35:0]          ks;
  logic [127:0]         argument;
  logic [3*AddendW-1:0] addend;
  logic [4*LumW-1:0]    value;
  for (genvar n = 0; n < 4; n++) begin : gen_in
    assign ks[9*n +: 9]          = ks_i[n][8:0];
    assign argument[32*n +: 32]  = argument_i[n];
    assign value[LumW*n +: LumW] = value_i[n][LumW-1:0];
    if (n < 3) begin : gen_addend
      assign addend[AddendW*n +: AddendW] = addend_i[n][AddendW-1:0];
    end
  end

  logic [2:0]           valid, ready;
  ptm_unit_pkg::pixel_t pixel0, pixel1, pixel2;
  logic [3*AddendW-1:0] addend0, addend1, addend2, addend_shown;
  logic [4*LumW-1:0]    value0, value1, value2, value_shown;
  logic [2:0]           inc0, inc1, inc2;
  ptm_effect_power #(
    .LumBits(LumBits), .LumFrac(LumFrac), .RoundNearest(RoundNearest)
  ) u_power (
    .clk_i(clk_i), .rst_ni(rst_ni), .ks_i(ks), .argument_i(argument), .acts_i(acts_i),
    .table_we_i(table_we_i), .table_addr_i(table_addr_i[9:0]), .table_data_i(table_data_i[11:0]),
    .valid_i(valid_i && stage_i == 2'd0), .ready_o(ready[0]), .pixel_i(pixel_i),
    .addend_i(addend), .value_i(value), .valid_o(valid[0]),
    .ready_i(ready_i && stage_i == 2'd0), .pixel_o(pixel0), .addend_o(addend0),
    .value_o(value0), .inc_o(inc0)
  );
  ptm_effect_modulate #(
    .LumBits(LumBits), .LumFrac(LumFrac), .RoundNearest(RoundNearest)
  ) u_modulate (
    .clk_i(clk_i), .rst_ni(rst_ni), .ks_i(ks), .argument_i(argument), .acts_i(acts_i),
    .table_we_i(table_we_i), .table_addr_i(table_addr_i[9:0]), .table_data_i(table_data_i[11:0]),
    .valid_i(valid_i && stage_i == 2'd1), .ready_o(ready[1]), .pixel_i(pixel_i),
    .addend_i(addend), .value_i(value), .valid_o(valid[1]),
    .ready_i(ready_i && stage_i == 2'd1), .pixel_o(pixel1), .addend_o(addend1),
    .value_o(value1), .inc_o(inc1)
  );
  ptm_effect_add #(
    .LumBits(LumBits), .LumFrac(LumFrac), .RoundNearest(RoundNearest)
  ) u_add (
    .clk_i(clk_i), .rst_ni(rst_ni), .ks_i(ks), .argument_i(argument), .acts_i(acts_i),
    .table_we_i(table_we_i), .table_addr_i(table_addr_i[9:0]), .table_data_i(table_data_i[11:0]),
    .valid_i(valid_i && stage_i == 2'd2), .ready_o(ready[2]), .pixel_i(pixel_i),
    .addend_i(addend), .value_i(value), .valid_o(valid[2]),
    .ready_i(ready_i && stage_i == 2'd2), .pixel_o(pixel2), .addend_o(addend2),
    .value_o(value2), .inc_o(inc2)
  );

  always_comb begin
    case (stage_i)
      2'd0:    {pixel_o, addend_shown, value_shown, inc_o} = {pixel0, addend0, value0, 8'(inc0)};
      2'd1:    {pixel_o, addend_shown, value_shown, inc_o} = {pixel1, addend1, value1, 8'(inc1)};
      default: {pixel_o, addend_shown, value_shown, inc_o} = {pixel2, addend2, value2, 8'(inc2)};
    endcase
  end
  assign valid_o = stage_i == 2'd0 ? valid[0] : stage_i == 2'd1 ? valid[1] : valid[2];
  assign ready_o = stage_i == 2'd0 ? ready[0] : stage_i == 2'd1 ? ready[1] : ready[2];
  for (genvar n = 0; n < 4; n++) begin : gen_out
    assign value_o[n] = 16'(value_shown[LumW*n +: LumW]);
    if (n < 3) begin : gen_addend
      assign addend_o[n] = 16'(addend_shown[AddendW*n +: AddendW]);
    end
  end
endmodule
