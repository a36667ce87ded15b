// Replays a recording of the unit's pins on its netlist in Verilator: the second simulator of
// scripts/synthesize, beside testbench/sv/ptm_unit_replay_tb.sv, whose header describes the file.
//
//   unit RECORDING
//
// Prints "replayed" at the end if nothing differed; the exit code is then 0.
#include <cstdint>
#include <fstream>
#include <iostream>
#include <string>

#include "Vptm_unit.h"

namespace {

class Replay {
 public:
  explicit Replay(const char* path) : in_(path) { in_ >> std::hex; }

  bool run() {
    for (std::string command; in_ >> command; ++line_) {
      if (command == "R" || command == "S") {
        reset(command == "S");
      } else if (command == "I") {
        idle();
        for (std::uint64_t left = number(); left != 0; --left) edge();
      } else if (command == "W") {
        idle();
        take(dut_.reg_addr_i);
        take(dut_.reg_wdata_i);
        dut_.reg_we_i = 1;
        edge();
        dut_.reg_we_i = 0;
      } else if (command == "Q") {
        take(dut_.reg_addr_i);
        dut_.eval();
        expect("register", dut_.reg_rdata_o, number());
      } else if (command == "C") {
        cycle();
      } else {
        expect("command", 0, 1);
      }
      if (wrong_ > 10) break;
    }
    std::cout << std::dec << cycles_ << " cycles\n";
    return wrong_ == 0 && cycles_ > 100;
  }

 private:
  std::uint64_t number() {
    std::uint64_t value = 0;
    if (!(in_ >> value)) ++wrong_;
    return value;
  }
  template <class Port>
  void take(Port& port) {
    port = static_cast<Port>(number());
  }

  void idle() {
    dut_.frag_valid_i = dut_.pix_ready_i = dut_.mem_rsp_valid_i = dut_.reg_we_i = 0;
    dut_.mem_req_ready_i = 1;
  }
  void reset(bool unit_alone) {
    idle();
    dut_.rst_ni = 0;
    dut_.mem_rst_ni = unit_alone;
    edge();
    dut_.rst_ni = dut_.mem_rst_ni = 1;
    dut_.eval();
  }

  void cycle() {
    take(dut_.frag_valid_i), take(dut_.frag_x_i), take(dut_.frag_y_i), take(dut_.frag_u_i);
    take(dut_.frag_v_i), take(dut_.frag_lod_i), take(dut_.frag_axis_u_i);
    take(dut_.frag_axis_v_i), take(dut_.frag_probes_log2_i), take(dut_.frag_lu_i);
    take(dut_.frag_lv_i), take(dut_.frag_hu_i), take(dut_.frag_hv_i), take(dut_.frag_lit_i);
    take(dut_.frag_draw_i), take(dut_.pix_ready_i), take(dut_.mem_req_ready_i);
    take(dut_.mem_rsp_valid_i), take(dut_.mem_rsp_tag_i), take(dut_.mem_rsp_error_i);
    std::string line;
    in_ >> line;  // 512 bits, the highest first
    line.insert(0, 128 - std::min<std::size_t>(128, line.size()), '0');
    for (unsigned word = 0; word < 16; ++word) {
      dut_.mem_rsp_line_i[word] =
          static_cast<std::uint32_t>(std::stoul(line.substr(8 * (15 - word), 8), nullptr, 16));
    }
    dut_.eval();
    expect("fragments' ready", dut_.frag_ready_o, number());
    const std::uint64_t request = number();
    expect("request", dut_.mem_req_valid_o, request);
    expect("request's line", dut_.mem_req_line_o, number(), request != 0);
    expect("request's tag", dut_.mem_req_tag_o, number(), request != 0);
    const std::uint64_t pixel = number();
    expect("pixel", dut_.pix_valid_o, pixel);
    expect("pixel's x", dut_.pix_x_o, number(), pixel != 0);
    expect("pixel's y", dut_.pix_y_o, number(), pixel != 0);
    expect("pixel's colour", dut_.pix_rgb_o, number(), pixel != 0);
    expect("pixel's alpha", dut_.pix_alpha_o, number(), pixel != 0);
    expect("luminance's flag", dut_.pix_lum_saturated_o, number(), pixel != 0);
    expect("colour's flag", dut_.pix_color_saturated_o, number(), pixel != 0);
    expect("memory's flag", dut_.pix_mem_error_o, number(), pixel != 0);
    expect("interrupt", dut_.irq_o, number());
    edge();
  }

  void expect(const char* what, std::uint64_t got, std::uint64_t expected, bool asked = true) {
    if (!asked || got == expected) return;
    ++wrong_;
    std::cout << std::hex << "line " << line_ << ": " << what << " is " << got << ", expected "
              << expected << '\n';
  }

  void edge() {
    dut_.eval();
    dut_.clk_i = 1;
    dut_.eval();
    dut_.clk_i = 0;
    dut_.eval();
    ++cycles_;
  }

  std::ifstream in_;
  std::uint64_t line_ = 1, cycles_ = 0, wrong_ = 0;
  Vptm_unit dut_;
};

}  // namespace

double sc_time_stamp() { return 0; }

int main(int count, char** arguments) {
  if (count != 2) {
    std::cerr << "usage: unit RECORDING\n";
    return 2;
  }
  Replay replay(arguments[1]);
  if (!replay.run()) return 1;
  std::cout << "replayed\n";
  return 0;
}
