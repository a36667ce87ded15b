// The same RTL in a second simulator: CXXRTL, which shares nothing with Verilator, built here from
// the same sources and stepped beside the Verilated units. Equal in every cycle.
#include <dlfcn.h>

#include <deque>
#include <random>

#include "testbench/rtl/rtl_variants.h"
#include "testbench/rtl/variant_cache.h"
#include "testbench/vectors/vector_generator.h"
#include "tests/rtl/cxxrtl/simulation.h"
#include "tests/rtl/rtl_tools.h"
#include "tests/rtl/unit_runs.h"
#include "tests/scratch_folder.h"

namespace ptm::tests {
namespace {

using testbench::RtlPins;
using testbench::RtlSeen;
using testbench::RtlUnitPins;
using testbench::RtlUnitSeen;

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
  // The unit is one function of 30,000 lines, over which an optimiser takes many minutes.
  run_or_fail(
      "c++ -std=c++20 -O0 -w -fPIC -shared -I. -I'" PTM_GENERATED "' -isystem $(yosys-config --datdir)/include"
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

class CxxrtlUnitEqual : public testing::TestWithParam<testbench::RtlUnitVariant> {};

bool same(const RtlUnitSeen& a, const RtlUnitSeen& b) {
  return a.ready == b.ready && a.pixel_valid == b.pixel_valid &&
         (!a.pixel_valid || a.pixel == b.pixel) && a.request == b.request &&
         (!a.request || (a.line == b.line && a.tag == b.tag)) && a.interrupt == b.interrupt;
}

std::string text_of(const RtlUnitSeen& seen) {
  std::ostringstream text;
  text << "fragment ready " << seen.ready << ", pixel " << seen.pixel_valid << " at "
       << seen.pixel.x << ',' << seen.pixel.y << ": " << int{seen.pixel.rgb[0]} << ' '
       << int{seen.pixel.rgb[1]} << ' ' << int{seen.pixel.rgb[2]} << ' ' << int{seen.pixel.alpha}
       << ' ' << seen.pixel.lum_saturated << seen.pixel.color_saturated << ", request "
       << seen.request << " line " << seen.line << " tag " << int{seen.tag};
  return text.str();
}

/// A memory that answers late and out of order.
class RandomMemory {
 public:
  RandomMemory(const std::vector<reference::Line>& lines, std::mt19937_64& rng)
      : lines_(lines), rng_(rng) {}
  void ask(std::uint32_t line, std::uint8_t tag) { waiting_.push_back({line, tag}); }
  void drive(RtlUnitPins& pins) {
    pins.response = !waiting_.empty() && rng_() % 4 == 0;
    if (!pins.response) return;
    const auto chosen = waiting_.begin() + static_cast<std::ptrdiff_t>(rng_() % waiting_.size());
    pins.line = lines_.at(chosen->first);
    pins.tag = chosen->second;
    waiting_.erase(chosen);
  }

 private:
  const std::vector<reference::Line>& lines_;
  std::mt19937_64& rng_;
  std::deque<std::pair<std::uint32_t, std::uint8_t>> waiting_;
};

/// A frame through both, compared in every cycle; then every counter.
void expect_equal_frame(testbench::RtlUnit& verilated, CxxrtlUnit& cxxrtl, const UnitScene& scene,
                        const std::vector<reference::UnitFragment>& fragments,
                        std::mt19937_64& rng) {
  const auto write = [&](std::uint16_t address, std::uint32_t data) {
    verilated.write(address, data);
    cxxrtl.write(address, data);
  };
  for (const reference::RegisterWrite& w : register_writes(scene.state)) write(w.address, w.data);
  RtlUnitPins pins;
  pins.pixel_ready = false;
  for (int cycle = 0; cycle < 300; ++cycle) {  // more than the draws' check takes
    ASSERT_TRUE(same(verilated.cycle(pins), cxxrtl.cycle(pins))) << "cycle of the check " << cycle;
  }
  ASSERT_EQ(verilated.read(0x1002), 0U);
  ASSERT_EQ(cxxrtl.read(0x1002), 0U);
  write(0x1000, 3);
  write(0x1009, 31);  // events interrupt

  RandomMemory memory(scene.state.memory, rng);
  std::vector<reference::UnitPixel> pixels;
  std::size_t sent = 0;
  bool held = false;
  for (unsigned cycle = 0; pixels.size() < fragments.size() && cycle < 200'000; ++cycle) {
    if (!held) pins.valid = sent < fragments.size() && rng() % 8 != 0;
    if (pins.valid) pins.fragment = fragments[sent];
    pins.pixel_ready = rng() % 8 != 0;
    pins.request_ready = rng() % 4 != 0;
    memory.drive(pins);
    const RtlUnitSeen a = verilated.cycle(pins);
    const RtlUnitSeen b = cxxrtl.cycle(pins);
    ASSERT_TRUE(same(a, b)) << "cycle " << cycle << ", pixel " << pixels.size() << "\n  Verilator "
                            << text_of(a) << "\n  CXXRTL    " << text_of(b);
    held = pins.valid && !a.ready;
    sent += pins.valid && a.ready;
    if (a.request && pins.request_ready) memory.ask(a.line, a.tag);
    if (a.pixel_valid && pins.pixel_ready) pixels.push_back(a.pixel);
  }
  expect_pixels(scene, fragments, pixels);
  for (std::uint16_t n = 0; n < 2 * reference::kUnitCounters; ++n) {
    const auto address = static_cast<std::uint16_t>(0x2000 + n);
    EXPECT_EQ(verilated.read(address), cxxrtl.read(address)) << "counter " << n / 2;
  }
  for (unsigned n = 0; n < 0x100; ++n) {
    for (const unsigned first : {0U, 0x1000U, 0x2800U}) {
      const auto address = static_cast<std::uint16_t>(first + n);
      EXPECT_EQ(verilated.read(address), cxxrtl.read(address)) << "register " << first + n;
    }
  }
  write(0x1008, 31);
}

TEST_P(CxxrtlUnitEqual, InEveryCycleAndCounterOfRandomScenes) {
  const testbench::RtlUnitVariant& variant = GetParam();
  const auto cxxrtl = make_cxxrtl<CxxrtlUnit>(
      "unit", joined(rtl_files()) + joined(rtl_files("rtl/unit.f")) + joined(effect_files()),
      testbench::rtl_parameters(variant.config, variant.unit));
  ASSERT_TRUE(cxxrtl);
  const auto verilated = variant.make();
  std::mt19937_64 rng(23);
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    SCOPED_TRACE(std::string(variant.name) + ", scene " + std::to_string(seed));
    UnitSceneMaker make(seed);
    const UnitScene scene = make.scene(variant.config, variant.unit);
    const auto fragments = random_fragments(make, scene, 500);
    if (seed == 1) verilated->load(scene.state);  // from a reset, as the other begins
    expect_equal_frame(*verilated, *cxxrtl, scene, fragments, rng);
    if (HasFatalFailure()) return;
  }
}

INSTANTIATE_TEST_SUITE_P(Variants, CxxrtlUnitEqual,
                         testing::Values(testbench::rtl_unit_variants().back()),
                         [](const auto& tested) { return std::string(tested.param.name); });

}  // namespace
}  // namespace ptm::tests
