#include "testbench/prove/symbolic.h"

#include <gtest/gtest.h>

#include <fstream>
#include <random>
#include <sstream>

#include "model/reference/evaluate.h"
#include "testbench/rtl/command.h"
#include "tests/scratch_folder.h"

namespace ptm::testbench {
namespace {

using reference::for_six;
using reference::LrgbOperands;

TEST(Range, TakesTheBitsOfItsFartherEnd) {
  EXPECT_EQ(signed_bits({0, 0}), 1);
  EXPECT_EQ(signed_bits({-1, 0}), 1);
  EXPECT_EQ(signed_bits({0, 1}), 2);
  EXPECT_EQ(signed_bits({-128, 127}), 8);
  EXPECT_EQ(signed_bits({-129, 0}), 9);
  EXPECT_EQ(signed_bits({0, 128}), 9);
  EXPECT_EQ(signed_bits(signed_range(62)), 62);
  EXPECT_EQ(signed_bits(unsigned_range(61)), 62);
}

TEST(Symbolic, FoldsConstants) {
  const Symbolic a{5}, b{-3};
  EXPECT_EQ((a + b).range(), (Range{2, 2}));
  EXPECT_EQ((a - b).range(), (Range{8, 8}));
  EXPECT_EQ((a * b).range(), (Range{-15, -15}));
  EXPECT_EQ(shift_right(b, Value{1}).range(), (Range{-2, -2}));
  EXPECT_EQ(smaller(a, b).range(), (Range{-3, -3}));
  EXPECT_EQ(larger(a, b).range(), (Range{5, 5}));
  EXPECT_EQ(differs(a, b).range(), (Range{1, 1}));
  EXPECT_EQ(half_of(Symbolic{4}).range(), (Range{8, 8}));
  EXPECT_EQ(half_of(Symbolic{0}).range(), (Range{0, 0}));
}

TEST(Symbolic, RefusesWhatDoesNotFitSixtyTwoBits) {
  Netlist netlist;
  const Symbolic wide = netlist.input("wide", 40, true);
  EXPECT_THROW((void)(wide * wide), std::overflow_error);
  EXPECT_THROW((void)shift_right(wide, netlist.input("amount", 3, true)), std::overflow_error);
  EXPECT_THROW((void)shift_left(wide, 30), std::overflow_error);
}

/// Operands of an LRGB pixel, each from one call of `make`(name, bits, is signed, range).
template <class Int, class Make>
LrgbOperands<Int> operands(const reference::EvalConfig& config, Make&& make) {
  const auto width = reference::widths(config);
  const auto all = [&](const std::string& name, int bits, bool is_signed) -> Int {
    return make(name, bits, is_signed, is_signed ? signed_range(bits) : unsigned_range(bits));
  };
  LrgbOperands<Int> in;
  for (unsigned i = 0; i < 6; ++i) {
    const std::string n = std::to_string(i);
    in.coef[i] = all("coef" + n, width.stored, false);
    in.bias[i] = all("bias" + n, config.coef_bits, false);
    in.shift[i] = make("shift" + n, 5, true, Range{config.shift_min, reference::kShiftMax});
  }
  for (unsigned c = 0; c < 3; ++c) in.rgb[c] = all("rgb" + std::to_string(c), 8, false);
  in.lu = all("lu", width.light, true);
  in.lv = all("lv", width.light, true);
  return in;
}

/// What `visit`(name, value) is called with: every number of a pixel that has a name in the spec.
template <class Int, class Visit>
void visit_trace(const reference::LrgbTrace<Int>& trace, Visit&& visit) {
  const auto& l = trace.luminance;
  for (unsigned i = 0; i < 6; ++i) {
    const std::string n = std::to_string(i);
    visit("d" + n, l.d[i]);
    visit("p" + n, l.p[i]);
    visit("t" + n, l.t[i]);
  }
  visit("uu", l.b.uu);
  visit("vv", l.b.vv);
  visit("uv", l.b.uv);
  visit("acc", l.acc);
  visit("lum", l.lum.lum);
  visit("lum_saturated", l.lum.saturated);
  for (unsigned c = 0; c < 3; ++c) {
    visit("product" + std::to_string(c), trace.product[c]);
    visit("out" + std::to_string(c), trace.color.out[c]);
  }
  visit("color_saturated", trace.color.saturated);
}

LrgbOperands<Symbolic> symbolic_operands(Netlist& netlist, const reference::EvalConfig& config) {
  return operands<Symbolic>(config,
                            [&](const std::string& name, int bits, bool is_signed, Range range) {
                              return netlist.input(name, bits, is_signed, range);
                            });
}

/// A random value of a range, one time in four an end of it.
Value draw(std::mt19937_64& random, Range range) {
  const auto choice = random() % 8;
  if (choice == 0) return range.low;
  if (choice == 1) return range.high;
  return std::uniform_int_distribution<Value>(range.low, range.high)(random);
}

class SymbolicPixel : public testing::TestWithParam<reference::Preset> {};

TEST_P(SymbolicPixel, HasRangesThatHoldEveryValueThatOccurs) {
  const auto& config = GetParam().config;
  Netlist netlist;
  std::map<std::string, Range> ranges;
  visit_trace(reference::evaluate_lrgb(config, symbolic_operands(netlist, config)),
              [&](const std::string& name, const Symbolic& s) { ranges[name] = s.range(); });
  std::mt19937_64 random(5);
  for (int n = 0; n < 20000; ++n) {
    const auto in = operands<Value>(
        config, [&](const std::string&, int, bool, Range range) { return draw(random, range); });
    visit_trace(reference::evaluate_lrgb(config, in), [&](const std::string& name, Value value) {
      ASSERT_GE(value, ranges.at(name).low) << name;
      ASSERT_LE(value, ranges.at(name).high) << name;
    });
  }
}

TEST_P(SymbolicPixel, WritesANetlistThatComputesWhatTheReferenceDoes) {
  const auto& config = GetParam().config;
  const tests::ScratchFolder folder;
  Netlist netlist;
  visit_trace(reference::evaluate_lrgb(config, symbolic_operands(netlist, config)),
              [&](const std::string& name, const Symbolic& s) { netlist.output(name, s); });
  std::string script = "read_verilog -sv " +
                       folder.write("pixel.v", netlist.verilog("pixel")).string() +
                       "\nprep -top pixel\nlog BEGIN\n";
  std::mt19937_64 random(6);
  std::ostringstream expected;
  for (int n = 0; n < 40; ++n) {
    script += "eval";
    const auto in =
        operands<Value>(config, [&](const std::string& name, int bits, bool, Range range) {
          const Value value = draw(random, range);
          const auto mask = (std::uint64_t{1} << bits) - 1;
          script += " -set " + name + ' ' + std::to_string(bits) + "'d" +
                    std::to_string(static_cast<std::uint64_t>(value) & mask);
          return value;
        });
    visit_trace(reference::evaluate_lrgb(config, in), [&](const std::string& name, Value value) {
      for (const Netlist::Port& port : netlist.outputs()) {
        if (port.name != name) continue;
        script += " -show " + name;
        expected << '\\' << name << " = " << port.bits << "'";
        for (int bit = port.bits; bit-- > 0;) expected << (value >> bit & 1);
        expected << '\n';
      }
    });
    script += '\n';
  }
  const auto log = folder / "log";
  ASSERT_EQ(run_command({"yosys", "-s", folder.write("eval.ys", script).string()}, log), 0);
  std::ifstream lines(log);
  std::string found;
  for (std::string line; std::getline(lines, line);) {
    const std::size_t at = line.find("Eval result: ");
    if (at != std::string::npos)
      found += line.substr(at + 13, line.find_last_not_of(". ") - at - 12) + '\n';
  }
  EXPECT_EQ(found, expected.str());
}

INSTANTIATE_TEST_SUITE_P(Presets, SymbolicPixel, testing::ValuesIn(reference::kPresets),
                         [](const auto& preset) { return std::string(preset.param.name); });

}  // namespace
}  // namespace ptm::testbench
