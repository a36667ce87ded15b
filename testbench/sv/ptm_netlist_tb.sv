// Drives an evaluator, as written or as a netlist, with vectors of `ptmsim vectors` and compares
// every pixel. Plain Verilog that iverilog and Verilator read; in iverilog, which is four-state, an X
// on an output is a difference.
//
// +vectors=FILE is the CSV of an LRGB run without its header. Operands are offered with gaps and
// pixels taken with stalls, both by $urandom. The last line says PASS or FAIL and counts.
`timescale 1ns / 1ps
// Its parameters are the evaluator's; ports depend on a few of them.
module ptm_netlist_tb #(
  `include "contract/ptm_evaluator_parameters.svh"
);
  localparam LightW = LightInt + LightFrac;
  localparam LumW   = LumBits + LumFrac;
  localparam Columns = 29;  // 18 operands, 3 colours, 2 lights, 6 results
  localparam Most   = 65536;

  reg                  clk = 0, rst_n = 0;
  reg                  valid = 0, take = 0;
  wire                 ready, offered, lum_saturated, color_saturated;
  reg  [6*CoefBits-1:0] coef, bias;
  reg  [29:0]          shift;
  reg  [23:0]          rgb;
  reg  [LightW-1:0]    lu, lv;
  wire [3*LumW-1:0]    lum;
  wire [23:0]          out;
  reg  [31:0]          id;
  wire [31:0]          out_id;

  ptm_evaluator u_dut (
    .clk_i(clk), .rst_ni(rst_n), .valid_i(valid), .ready_o(ready), .coef_i(coef), .bias_i(bias),
    .shift_i(shift), .rgb_i(rgb), .lu_i(lu), .lv_i(lv), .rgb_map_i(1'b0), .channel_i(2'd0),
    .sideband_i(id), .valid_o(offered), .ready_i(take), .lum_o(lum),
    .lum_saturated_o(lum_saturated), .rgb_o(out), .color_saturated_o(color_saturated),
    .sideband_o(out_id)
  );

  integer row [0:Most*Columns-1];
  integer rows, file, got, column, value, sent, taken, wrong, patience;
  reg [8*256-1:0] path;

  task operands;
    integer i;
    begin
      for (i = 0; i < 6; i = i + 1) begin
        coef[i*CoefBits +: CoefBits] = row[sent*Columns + i];
        bias[i*CoefBits +: CoefBits] = row[sent*Columns + 6 + i];
        shift[i*5 +: 5]              = row[sent*Columns + 12 + i];
      end
      for (i = 0; i < 3; i = i + 1) rgb[i*8 +: 8] = row[sent*Columns + 18 + i];
      lu = row[sent*Columns + 21];
      lv = row[sent*Columns + 22];
      id = sent;
    end
  endtask

  // Inputs change away from the rising edge; outputs are looked at just before it.
  initial begin
    if (!$value$plusargs("vectors=%s", path)) path = "vectors.csv";
    file = $fopen(path, "r");
    if (file == 0) begin
      $display("FAIL cannot open the vectors");
      $finish;
    end
    rows = 0;
    got  = 1;
    while (got == 1 && rows < Most) begin
      for (column = 0; column < Columns && got == 1; column = column + 1) begin
        if (column == Columns - 1) got = $fscanf(file, "%d\n", value);
        else got = $fscanf(file, "%d,", value);
        row[rows*Columns + column] = value;
      end
      if (got == 1) rows = rows + 1;
    end
    sent     = 0;
    taken    = 0;
    wrong    = 0;
    patience = 0;
    repeat (4) #5 clk = !clk;
    #1 rst_n = 1;
    while (taken < rows && patience < 1000) begin
      valid = sent < rows && ($urandom & 7) != 0;
      if (valid) operands;
      take = ($urandom & 3) != 0;
      #3;
      patience = patience + 1;
      if (valid && ready === 1'b1) begin
        sent     = sent + 1;
        patience = 0;
      end
      if (take && offered === 1'b1) begin
        if (out_id !== taken || lum[LumW-1:0] !== row[taken*Columns + 23] % (1 << LumW) ||
            lum_saturated !== (row[taken*Columns + 24] != 0) ||
            out[7:0] !== row[taken*Columns + 25] % 256 ||
            out[15:8] !== row[taken*Columns + 26] % 256 ||
            out[23:16] !== row[taken*Columns + 27] % 256 ||
            color_saturated !== (row[taken*Columns + 28] != 0)) begin
          if (wrong < 3) begin
            $display("vector %0d: luminance %b, colour %b, id %b", taken, lum[LumW-1:0], out, out_id);
          end
          wrong = wrong + 1;
        end
        taken    = taken + 1;
        patience = 0;
      end
      #2 clk = 1;
      #5 clk = 0;
    end
    if (rows > 0 && taken == rows && wrong == 0) $display("PASS %0d vectors", rows);
    else $display("FAIL %0d of %0d vectors differ, %0d taken", wrong, rows, taken);
    $finish;
  end
endmodule
