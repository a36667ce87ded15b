// X2, a power by table; registers: table | lerp | product.          docs/spec/effects.md, X2
// The first of them is the table's own: a memory that answers in the next cycle.
//
//   x = min(value[0], 255 << LumFrac); i = x >> LumFrac; f = x - (i << LumFrac)
//   e = table[i] + narrow((table[min(i + 1, 255)] - table[i]) * f, LumFrac)
//   addend = narrow(ks * e, 8), all three
//
// One multiply, and one of the lerp, which is built if LumFrac is not 0. A draw's table is written
// while the unit is idle. Twin: model/reference/effects/power.h.
module ptm_effect_power #(
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
  localparam int EntryW = 12;

  // What travels beside every register
  logic                 acts, load1, load2, load3, valid1, valid2, ready1, ready2;
  ptm_unit_pkg::pixel_t pixel1_q, pixel2_q, pixel3_q;
  logic [3*AddendW-1:0] addend1_q, addend2_q, addend3_q;
  logic [ValuesW-1:0]   value1_q, value2_q, value3_q;
  logic                 acts1_q, acts2_q;
  assign acts = acts_i[pixel_i.draw];
  ptm_stream_reg u_1 (
    .clk_i(clk_i), .rst_ni(rst_ni), .valid_i(valid_i), .ready_o(ready_o), .load_o(load1),
    .valid_o(valid1), .ready_i(ready1)
  );
  ptm_stream_reg u_2 (
    .clk_i(clk_i), .rst_ni(rst_ni), .valid_i(valid1), .ready_o(ready1), .load_o(load2),
    .valid_o(valid2), .ready_i(ready2)
  );
  ptm_stream_reg u_3 (
    .clk_i(clk_i), .rst_ni(rst_ni), .valid_i(valid2), .ready_o(ready2), .load_o(load3),
    .valid_o(valid_o), .ready_i(ready_i)
  );
  assign inc_o = !(load1 && acts) ? 3'd0 : LumFrac > 0 ? 3'd2 : 3'd1;

  // Table |
  logic [LumW-1:0]   x;
  logic [LumBits:0]  level;  // whole levels of value[0]
  logic [7:0]        index;
  assign x     = value_i[LumW-1:0];
  assign level = {1'b0, x[LumW-1:LumFrac]};
  assign index = level[LumBits:8] != '0 ? 8'd255 : level[7:0];

  // | lerp |
  logic [EntryW-1:0] power, power2_q;
  if (LumFrac == 0) begin : gen_entry
    ptm_memory_ram #(.Depth(Draws * 256), .Width(EntryW)) u_table (
      .clk_i(clk_i), .write_i(table_we_i), .write_address_i(table_addr_i),
      .write_data_i(table_data_i), .read_i(load1 && acts),
      .read_address_i({pixel_i.draw, index}), .read_data_o(power)
    );
  end else begin : gen_lerp
    // An entry and the next are one of an even and one of an odd number, each in a memory of half
    // the table. The last one's next is entry 0 here, of which nothing is added: from 255 levels on
    // x is 255, whose fraction is 0.
    logic [EntryW-1:0]  even, odd, entry1, next1;
    logic               odd1_q;
    logic [LumFrac-1:0] fraction1_q;
    ptm_memory_ram #(.Depth(Draws * 128), .Width(EntryW)) u_even (
      .clk_i(clk_i), .write_i(table_we_i && !table_addr_i[0]),
      .write_address_i(table_addr_i[9:1]), .write_data_i(table_data_i), .read_i(load1 && acts),
      .read_address_i({pixel_i.draw, index[7:1] + 7'(index[0])}), .read_data_o(even)
    );
    ptm_memory_ram #(.Depth(Draws * 128), .Width(EntryW)) u_odd (
      .clk_i(clk_i), .write_i(table_we_i && table_addr_i[0]),
      .write_address_i(table_addr_i[9:1]), .write_data_i(table_data_i), .read_i(load1 && acts),
      .read_address_i({pixel_i.draw, index[7:1]}), .read_data_o(odd)
    );
    always_ff @(posedge clk_i) begin
      if (load1 && acts) begin
        odd1_q      <= index[0];
        fraction1_q <= index == 8'd255 ? '0 : x[LumFrac-1:0];
      end
    end
    assign entry1 = odd1_q ? odd : even;
    assign next1  = odd1_q ? even : odd;
    logic signed [EntryW:0]         difference;
    logic signed [EntryW+LumFrac:0] product, moved;
    assign difference = signed'({1'b0, next1}) - signed'({1'b0, entry1});
    assign product    = (EntryW+LumFrac+1)'(difference) *
                        (EntryW+LumFrac+1)'(signed'({1'b0, fraction1_q}));
    ptm_arith_narrow #(
      .InBits(EntryW + LumFrac + 1), .AmountBits(3), .OutBits(EntryW + LumFrac + 1),
      .RoundNearest(RoundNearest)
    ) u_narrow (
      .x_i(product), .amount_i(3'(LumFrac)), .y_o(moved)
    );
    assign power = entry1 + moved[EntryW-1:0];
    logic unused_sign;
    assign unused_sign = ^moved[EntryW+LumFrac:EntryW];
  end

  // | product |
  logic [8:0]                ks;
  logic signed [9+EntryW:0]  product, narrowed;
  logic [AddendW-1:0]        specular;
  always_ff @(posedge clk_i) begin
    if (load2 && acts1_q) power2_q <= power;
  end
  ptm_registers_by_draw #(.Width(9)) u_ks (.values_i(ks_i), .draw_i(pixel2_q.draw), .value_o(ks));
  assign product = signed'({1'b0, (9+EntryW)'(ks) * (9+EntryW)'(power2_q)});
  ptm_arith_narrow #(
    .InBits(9 + EntryW + 1), .AmountBits(4), .OutBits(9 + EntryW + 1), .RoundNearest(RoundNearest)
  ) u_narrow (
    .x_i(product), .amount_i(4'd8), .y_o(narrowed)
  );
  assign specular = narrowed[AddendW-1:0];

  always_ff @(posedge clk_i) begin
    if (load1) begin
      pixel1_q  <= pixel_i;
      addend1_q <= addend_i;
      value1_q  <= value_i;
      acts1_q   <= acts;
    end
    if (load2) begin
      pixel2_q  <= pixel1_q;
      addend2_q <= addend1_q;
      value2_q  <= value1_q;
      acts2_q   <= acts1_q;
    end
    if (load3) begin
      pixel3_q  <= pixel2_q;
      addend3_q <= acts2_q ? {3{specular}} : addend2_q;
      value3_q  <= value2_q;
    end
  end
  assign pixel_o  = pixel3_q;
  assign addend_o = addend3_q;
  assign value_o  = value3_q;

  logic unused;
  assign unused = ^{argument_i, narrowed};
endmodule
