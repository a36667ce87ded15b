// Drives a unit in a four-state simulator (Icarus Verilog) from a file, and compares what it gives,
// X included. One command a line, numbers in hexadecimal; tests/rtl/four_state.h writes them.
//
//   R                    reset of the unit and the memory
//   S                    reset of the unit alone
//   I cycles             cycles in which nothing is offered
//   W address data       a register is written
//   Q address data       a register is read: no cycle
//   C inputs outputs     a cycle, outputs before its edge; in the order of `command` below
//
// Prints "replayed" at the end if nothing differed. plusarg: +trace=FILE. No design logic.
module ptm_unit_replay_tb;
  reg         clk, rst_n, mem_rst_n, reg_we;
  reg  [15:0] reg_addr;
  reg  [31:0] reg_wdata;
  wire [31:0] reg_rdata;
  reg         frag_valid, frag_lit, pix_ready, req_ready, rsp_valid, rsp_error;
  reg  [13:0] frag_x, frag_y;
  reg  [28:0] frag_u, frag_v, frag_axis_u, frag_axis_v;
  reg  [11:0] frag_lod;
  reg  [2:0]  frag_probes_log2;
  reg  [16:0] frag_lu, frag_lv, frag_hu, frag_hv;
  reg  [1:0]  frag_draw;
  reg  [7:0]  rsp_tag;
  reg [511:0] rsp_line;
  wire        irq, frag_ready, req_valid, pix_valid, pix_lum, pix_color, pix_error;
  wire [25:0] req_line;
  wire [7:0]  req_tag, pix_alpha;
  wire [13:0] pix_x, pix_y;
  wire [23:0] pix_rgb;

  ptm_unit dut (
    .clk_i(clk), .rst_ni(rst_n), .mem_rst_ni(mem_rst_n), .reg_we_i(reg_we), .reg_addr_i(reg_addr),
    .reg_wdata_i(reg_wdata), .reg_rdata_o(reg_rdata), .irq_o(irq), .frag_valid_i(frag_valid),
    .frag_ready_o(frag_ready), .frag_x_i(frag_x), .frag_y_i(frag_y), .frag_u_i(frag_u),
    .frag_v_i(frag_v), .frag_lod_i(frag_lod), .frag_axis_u_i(frag_axis_u),
    .frag_axis_v_i(frag_axis_v), .frag_probes_log2_i(frag_probes_log2), .frag_lu_i(frag_lu),
    .frag_lv_i(frag_lv), .frag_hu_i(frag_hu), .frag_hv_i(frag_hv), .frag_lit_i(frag_lit),
    .frag_draw_i(frag_draw), .mem_req_valid_o(req_valid), .mem_req_ready_i(req_ready),
    .mem_req_line_o(req_line), .mem_req_tag_o(req_tag), .mem_rsp_valid_i(rsp_valid),
    .mem_rsp_tag_i(rsp_tag), .mem_rsp_line_i(rsp_line), .mem_rsp_error_i(rsp_error),
    .pix_valid_o(pix_valid),
    .pix_ready_i(pix_ready), .pix_x_o(pix_x), .pix_y_o(pix_y), .pix_rgb_o(pix_rgb),
    .pix_alpha_o(pix_alpha), .pix_lum_saturated_o(pix_lum), .pix_color_saturated_o(pix_color),
    .pix_mem_error_o(pix_error)
  );

  integer file, got, line_number, wrong, cycles;
  reg [8*8-1:0]    command;
  reg [8*1024-1:0] name;
  reg [31:0]       number, value;
  reg        x_frag_ready, x_req_valid, x_pix_valid, x_lum, x_color, x_error, x_irq;
  reg [25:0] x_line;
  reg [7:0]  x_tag, x_alpha;
  reg [13:0] x_x, x_y;
  reg [23:0] x_rgb;

  task idle;
    begin
      {frag_valid, pix_ready, rsp_valid, reg_we} = 4'd0;
      req_ready = 1'b1;
    end
  endtask
  task edge_of_clock;
    begin
      #1;
      if (rst_n && (^{frag_ready, req_valid, pix_valid, irq, reg_rdata}) === 1'bx)
        complain("a handshake or a register is X");
      clk = 1'b1;
      #1;
      clk = 1'b0;
      cycles = cycles + 1;
    end
  endtask
  task complain(input [8*64-1:0] what);
    begin
      wrong = wrong + 1;
      if (wrong <= 10) $display("line %0d, cycle %0d: %0s", line_number, cycles, what);
    end
  endtask

  initial begin
    clk = 1'b0;
    rst_n = 1'b1;
    mem_rst_n = 1'b1;
    idle;
    reg_addr = 16'd0;
    reg_wdata = 32'd0;
    {frag_x, frag_y, frag_u, frag_v, frag_axis_u, frag_axis_v, frag_lod, frag_probes_log2} = 0;
    {frag_lu, frag_lv, frag_hu, frag_hv, frag_draw, frag_lit, rsp_tag, rsp_error, rsp_line} = 0;
    line_number = 0;
    wrong = 0;
    cycles = 0;
    if (!$value$plusargs("trace=%s", name)) $finish;
    file = $fopen(name, "r");
    got = file != 0 ? $fscanf(file, "%s", command) : 0;
    while (got == 1) begin
      line_number = line_number + 1;
      case (command[7:0])
        "R", "S": begin
          idle;
          rst_n = 1'b0;
          mem_rst_n = command[7:0] == "S";
          #1;
          clk = 1'b1;
          #1;
          clk = 1'b0;
          #1;
          mem_rst_n = 1'b1;
          rst_n = 1'b1;
          // What the caller need not drive may be anything.
          {frag_x, frag_y, frag_u, frag_v, frag_axis_u, frag_axis_v} = {146{1'bx}};
          {frag_lod, frag_probes_log2, frag_lu, frag_lv, frag_hu, frag_hv} = {83{1'bx}};
          {frag_draw, frag_lit, rsp_tag, rsp_error, reg_wdata} = {44{1'bx}};
          rsp_line = {512{1'bx}};
        end
        "I": begin
          got = $fscanf(file, "%h", number);
          idle;
          while (number != 0) begin
            edge_of_clock;
            number = number - 1;
          end
        end
        "W": begin
          got = $fscanf(file, "%h %h", reg_addr, reg_wdata);
          idle;
          reg_we = 1'b1;
          edge_of_clock;
          reg_we = 1'b0;
          reg_wdata = {32{1'bx}};
        end
        "Q": begin
          got = $fscanf(file, "%h %h", reg_addr, value);
          #1;
          if (reg_rdata !== value) begin
            complain("a register differs");
            if (wrong <= 10) $display("  %h: %h, expected %h", reg_addr, reg_rdata, value);
          end
        end
        "C": begin
          got = $fscanf(file, "%h %h %h %h %h %h %h %h %h", frag_valid, frag_x, frag_y, frag_u,
                        frag_v, frag_lod, frag_axis_u, frag_axis_v, frag_probes_log2);
          got = $fscanf(file, "%h %h %h %h %h %h", frag_lu, frag_lv, frag_hu, frag_hv, frag_lit,
                        frag_draw);
          got = $fscanf(file, "%h %h %h %h %h %h", pix_ready, req_ready, rsp_valid, rsp_tag,
                        rsp_error, rsp_line);
          got = $fscanf(file, "%h %h %h %h", x_frag_ready, x_req_valid, x_line, x_tag);
          got = $fscanf(file, "%h %h %h %h %h %h %h %h %h", x_pix_valid, x_x, x_y, x_rgb, x_alpha,
                        x_lum, x_color, x_error, x_irq);
          if (got != 9) complain("this line cannot be read");
          if (!frag_valid) begin
            {frag_x, frag_y, frag_u, frag_v, frag_axis_u, frag_axis_v} = {146{1'bx}};
            {frag_lod, frag_probes_log2, frag_lu, frag_lv, frag_hu, frag_hv} = {83{1'bx}};
            {frag_draw, frag_lit} = 3'bxxx;
          end
          if (!rsp_valid) {rsp_tag, rsp_error, rsp_line} = {521{1'bx}};
          #1;
          if (frag_ready !== x_frag_ready) complain("the fragments' ready differs");
          if (req_valid !== x_req_valid) complain("the requests' valid differs");
          if (x_req_valid && {req_line, req_tag} !== {x_line, x_tag}) begin
            complain("a request differs");
            if (wrong <= 10)
              $display("  line %h tag %h, expected %h %h", req_line, req_tag, x_line, x_tag);
          end
          if (irq !== x_irq) complain("the interrupt differs");
          if (pix_valid !== x_pix_valid) complain("the pixels' valid differs");
          if (x_pix_valid && {pix_x, pix_y, pix_rgb, pix_alpha, pix_lum, pix_color, pix_error} !==
              {x_x, x_y, x_rgb, x_alpha, x_lum, x_color, x_error}) begin
            complain("a pixel differs");
            if (wrong <= 10)
              $display("  (%h, %h) rgb %h alpha %h flags %b%b%b, expected (%h, %h) %h %h %b%b%b",
                       pix_x, pix_y, pix_rgb, pix_alpha, pix_lum, pix_color, pix_error, x_x, x_y,
                       x_rgb, x_alpha, x_lum, x_color, x_error);
          end
          edge_of_clock;
        end
        default: complain("no command");
      endcase
      if (wrong > 100) $finish;
      got = $fscanf(file, "%s", command);
    end
    $display("%0d cycles", cycles);
    if (wrong == 0 && cycles > 100) $display("replayed");
    $finish;
  end
endmodule
