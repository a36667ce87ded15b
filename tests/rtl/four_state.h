#pragma once
#include <iomanip>
#include <map>
#include <random>

#include "testbench/rtl/variant_cache.h"
#include "tests/rtl/rtl_tools.h"
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
  FourStateUnit(const testbench::RtlUnitVariant& variant, const std::vector<std::string>& sources) {
    std::string script = testbench::read_verilog(sources) + "\nchparam";
    for (const std::string& parameter : testbench::rtl_parameters(variant.config, variant.unit)) {
      const std::size_t at = parameter.find('=');
      script += " -set " + parameter.substr(0, at) + ' ' +
                testbench::yosys_integer(std::stoi(parameter.substr(at + 1)));
    }
    const std::string netlist = (folder_ / "unit.v").string();
    script +=
        " ptm_unit\nhierarchy -check -top ptm_unit\nrename -top "
        "ptm_unit\nproc\nopt_clean\nwrite_verilog -noattr " +
        netlist;
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
    if (run.status != 0) throw std::runtime_error(run.output);
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
  }
  void write(std::uint16_t address, std::uint32_t data) {
    unit_.write(address, data);
    out_ << "W " << address << ' ' << data << '\n';
  }
  void read(std::uint16_t address) {
    out_ << "Q " << address << ' ' << unit_.read(address) << '\n';
  }
  testbench::RtlUnitSeen cycle(const testbench::RtlUnitPins& pins) {
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
         << int{pins.tag} << ' ' << std::setfill('0');
    if (pins.response) {
      for (std::size_t w = reference::kLineWords; w-- > 0;) out_ << std::setw(8) << pins.line[w];
    } else {
      out_ << '0';
    }
    const reference::UnitPixel& p = seen.pixel;
    out_ << ' ' << seen.ready << ' ' << seen.request << ' ' << seen.line << ' ' << int{seen.tag}
         << ' ' << seen.pixel_valid << ' ' << p.x << ' ' << p.y << ' '
         << (p.rgb[0] | p.rgb[1] << 8 | p.rgb[2] << 16) << ' ' << int{p.alpha} << ' '
         << p.lum_saturated << ' ' << p.color_saturated << '\n';
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
    return pixels;
  }

  [[nodiscard]] std::string text() const { return out_.str(); }

 private:
  testbench::RtlUnit& unit_;
  std::ostringstream out_;
};

/// A small scene: one draw so, its texels random; `draws` of them, each of another size.
struct SmallScene {
  const char* name;
  reference::TextureFormat format = reference::TextureFormat::lrgb;
  reference::Combine combine = reference::Combine::none;
  bool bilinear = true;
  reference::Mip mip = reference::Mip::none;
  reference::Wrap wrap = reference::Wrap::repeat;
  int width = 16, height = 16;
  int probes_log2 = 0;
  bool lit = true;
  int draws = 1;
};

inline const std::vector<SmallScene>& small_scenes() {
  using enum reference::TextureFormat;
  using reference::Combine, reference::Mip, reference::Wrap;
  static const std::vector<SmallScene> scenes{
      {.name = "LrgbPoint", .bilinear = false},
      {.name = "LrgbBilinear"},
      {.name = "LrgbTrilinearMirror", .mip = Mip::linear, .wrap = Wrap::mirror},
      {.name = "LrgbNearestMipClamp", .mip = Mip::nearest, .wrap = Wrap::clamp},
      {.name = "LrgbOddSeams", .width = 15, .height = 12},
      {.name = "LrgbOneTexel", .mip = Mip::linear, .width = 1, .height = 1},
      {.name = "LrgbProbes", .mip = Mip::linear, .probes_log2 = 2},
      {.name = "LrgbUnlit", .lit = false},
      {.name = "LrgbModulate", .combine = Combine::modulate, .mip = Mip::linear},
      {.name = "LrgbDecal", .combine = Combine::decal},
      {.name = "LrgbBlend", .combine = Combine::blend},
      {.name = "LrgbReplace", .combine = Combine::replace},
      {.name = "RgbBilinear", .format = rgb},
      {.name = "RgbTrilinearAdd", .format = rgb, .combine = Combine::add, .mip = Mip::linear},
      {.name = "PaletteLrgb", .format = palette_lrgb},
      {.name = "PaletteLrgbDecal",
       .format = palette_lrgb,
       .combine = Combine::decal,
       .mip = Mip::linear},
      {.name = "PaletteRgb", .format = palette_rgb},
      {.name = "PaletteRgbAddClamp",
       .format = palette_rgb,
       .combine = Combine::add,
       .wrap = Wrap::clamp},
      {.name = "ColorOnly", .format = none, .combine = Combine::replace, .mip = Mip::linear},
      {.name = "FourDraws", .mip = Mip::linear, .draws = 4}};
  return scenes;
}

struct SmallWorld {
  reference::UnitState state;
  std::vector<reference::UnitFragment> fragments;
};

