// The same RTL in a second simulator: CXXRTL, which shares nothing with Verilator, built here from
// the same sources and stepped beside the Verilated evaluators. Equal in every cycle.
#include <dlfcn.h>

#include <random>

#include "testbench/rtl/rtl_variants.h"
#include "testbench/vectors/vector_generator.h"
#include "tests/rtl/cxxrtl/simulation.h"
#include "tests/rtl/rtl_tools.h"
#include "tests/scratch_folder.h"

namespace ptm::tests {
namespace {

using testbench::RtlPins;
using testbench::RtlSeen;

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += ' ' + word;
  return text;
}

/// " -chparam Name value" for each "Name=value".
std::string yosys_parameters(const std::vector<std::string>& parameters) {
  std::string text;
  for (const std::string& parameter : parameters) {
    const std::size_t equals = parameter.find('=');
    text += " -chparam " + parameter.substr(0, equals) + ' ' +
            testbench::yosys_integer(std::stoi(parameter.substr(equals + 1)));
  }
  return text;
}

void run_or_fail(const std::string& command) {
  const ToolRun tool = run_tool(command);
  ASSERT_EQ(tool.status, 0) << command << '\n' << tool.output;
}

/// What CXXRTL makes of ptm_NAME, built with tests/rtl/cxxrtl/NAME.cpp and loaded; null, and the
/// test has failed, if a tool fails. The library stays loaded.
template <class Simulation>
std::unique_ptr<Simulation> make_cxxrtl(const std::string& name, const std::string& sources,
                                        const std::vector<std::string>& parameters) {
  const ScratchFolder folder;
  const std::string made = (folder / (name + "_cxxrtl")).string();
  const std::string library = made + ".so";
  run_or_fail("yosys -q -p \"read_verilog -sv -DSYNTHESIS -Irtl" + sources +
              "; hierarchy -top ptm_" + name + yosys_parameters(parameters) +
              "; proc; techmap -map tests/rtl/cxxrtl/shift.v; write_cxxrtl -header -namespace " +
              name + "_cxxrtl " + made + ".cc\"");
  if (testing::Test::HasFatalFailure()) return nullptr;
  // -w: the generated code is not held to our warnings.
  run_or_fail(
      "c++ -std=c++20 -O1 -w -fPIC -shared -I. -isystem $(yosys-config --datdir)/include"
      " -I'" +
      (folder / "").string() + "' '" + made + ".cc' tests/rtl/cxxrtl/" + name + ".cpp -o '" +
      library + "'");
  if (testing::Test::HasFatalFailure()) return nullptr;
  void* handle = dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL);
  EXPECT_TRUE(handle != nullptr) << dlerror();
  if (handle == nullptr) return nullptr;
  const auto make = reinterpret_cast<Simulation* (*)()>(dlsym(handle, "ptm_make_cxxrtl"));
  EXPECT_TRUE(make != nullptr);
  return std::unique_ptr<Simulation>(make == nullptr ? nullptr : make());
}

class CxxrtlEvaluatorEqual : public testing::TestWithParam<testbench::RtlVariant> {};

/// Pixels are compared where they mean something, handshakes always.
bool same(const RtlSeen& a, const RtlSeen& b) {
  return a.ready == b.ready && a.valid == b.valid &&
         (!a.valid || (a.pixel == b.pixel && a.sideband == b.sideband));
}

TEST_P(CxxrtlEvaluatorEqual, InEveryCycleOfGapsAndStalls) {
  const testbench::RtlVariant& variant = GetParam();
  std::vector<std::string> parameters;
  for (const auto& parameter : reference::rtl_parameters(variant.config)) {
    parameters.push_back(std::string(parameter.name) + '=' + std::to_string(parameter.value));
  }
  const auto cxxrtl = make_cxxrtl<CxxrtlEvaluator>("evaluator", joined(rtl_files()), parameters);
  ASSERT_TRUE(cxxrtl);
  const auto verilated = variant.make();
  verilated->reset();

  std::mt19937_64 rng(17);
  std::uint64_t vector = 0, pixels = 0, blocked = 0;
  RtlPins pins;
  unsigned pass = 0;  // of the next beat
  bool held = false;  // what is offered and not accepted stays
  for (unsigned cycle = 0; cycle < 60'000; ++cycle) {
    if (!held) {
      pins.valid = rng() % 8 != 0;
      if (pins.valid) {
        // Whole pixels: three passes of an RGB map follow one another.
        if (pass == 0) pins.rgb_map = rng() % 3 == 0;
        pins.channel = pass;
        pass = pins.rgb_map ? (pass + 1) % 3 : 0;
        pins.operands = testbench::lrgb_vector(variant.config, 17, vector);
        pins.sideband = static_cast<std::uint32_t>(vector++);
      }
    }
    pins.ready = rng() % 4 != 0;
    const RtlSeen a = verilated->cycle(pins);
    const RtlSeen b = cxxrtl->cycle(pins);
    ASSERT_TRUE(same(a, b)) << variant.name << ", cycle " << cycle << ": ready " << a.ready << ' '
                            << b.ready << ", valid " << a.valid << ' ' << b.valid << ", sideband "
                            << a.sideband << ' ' << b.sideband;
    held = pins.valid && !a.ready;
    pixels += a.valid && pins.ready;
    blocked += a.valid && !pins.ready;
  }
  EXPECT_GT(pixels, 10'000U);
  EXPECT_GT(blocked, 1'000U);
}

INSTANTIATE_TEST_SUITE_P(Variants, CxxrtlEvaluatorEqual,
                         testing::ValuesIn(testbench::rtl_variants()),
                         [](const auto& tested) { return std::string(tested.param.name); });

}  // namespace
}  // namespace ptm::tests
