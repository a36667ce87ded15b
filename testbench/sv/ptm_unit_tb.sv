// The texture unit behind ports that have the same C++ types for every variant, with a probe into
// what stands at K. No design logic.
//
// probe_i chooses what probe_o shows; the numbers are those of testbench/rtl/unit_probe.h. The
// probe costs one comparison a cycle while it is 0.
//
// Every change of clk_i is one clock cycle: the rising edge of clk flips phase_q, which takes clk
// back at once. So a cycle costs one evaluation of the Verilated model instead of two.
module ptm_unit_tb #(
  `include "contract/ptm_unit_parameters.svh"
) (
  input  logic               clk_i,  // a cycle each time it changes
  input  logic               rst_ni,
  input  logic               mem_rst_ni,
  input  logic               reg_we_i,
  input  logic        [15:0] reg_addr_i,
  input  logic        [31:0] reg_wdata_i,
  output logic        [31:0] reg_rdata_o,
  output logic               irq_o,
  input  logic               frag_valid_i,
  output logic               frag_ready_o,
  input  logic        [15:0] frag_x_i,
  input  logic        [15:0] frag_y_i,
  input  logic signed [31:0] frag_u_i,
  input  logic signed [31:0] frag_v_i,
  input  logic        [15:0] frag_lod_i,
  input  logic signed [31:0] frag_axis_u_i,
  input  logic signed [31:0] frag_axis_v_i,
  input  logic        [7:0]  frag_probes_log2_i,
  input  logic signed [31:0] frag_lu_i,
  input  logic signed [31:0] frag_lv_i,
  input  logic signed [31:0] frag_hu_i,
  input  logic signed [31:0] frag_hv_i,
  input  logic               frag_lit_i,
  input  logic        [7:0]  frag_draw_i,
  output logic               mem_req_valid_o,
  input  logic               mem_req_ready_i,
  output logic        [31:0] mem_req_line_o,
  output logic        [7:0]  mem_req_tag_o,
  input  logic               mem_rsp_valid_i,
  input  logic        [7:0]  mem_rsp_tag_i,
  input  logic       [511:0] mem_rsp_line_i,
  input  logic               mem_rsp_error_i,
  output logic               pix_valid_o,
  input  logic               pix_ready_i,
  output logic        [15:0] pix_x_o,
  output logic        [15:0] pix_y_o,
  output logic        [31:0] pix_rgba_o,  // red lowest
  output logic               pix_lum_saturated_o,
  output logic               pix_color_saturated_o,
  output logic               pix_mem_error_o,
  input  logic        [7:0]  probe_i,
  output logic        [31:0] probe_o
);
  logic clk, phase_q;
  initial phase_q = 1'b0;
  assign clk = clk_i ^ phase_q;
  always_ff @(posedge clk) phase_q <= !phase_q;

  logic [25:0] line;
  logic [13:0] x, y;
  assign mem_req_line_o = 32'(line);
  assign pix_x_o        = 16'(x);
  assign pix_y_o        = 16'(y);

  ptm_unit #(
    `include "contract/ptm_unit_map.svh"
  ) u_dut (
    .clk_i                (clk),
    .rst_ni               (rst_ni),
    .mem_rst_ni           (mem_rst_ni),
    .reg_we_i             (reg_we_i),
    .reg_addr_i           (reg_addr_i),
    .reg_wdata_i          (reg_wdata_i),
    .reg_rdata_o          (reg_rdata_o),
    .irq_o                (irq_o),
    .frag_valid_i         (frag_valid_i),
    .frag_ready_o         (frag_ready_o),
    .frag_x_i             (frag_x_i[13:0]),
    .frag_y_i             (frag_y_i[13:0]),
    .frag_u_i             (frag_u_i[28:0]),
    .frag_v_i             (frag_v_i[28:0]),
    .frag_lod_i           (frag_lod_i[11:0]),
    .frag_axis_u_i        (frag_axis_u_i[28:0]),
    .frag_axis_v_i        (frag_axis_v_i[28:0]),
    .frag_probes_log2_i   (frag_probes_log2_i[2:0]),
    .frag_lu_i            (frag_lu_i[16:0]),
    .frag_lv_i            (frag_lv_i[16:0]),
    .frag_hu_i            (frag_hu_i[16:0]),
    .frag_hv_i            (frag_hv_i[16:0]),
    .frag_lit_i           (frag_lit_i),
    .frag_draw_i          (frag_draw_i[1:0]),
    .mem_req_valid_o      (mem_req_valid_o),
    .mem_req_ready_i      (mem_req_ready_i),
    .mem_req_line_o       (line),
    .mem_req_tag_o        (mem_req_tag_o),
    .mem_rsp_valid_i      (mem_rsp_valid_i),
    .mem_rsp_tag_i        (mem_rsp_tag_i),
    .mem_rsp_line_i       (mem_rsp_line_i),
    .mem_rsp_error_i      (mem_rsp_error_i),
    .pix_valid_o          (pix_valid_o),
    .pix_ready_i          (pix_ready_i),
    .pix_x_o              (x),
    .pix_y_o              (y),
    .pix_rgb_o            (pix_rgba_o[23:0]),
    .pix_alpha_o          (pix_rgba_o[31:24]),
    .pix_lum_saturated_o  (pix_lum_saturated_o),
    .pix_color_saturated_o(pix_color_saturated_o),
    .pix_mem_error_o      (pix_mem_error_o)
  );

  localparam int ProbeW = $bits(probe_o);

  // The miss ring's oldest line
  localparam int RingRows    = (MissFifo + 3) / 4;
  localparam int RingRowBits = RingRows == 1 ? 1 : $clog2(RingRows);
  logic [1:0]             head_bank;
  logic [RingRowBits-1:0] head_row;
  logic [RingRowBits-1:0] bank_row [4];
  logic [25:0]            head_line [4];
  assign head_bank = u_dut.u_front.u_miss_ring.head_q;
  assign head_row  = bank_row[head_bank];
  for (genvar b = 0; b < 4; b++) begin : gen_head
    assign bank_row[b] = u_dut.u_front.u_miss_ring.gen_line[b].u_bank.row_q;
    always_comb begin
      head_line[b] = '0;
      if (probe_i == 8'd5) begin
        head_line[b] = u_dut.u_front.u_miss_ring.gen_address[b].u_address.word_q[bank_row[b]];
      end
    end
  end

  always_comb begin
    probe_o = 32'd0;
    if (probe_i != 8'd0) begin
      unique0 case (probe_i)
        8'd1: probe_o = 32'(u_dut.u_front.k_holds);
        8'd2: probe_o = 32'(u_dut.u_front.k_beat.x);
        8'd3: probe_o = 32'(u_dut.u_front.k_beat.y);
        // The slot of the first line that K has not committed, and its address
        8'd4: probe_o = 32'({head_row, head_bank});
        8'd5: probe_o = 32'(head_line[head_bank]);
        // Parameters, in order of rtl_parameters() and of UnitConfig
        `include "contract/ptm_unit_probe.svh"
        default: probe_o = 32'd0;
      endcase
    end
  end
endmodule