/// That scene for a unit of that variant, with what effects the unit is built for in every draw
/// that may have them, and fragments about its texels.
inline SmallWorld make_small_world(const SmallScene& scene,
                                   const testbench::RtlUnitVariant& variant,
                                   std::size_t fragments) {
  using enum reference::TextureFormat;
  const reference::EvalConfig& config = variant.config;
  std::mt19937_64 rng(std::hash<std::string>{}(scene.name));
  const auto in = [&rng](int low, int high) {
    return std::uniform_int_distribution(low, high)(rng);
  };
  const auto fill = [&in](auto& values, std::size_t count, int most) {
    values.resize(count);
    for (auto& v : values) v = static_cast<std::decay_t<decltype(v)>>(in(0, most));
  };
  constexpr std::size_t kEntries = 16;
  const int most = (1 << config.coef_bits) - 1;
  SmallWorld world;
  reference::UnitState& state = world.state;
  std::vector<std::uint16_t> coef;
  if (scene.format == palette_lrgb) {
    fill(coef, kEntries * 6, most);
    append_lrgb_palette(config, coef, 0, state.palettes);
  }
  if (scene.format == palette_rgb) {
    fill(coef, kEntries * 18, most);
    set_rgb_palette(config, coef, state.palettes);
  }
  for (int d = 0; d < scene.draws; ++d) {
    reference::Draw draw;
    draw.format = scene.format;
    draw.combine = scene.combine;
    draw.color = scene.combine != reference::Combine::none;
    draw.bilinear = scene.bilinear;
    draw.mip = scene.mip;
    draw.wrap_u = draw.wrap_v = scene.wrap;
    for (auto& b : draw.bias) b = most / 2;
    draw.shift = {3, 3, 3, 2, 2, 0};
    draw.ka = 100;
    draw.kd = 200;
    draw.ks = 150;
    const bool rgb_map = draw.format == rgb || draw.format == palette_rgb;
    if (draw.format != none) {
      draw.effects.sets = variant.unit.extra_sets;
      draw.effects.passes = rgb_map && draw.effects.sets == 0 ? 0 : variant.unit.extra_passes;
      draw.effects.stages = variant.unit.stages;
      for (int k = 0; k < draw.effects.passes; ++k) {
        draw.effects.pass[static_cast<std::size_t>(k)] = {
            in(rgb_map ? 1 : 0, draw.effects.sets), variant.unit.half_vector && in(0, 1) != 0};
      }
      for (int n = 0; n < draw.effects.sets; ++n) {
        draw.effects.bias[static_cast<std::size_t>(n)] = draw.bias;
        draw.effects.shift[static_cast<std::size_t>(n)] = draw.shift;
      }
    }
    std::vector<reference::StoredTexture> map;
    std::vector<reference::StoredPaletteMap> palette_map;
    std::vector<reference::StoredPicture> picture;
    std::vector<reference::StoredSet> sets(static_cast<std::size_t>(draw.effects.sets));
    int w = scene.width + d, h = scene.height + d;
    for (bool more = true; more; w = std::max(1, w / 2), h = std::max(1, h / 2)) {
      more = scene.mip != reference::Mip::none && std::max(w, h) > 1;
      const auto texels = static_cast<std::size_t>(w * h);
      reference::StoredTexture level{w, h, rgb_map, {}, {}, {}, {}};
      fill(level.coef, texels * (rgb_map ? 18 : 6), most);
      fill(level.color, rgb_map ? 0 : texels * 3, 255);
      map.push_back(level);
      reference::StoredPaletteMap indices{w, h, rgb_map, {}, {}};
      fill(indices.index, texels, kEntries - 1);
      fill(indices.color, rgb_map ? 0 : texels * 3, 255);
      palette_map.push_back(indices);
      reference::StoredPicture image{w, h, {}};
      fill(image.rgba, texels * 4, 255);
      picture.push_back(image);
      for (auto& set : sets) {
        reference::StoredTexture& made = set.emplace_back();
        made.width = w;
        made.height = h;
        fill(made.coef, texels * 6, most);
      }
    }
    if (draw.format == lrgb || draw.format == rgb) {
      draw.map = append_map(config, map, sets, state.memory);
    } else if (draw.format != none) {
      draw.map = append_palette_map(config, palette_map, sets, state.memory);
    }
    if (draw.color) draw.color_texture = append_picture(picture, state.memory);
    state.draws.push_back(draw);
    if (draw.effects.stages != 0) {
      state.tables.resize(state.draws.size());
      state.tables.back() = reference::effect_table(8);
    }
  }
  const int light = 1 << (config.light_int + config.light_frac - 1);
  while (world.fragments.size() < fragments) {
    reference::UnitFragment f;
    f.x = static_cast<std::uint16_t>(world.fragments.size());
    f.y = static_cast<std::uint16_t>(in(0, 16383));
    f.u = in(-(1 << 20), 2 << 20);
    f.v = in(-(1 << 20), 2 << 20);
    f.lod = static_cast<std::uint16_t>(in(0, 1) != 0 ? 0 : in(0, 1300));
    f.axis_u = in(-(1 << 17), 1 << 17);
    f.axis_v = in(-(1 << 17), 1 << 17);
    f.probes_log2 = static_cast<std::uint8_t>(scene.probes_log2);
    f.lu = in(-light, light - 1);
    f.lv = in(-light, light - 1);
    if (variant.unit.half_vector) {
      f.hu = in(-light, light - 1);
      f.hv = in(-light, light - 1);
    }
    f.lit = scene.lit;
    f.draw = static_cast<std::uint8_t>(in(0, scene.draws - 1));
    world.fragments.push_back(f);
  }
  return world;
}

/// Records that scene of the Verilated unit, whose pixels must be the reference's, and replays it.
inline void expect_replayed(const testbench::RtlUnitVariant& variant, const FourStateUnit& unit,
                            const SmallScene& scene, std::size_t fragments) {
  SCOPED_TRACE(scene.name);
  const SmallWorld world = make_small_world(scene, variant, fragments);
  const auto verilated = variant.make();
  UnitRecording recording(*verilated);
  recording.load(world.state);
  const auto pixels = recording.frame(world.state, world.fragments, 1);
  UnitScene whole;
  whole.config = variant.config;
  whole.unit = variant.unit;
  whole.state = world.state;
  expect_pixels(whole, world.fragments, pixels);
  const ToolRun run = unit.replay(recording.text());
  EXPECT_EQ(run.status, 0);
  EXPECT_NE(run.output.find("replayed"), std::string::npos) << run.output;
}

}  // namespace ptm::tests
