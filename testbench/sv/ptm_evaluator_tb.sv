// The evaluator behind ports that have the same C++ types for every variant, with a probe that
// reads any stage register or constant. No design logic.
//
// probe_i chooses what probe_o shows; the numbers are those of testbench/rtl/probe.h. The probe
// costs one comparison a cycle while it is 0.
//
// Every change of clk_i is one clock cycle: the rising edge of clk flips phase_q, which takes clk
// back at once. So a cycle costs one evaluation of the Verilated model instead of two.
module ptm_evaluator_tb #(
  `include "contract/ptm_evaluator_parameters.svh"
) (
  input  logic               clk_i,  // a cycle each time it changes
  input  logic               rst_ni,
  input  logic               valid_i,
  output logic               ready_o,
  input  logic        [15:0] coef_i [6],
  input  logic        [15:0] bias_i [6],
  input  logic signed [7:0]  shift_i [6],
  input  logic        [15:0] rgb_i [3],
  input  logic signed [31:0] lu_i,
  input  logic signed [31:0] lv_i,
  input  logic               rgb_map_i,
  input  logic        [1:0]  channel_i,
  input  logic        [31:0] sideband_i,
  output logic               valid_o,
  input  logic               ready_i,
  output logic        [15:0] lum_o [3],
  output logic               lum_saturated_o,
  output logic        [7:0]  rgb_o [3],
  output logic               color_saturated_o,
  output logic        [31:0] sideband_o,
  input  logic        [7:0]  probe_i,
  output logic signed [63:0] probe_o
);
  localparam int StoredW  = ptm_pkg::stored_bits(CoefBits, FilterFrac);
  localparam int LightW   = ptm_pkg::light_bits(LightInt, LightFrac);
  localparam int RgbW     = ptm_pkg::rgb_bits(FilterFrac);
  localparam int LumW     = ptm_pkg::lum_bits(LumBits, LumFrac);
  localparam int ProbeW   = $bits(probe_o);
  localparam int ProductW = ptm_pkg::color_product_bits(LumBits, LumFrac, FilterFrac);

  logic clk, phase_q;
  initial phase_q = 1'b0;
  assign clk = clk_i ^ phase_q;
  always_ff @(posedge clk) phase_q <= !phase_q;

  logic [6*StoredW-1:0] coef;
  logic [6*CoefBits-1:0] bias;
  logic [6*ptm_pkg::ShiftBits-1:0] shift;
  logic [3*RgbW-1:0] rgb_operand;
  for (genvar i = 0; i < 6; i++) begin : gen_six
    assign coef[i*StoredW +: StoredW]                      = coef_i[i][StoredW-1:0];
    assign bias[i*CoefBits +: CoefBits]                    = bias_i[i][CoefBits-1:0];
    assign shift[i*ptm_pkg::ShiftBits +: ptm_pkg::ShiftBits] = shift_i[i][ptm_pkg::ShiftBits-1:0];
  end
  logic [3*LumW-1:0] lum;
  logic [23:0] rgb;
  for (genvar c = 0; c < 3; c++) begin : gen_three
    assign rgb_operand[c*RgbW +: RgbW] = rgb_i[c][RgbW-1:0];
    assign lum_o[c]                    = 16'(lum[c*LumW +: LumW]);
    assign rgb_o[c]                    = rgb[c*8 +: 8];
  end

  ptm_evaluator #(
    `include "contract/ptm_evaluator_map.svh"
    ,
    .SidebandBits(32)
  ) u_dut (
    .clk_i            (clk),
    .rst_ni           (rst_ni),
    .valid_i          (valid_i),
    .ready_o          (ready_o),
    .coef_i           (coef),
    .bias_i           (bias),
    .shift_i          (shift),
    .rgb_i            (rgb_operand),
    .lu_i             (lu_i[LightW-1:0]),
    .lv_i             (lv_i[LightW-1:0]),
    .rgb_map_i        (rgb_map_i),
    .channel_i        (channel_i),
    .sideband_i       (sideband_i),
    .valid_o          (valid_o),
    .ready_i          (ready_i),
    .lum_o            (lum),
    .lum_saturated_o  (lum_saturated_o),
    .rgb_o            (rgb),
    .color_saturated_o(color_saturated_o),
    .sideband_o       (sideband_o)
  );

  always_comb begin
    probe_o = 64'sd0;
    if (probe_i != 8'd0) begin
      unique0 case (probe_i)
        // Stage registers
        8'd1: probe_o = 64'(u_dut.r1_d0_q);
        8'd2: probe_o = 64'(u_dut.r1_d1_q);
        8'd3: probe_o = 64'(u_dut.r1_d2_q);
        8'd4: probe_o = 64'(u_dut.r1_d3_q);
        8'd5: probe_o = 64'(u_dut.r1_d4_q);
        8'd6: probe_o = 64'(u_dut.r1_d5_q);
        8'd7: probe_o = 64'(u_dut.r1_uu_q);
        8'd8: probe_o = 64'(u_dut.r1_vv_q);
        8'd9: probe_o = 64'(u_dut.r1_uv_q);
        8'd10: probe_o = 64'(u_dut.r2_p0_q);
        8'd11: probe_o = 64'(u_dut.r2_p1_q);
        8'd12: probe_o = 64'(u_dut.r2_p2_q);
        8'd13: probe_o = 64'(u_dut.r2_p3_q);
        8'd14: probe_o = 64'(u_dut.r2_p4_q);
        8'd15: probe_o = 64'(u_dut.r2_p5_q);
        8'd16: probe_o = 64'(u_dut.r3_t0_q);
        8'd17: probe_o = 64'(u_dut.r3_t1_q);
        8'd18: probe_o = 64'(u_dut.r3_t2_q);
        8'd19: probe_o = 64'(u_dut.r3_t3_q);
        8'd20: probe_o = 64'(u_dut.r3_t4_q);
        8'd21: probe_o = 64'(u_dut.r3_t5_q);
        8'd22: probe_o = 64'(u_dut.r4_acc_q);
        8'd23: probe_o = 64'(u_dut.r5_lum_q);
        8'd24: probe_o = 64'(u_dut.r5_lum_saturated_q);
        8'd25: probe_o = 64'(u_dut.r6_red_q);
        8'd26: probe_o = 64'(u_dut.r6_green_q);
        8'd27: probe_o = 64'(u_dut.r6_blue_q);
        8'd28: probe_o = 64'(u_dut.r7_rgb_q[0*8 +: 8]);
        8'd29: probe_o = 64'(u_dut.r7_rgb_q[1*8 +: 8]);
        8'd30: probe_o = 64'(u_dut.r7_rgb_q[2*8 +: 8]);
        8'd31: probe_o = 64'(u_dut.r7_color_saturated_q);
        // Derived widths, in order of EvalWidths
        8'd64: probe_o = 64'(ptm_pkg::stored_bits(CoefBits, FilterFrac));
        8'd65: probe_o = 64'(ptm_pkg::delta_bits(DeltaBits, FilterFrac));
        8'd66: probe_o = 64'(ptm_pkg::light_bits(LightInt, LightFrac));
        8'd67: probe_o = 64'(ptm_pkg::basis_bits(LightInt, BasisFrac));
        8'd68: probe_o =
            64'(ptm_pkg::product_bits(0, DeltaBits, LightInt, LightFrac, BasisFrac, FilterFrac));
        8'd69: probe_o =
            64'(ptm_pkg::product_bits(1, DeltaBits, LightInt, LightFrac, BasisFrac, FilterFrac));
        8'd70: probe_o =
            64'(ptm_pkg::product_bits(2, DeltaBits, LightInt, LightFrac, BasisFrac, FilterFrac));
        8'd71: probe_o =
            64'(ptm_pkg::product_bits(3, DeltaBits, LightInt, LightFrac, BasisFrac, FilterFrac));
        8'd72: probe_o =
            64'(ptm_pkg::product_bits(4, DeltaBits, LightInt, LightFrac, BasisFrac, FilterFrac));
        8'd73: probe_o =
            64'(ptm_pkg::product_bits(5, DeltaBits, LightInt, LightFrac, BasisFrac, FilterFrac));
        8'd74: probe_o = 64'(ptm_pkg::frac_bits(0, LightFrac, BasisFrac, FilterFrac));
        8'd75: probe_o = 64'(ptm_pkg::frac_bits(1, LightFrac, BasisFrac, FilterFrac));
        8'd76: probe_o = 64'(ptm_pkg::frac_bits(2, LightFrac, BasisFrac, FilterFrac));
        8'd77: probe_o = 64'(ptm_pkg::frac_bits(3, LightFrac, BasisFrac, FilterFrac));
        8'd78: probe_o = 64'(ptm_pkg::frac_bits(4, LightFrac, BasisFrac, FilterFrac));
        8'd79: probe_o = 64'(ptm_pkg::frac_bits(5, LightFrac, BasisFrac, FilterFrac));
        8'd80: probe_o =
            64'(ptm_pkg::pre_shift(0, LightFrac, BasisFrac, Guard, ShiftMin, FilterFrac));
        8'd81: probe_o =
            64'(ptm_pkg::pre_shift(1, LightFrac, BasisFrac, Guard, ShiftMin, FilterFrac));
        8'd82: probe_o =
            64'(ptm_pkg::pre_shift(2, LightFrac, BasisFrac, Guard, ShiftMin, FilterFrac));
        8'd83: probe_o =
            64'(ptm_pkg::pre_shift(3, LightFrac, BasisFrac, Guard, ShiftMin, FilterFrac));
        8'd84: probe_o =
            64'(ptm_pkg::pre_shift(4, LightFrac, BasisFrac, Guard, ShiftMin, FilterFrac));
        8'd85: probe_o =
            64'(ptm_pkg::pre_shift(5, LightFrac, BasisFrac, Guard, ShiftMin, FilterFrac));
        8'd86: probe_o =
            64'(ptm_pkg::amount_max(0, LightFrac, BasisFrac, Guard, ShiftMin, FilterFrac));
        8'd87: probe_o =
            64'(ptm_pkg::amount_max(1, LightFrac, BasisFrac, Guard, ShiftMin, FilterFrac));
        8'd88: probe_o =
            64'(ptm_pkg::amount_max(2, LightFrac, BasisFrac, Guard, ShiftMin, FilterFrac));
        8'd89: probe_o =
            64'(ptm_pkg::amount_max(3, LightFrac, BasisFrac, Guard, ShiftMin, FilterFrac));
        8'd90: probe_o =
            64'(ptm_pkg::amount_max(4, LightFrac, BasisFrac, Guard, ShiftMin, FilterFrac));
        8'd91: probe_o =
            64'(ptm_pkg::amount_max(5, LightFrac, BasisFrac, Guard, ShiftMin, FilterFrac));
        8'd92: probe_o = 64'($bits(u_dut.r3_t0_q));
        8'd93: probe_o = 64'($bits(u_dut.r4_acc_q));
        8'd94: probe_o = 64'($bits(u_dut.r5_lum_q));
        8'd95: probe_o = 64'(ProductW);
        // Parameters, in order of rtl_parameters()
        `include "contract/ptm_evaluator_probe.svh"
        default: probe_o = 64'sd0;
      endcase
    end
  end
endmodule
