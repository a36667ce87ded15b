#pragma once
#include <iomanip>
#include <map>
#include <random>

#include "testbench/rtl/variant_cache.h"
#include "tests/rtl/rtl_tools.h"
#include "tests/rtl/small_scenes.h"
#include "tests/rtl/unit_runs.h"
#include "tests/scratch_folder.h"

/// The unit as Yosys writes it back, run in Icarus Verilog, which knows X: a frame of the Verilated
/// unit is recorded cycle by cycle and replayed. Both tools are two implementations of the language
/// besides Verilator's.
namespace ptm::tests {

/// A unit of those parameters as a program for vvp, with testbench/sv/ptm_unit_replay_tb.sv;
/// `sources` are rtl/'s files, or changed ones.
class FourStateUnit {
 public:
  /// What registers hold at first, as far as nothing else is known of them.
  enum class Start { x, zero };

  FourStateUnit(const testbench::RtlUnitVariant& variant, const std::vector<std::string>& sources,
                Start start = Start::x) {
    std::string script = testbench::read_verilog(sources) + "\nchparam";
    for (const std::string& parameter : testbench::rtl_parameters(variant.config, variant.unit)) {
      const std::size_t at = parameter.find('=');
      script += " -set " + parameter.substr(0, at) + ' ' +
                testbench::yosys_integer(std::stoi(parameter.substr(at + 1)));
    }
    script += " ptm_unit\nhierarchy -check -top ptm_unit\nrename -top ptm_unit\nproc\nopt_clean\n";
    if (start == Start::zero) script += "zinit -all\n";
    const std::string netlist = (folder_ / "unit.v").string();
    script += "write_verilog -noattr " + netlist;
    expect_success(run_tool("yosys -q -s " + folder_.write("script", script + '\n').string()));
    expect_success(run_tool("iverilog -g2012 -s ptm_unit_replay_tb -o " + program() + ' ' +
                            netlist + " testbench/sv/ptm_unit_replay_tb.sv"));
  }
  /// What the replay of such a file prints; "replayed" is in it if nothing differed.
  [[nodiscard]] ToolRun replay(const std::string& trace) const {
    return run_tool("vvp -n " + program() + " +trace=" + folder_.write("trace", trace).string());
  }

 private:
  static void expect_success(const ToolRun& run) {
    if (run.status == 0) return;
    const std::size_t error = run.output.find("ERROR");
    throw std::runtime_error(error == std::string::npos ? run.output : run.output.substr(error));
  }
  [[nodiscard]] std::string program() const { return (folder_ / "unit.vvp").string(); }
  ScratchFolder folder_;
};

/// All files of the unit, effects' stages included.
inline std::vector<std::string> unit_sources() {
  std::vector<std::string> files = rtl_files();
  for (const auto& more : {rtl_files("rtl/unit.f"), effect_files()}) {
    files.insert(files.end(), more.begin(), more.end());
  }
  return files;
}

/// A frame of the Verilated unit as the commands of ptm_unit_replay_tb.sv.
class UnitRecording {
 public:
  explicit UnitRecording(testbench::RtlUnit& unit) : unit_(unit) { out_ << std::hex; }

  /// A cycle of reset, of the unit alone or of the memory too.
  void reset(bool memory_too) {
    unit_.reset(memory_too);
    out_ << (memory_too ? "R\n" : "S\n");
  }
  /// Reset and all registers.
  void load(const reference::UnitState& state) {
    unit_.load(state);
    out_ << "R\n";
    for (const auto& w : reference::register_writes(state)) {
      out_ << "W " << w.address << ' ' << w.data << '\n';
    }
    out_ << "I " << 4 * 27 << '\n';  // the draws' check
    read(0x1002);
    read(0x1003);
    write(0x1000, 3);
    write(0x1009, 31);  // events interrupt
  }
  void write(std::uint16_t address, std::uint32_t data) {
    unit_.write(address, data);
    out_ << "W " << address << ' ' << data << '\n';
  }
  void read(std::uint16_t address) {
    out_ << "Q " << address << ' ' << unit_.read(address) << '\n';
  }
  [[nodiscard]] testbench::RtlUnitSeen seen() const { return unit_.seen(); }
  testbench::RtlUnitSeen cycle(const testbench::RtlUnitPins& pins) {
    if (pins.write) throw std::logic_error("a cycle with a write cannot be replayed");
    const testbench::RtlUnitSeen seen = unit_.cycle(pins);
    const reference::UnitFragment& f = pins.fragment;
    const auto bits = [](auto value, int count) {
      return static_cast<std::uint32_t>(value) & ((std::uint32_t{1} << count) - 1);
    };
    out_ << "C " << pins.valid << ' ' << f.x << ' ' << f.y << ' ' << bits(f.u, 29) << ' '
         << bits(f.v, 29) << ' ' << f.lod << ' ' << bits(f.axis_u, 29) << ' ' << bits(f.axis_v, 29)
         << ' ' << int{f.probes_log2} << ' ' << bits(f.lu, 17) << ' ' << bits(f.lv, 17) << ' '
         << bits(f.hu, 17) << ' ' << bits(f.hv, 17) << ' ' << f.lit << ' ' << int{f.draw} << ' '
         << pins.pixel_ready << ' ' << pins.request_ready << ' ' << pins.response << ' '
         << int{pins.tag} << ' ' << pins.failed << ' ' << std::setfill('0');
    if (pins.response) {
      for (std::size_t w = reference::kLineWords; w-- > 0;) out_ << std::setw(8) << pins.line[w];
    } else {
      out_ << '0';
    }
    const reference::UnitPixel& p = seen.pixel;
    out_ << ' ' << seen.ready << ' ' << seen.request << ' ' << seen.line << ' ' << int{seen.tag}
         << ' ' << seen.pixel_valid << ' ' << p.x << ' ' << p.y << ' '
         << (p.rgb[0] | p.rgb[1] << 8 | p.rgb[2] << 16) << ' ' << int{p.alpha} << ' '
         << p.lum_saturated << ' ' << p.color_saturated << ' ' << p.memory_failed << ' '
         << seen.interrupt << '\n';
    return seen;
  }

