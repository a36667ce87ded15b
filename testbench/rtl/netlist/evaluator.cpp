// Drives a netlist of the evaluator in Verilator with vectors of `ptmsim vectors` and compares
// every pixel: the second simulator of scripts/synthesize, beside testbench/sv/ptm_netlist_tb.sv.
//
//   evaluator VECTORS.csv CoefBits LightInt+LightFrac LumBits+LumFrac
//
// VECTORS.csv has no header. Operands are offered with gaps and pixels taken with stalls. The last
// line says PASS or FAIL and counts; the exit code is 0 if nothing differs.
#include <array>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <random>
#include <string>
#include <vector>

#include "Vptm_evaluator.h"

namespace {

constexpr unsigned kColumns = 29;  // 18 operands, 3 colours, 2 lights, 6 results
using Row = std::array<std::int64_t, kColumns>;

std::vector<Row> read_rows(const char* path) {
  std::ifstream in(path);
  std::vector<Row> rows;
  for (std::string line; std::getline(in, line);) {
    Row row{};
    std::size_t at = 0;
    for (std::int64_t& value : row) {
      std::size_t used = 0;
      value = std::stoll(line.substr(at), &used);
      at += used + 1;
    }
    rows.push_back(row);
  }
  return rows;
}

std::uint64_t low_bits(std::int64_t value, unsigned width) {
  return static_cast<std::uint64_t>(value) & ((std::uint64_t{1} << width) - 1);
}

class Bench {
 public:
  Bench(unsigned coef_bits, unsigned light_bits, unsigned lum_bits)
      : coef_bits_(coef_bits), light_bits_(light_bits), lum_bits_(lum_bits) {
    dut_.rst_ni = 0;
    edge();
    dut_.rst_ni = 1;
  }

  /// Rows that differ, and how many were taken.
  std::pair<std::size_t, std::size_t> run(const std::vector<Row>& rows) {
    std::size_t sent = 0, taken = 0, wrong = 0;
    for (std::size_t quiet = 0; taken < rows.size() && quiet < 1000; ++quiet) {
      dut_.valid_i = sent < rows.size() && rng_() % 8 != 0;
      dut_.ready_i = rng_() % 4 != 0;
      if (dut_.valid_i) drive(rows[sent], sent);
      dut_.eval();
      if (dut_.valid_o && dut_.ready_i) {
        wrong += !equal(rows[taken], taken);
        ++taken;
        quiet = 0;
      }
      if (dut_.valid_i && dut_.ready_o) ++sent;
      edge();
    }
    return {wrong, taken};
  }

 private:
  void drive(const Row& row, std::size_t id) {
    // Six fields of up to 12 bits: more than 64 in all for the widest, so bit by bit.
    set_fields(dut_.coef_i, &row[0], 6, coef_bits_);
    set_fields(dut_.bias_i, &row[6], 6, coef_bits_);
    set_fields(dut_.shift_i, &row[12], 6, 5);
    set_fields(dut_.rgb_i, &row[18], 3, 8);
    set_fields(dut_.lu_i, &row[21], 1, light_bits_);
    set_fields(dut_.lv_i, &row[22], 1, light_bits_);
    dut_.sideband_i = static_cast<std::uint32_t>(id);
  }
  template <class Port>
  static void set_fields(Port& port, const std::int64_t* values, unsigned count, unsigned width) {
    port = 0;
    for (unsigned n = 0; n < count; ++n) {
      port = static_cast<Port>(port | low_bits(values[n], width) << (n * width));
    }
  }
  /// A port of more than 64 bits.
  template <std::size_t Words>
  static void set_fields(VlWide<Words>& port, const std::int64_t* values, unsigned count,
                         unsigned width) {
    for (std::size_t word = 0; word < Words; ++word) port[word] = 0;
    for (unsigned bit = 0; bit < count * width; ++bit) {
      const auto set =
          static_cast<std::uint32_t>(low_bits(values[bit / width], width) >> (bit % width) & 1);
      port[bit / 32] |= set << bit % 32;
    }
  }

  /// Channel 0 of a map's luminance is the pixel's, of an LRGB map.
  bool equal(const Row& row, std::size_t id) const {
    return dut_.sideband_o == static_cast<std::uint32_t>(id) &&
           low_bits(static_cast<std::int64_t>(dut_.lum_o), lum_bits_) ==
               low_bits(row[23], lum_bits_) &&
           dut_.lum_saturated_o == (row[24] != 0) &&
           dut_.rgb_o == (row[25] | row[26] << 8 | row[27] << 16) &&
           dut_.color_saturated_o == (row[28] != 0);
  }

  void edge() {
    dut_.clk_i = 0;
    dut_.eval();
    dut_.clk_i = 1;
    dut_.eval();
    dut_.clk_i = 0;
  }

  unsigned coef_bits_, light_bits_, lum_bits_;
  std::mt19937_64 rng_{1};
  Vptm_evaluator dut_;
};

}  // namespace

double sc_time_stamp() { return 0; }

int main(int count, char** arguments) {
  if (count != 5) {
    std::cerr << "usage: evaluator VECTORS.csv COEF-BITS LIGHT-BITS LUM-BITS\n";
    return 2;
  }
  const auto rows = read_rows(arguments[1]);
  const auto width = [&](int n) { return static_cast<unsigned>(std::stoul(arguments[n])); };
  Bench bench(width(2), width(3), width(4));
  const auto [wrong, taken] = bench.run(rows);
  const bool pass = !rows.empty() && taken == rows.size() && wrong == 0;
  if (pass) {
    std::cout << "PASS " << taken << " vectors\n";
  } else {
    std::cout << "FAIL " << wrong << " of " << rows.size() << " vectors differ, " << taken
              << " taken\n";
  }
  return pass ? 0 : 1;
}