  /// All fragments in, all pixels out, with gaps, stalls and answers in any order; then every
  /// counter and the status. Returns the pixels.
  std::vector<reference::UnitPixel> frame(const reference::UnitState& state,
                                          const std::vector<reference::UnitFragment>& fragments,
                                          std::uint64_t seed) {
    std::mt19937_64 rng(seed);
    const auto one_in = [&rng](unsigned n) { return rng() % n == 0; };
    std::vector<reference::UnitPixel> pixels;
    std::multimap<std::uint64_t, std::pair<std::uint8_t, std::uint32_t>> due;  // tag, line
    std::size_t sent = 0;
    bool offered = false;
    for (std::uint64_t cycle = 0; pixels.size() < fragments.size(); ++cycle) {
      if (cycle > 2000 + 2000 * fragments.size())
        throw std::runtime_error("the frame does not end");
      testbench::RtlUnitPins pins;
      if (!offered) offered = sent < fragments.size() && !one_in(7);  // and until it is accepted
      pins.valid = offered;
      if (pins.valid) pins.fragment = fragments[sent];
      pins.pixel_ready = !one_in(4);
      pins.request_ready = !one_in(5);
      const auto next = due.begin();
      pins.response = next != due.end() && next->first <= cycle;
      if (pins.response) {
        pins.tag = next->second.first;
        pins.line = state.memory.at(next->second.second);
        due.erase(next);
      }
      const testbench::RtlUnitSeen seen = this->cycle(pins);
      if (pins.valid && seen.ready) {
        ++sent;
        offered = false;
      }
      if (seen.request && pins.request_ready) {
        due.insert({cycle + 1 + rng() % 30, {seen.tag, seen.line}});
      }
      if (seen.pixel_valid && pins.pixel_ready) pixels.push_back(seen.pixel);
    }
    for (std::uint16_t n = 0; n < 2 * reference::kUnitCounters; ++n) {
      read(static_cast<std::uint16_t>(0x2000 + n));
    }
    read(0x1002);
    read(0x1003);
    read_registers();
    return pixels;
  }

  /// Every register that can be read, and some addresses that hold nothing.
  void read_registers() {
    for (unsigned address = 0; address < 0x100; ++address) {
      read(static_cast<std::uint16_t>(address));
      read(static_cast<std::uint16_t>(0x1000 + address));
      read(static_cast<std::uint16_t>(0x2800 + address));
      read(static_cast<std::uint16_t>(0x3000 + address));
      read(static_cast<std::uint16_t>(0x4000 + address));
      read(static_cast<std::uint16_t>(0x8000 + address));
    }
  }

  [[nodiscard]] std::string text() const { return out_.str(); }

 private:
  testbench::RtlUnit& unit_;
  std::ostringstream out_;
};

/// The recording of that scene by the Verilated unit of that variant, whose pixels must be the
/// reference's.
inline std::string recording_of(const testbench::RtlUnitVariant& variant,
                                testbench::RtlUnit& verilated, const SmallScene& scene,
                                std::size_t fragments) {
  const SmallWorld world = make_small_world(scene, variant, fragments);
  UnitRecording recording(verilated);
  recording.load(world.state);
  const auto pixels = recording.frame(world.state, world.fragments, 1);
  UnitScene whole;
  whole.config = variant.config;
  whole.unit = variant.unit;
  whole.state = world.state;
  expect_pixels(whole, world.fragments, pixels);
  return recording.text();
}

/// Records that scene and replays it.
inline void expect_replayed(const testbench::RtlUnitVariant& variant, const FourStateUnit& unit,
                            const SmallScene& scene, std::size_t fragments) {
  SCOPED_TRACE(scene.name);
  const auto verilated = variant.make();
  const ToolRun run = unit.replay(recording_of(variant, *verilated, scene, fragments));
  EXPECT_EQ(run.status, 0);
  EXPECT_NE(run.output.find("replayed"), std::string::npos) << run.output;
}

}  // namespace ptm::tests
