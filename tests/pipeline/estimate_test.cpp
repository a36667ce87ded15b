// Timing `loose` against `exact`: total cycles within 3 % on 65,536 fragments
// (docs/spec/unit-timing.md, "Two timings").
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <iostream>
#include <memory>

#include "model/pipeline/estimate_texture_unit.h"
#include "model/pipeline/unit/memory_target.h"
#include "model/pipeline/unit/texture_unit.h"

namespace ptm::pipeline {
namespace {

using namespace reference;

constexpr int kSide = 320;

struct Place {
  double u = 0, v = 0, lod = 0;
  int probes_log2 = 0;
  bool drawn = true;
};

struct Scene {
  const char* name;
  std::function<void(Draw&)> draw;
  std::function<Place(double x, double y)> place;  ///< x, y in 0 .. 1
  std::function<void(UnitConfig&)> unit = [](UnitConfig&) {};
  MemoryModel memory = FixedMemory{};
  int tile = 16;  ///< 0: scan lines
  EvalConfig eval{};
};

std::vector<UnitFragment> fragments_of(const Scene& scene) {
  std::vector<UnitFragment> out;
  const int tile = scene.tile == 0 ? kSide : scene.tile, rows = scene.tile == 0 ? 1 : scene.tile;
  for (int ty = 0; ty < kSide; ty += rows) {
    for (int tx = 0; tx < kSide; tx += tile) {
      for (int y = ty; y < ty + rows; ++y) {
        for (int x = tx; x < tx + tile; ++x) {
          const Place at = scene.place((x + 0.5) / kSide, (y + 0.5) / kSide);
          if (!at.drawn) continue;
          UnitFragment f;
          f.x = static_cast<std::uint16_t>(x);
          f.y = static_cast<std::uint16_t>(y);
          f.u = static_cast<std::int32_t>(std::lround(at.u * (1 << 20)));
          f.v = static_cast<std::int32_t>(std::lround(at.v * (1 << 20)));
          f.lod = static_cast<std::uint16_t>(std::clamp(at.lod, 0.0, 15.9) * 256);
          f.probes_log2 = static_cast<std::uint8_t>(at.probes_log2);
          f.axis_u = f.probes_log2 > 0 ? 1500 : 0;
          out.push_back(f);
        }
      }
    }
  }
  return out;
}

TextureLevels levels(int width, int height, int planes, std::uint32_t base) {
  TextureLevels out{.width = width, .height = height};
  while (std::max(width, height) >> out.levels != 0) ++out.levels;
  for (int l = 0; l < out.levels; ++l) {
    out.base[static_cast<std::size_t>(l)] = base;
    base += static_cast<std::uint32_t>(level_lines(out, planes, l));
  }
  return out;
}

std::function<void(Draw&)> map(TextureFormat format, int width, int height, Mip mip = Mip::none) {
  return [=](Draw& draw) {
    draw.format = format;
    draw.mip = mip;
    draw.map = levels(width, height, map_planes(format, {}), 0);
  };
}

void colored(Draw& draw) {
  map(TextureFormat::lrgb, 512, 512, Mip::linear)(draw);
  draw.color = true;
  draw.combine = reference::Combine::modulate;
  draw.color_texture = levels(256, 256, 1, 1 << 20);
}

Place upright(double x, double y) { return {x + 0.0003, y + 0.0004}; }
Place turned(double x, double y) { return {0.8 * x - 0.6 * y + 0.5, 0.6 * x + 0.8 * y}; }
/// A plane towards the horizon.
Place receding(double x, double y) {
  const double z = 1 / (0.1 + y);
  return {(x - 0.5) * z * 0.3 + 0.5, z * 0.3, std::log2(0.3 * z * z * 512 / kSide / 3)};
}
Place sphere(double x, double y) {
  const double a = 2.1 * x - 1.05, b = 2.1 * y - 1.05, r = a * a + b * b;
  if (r >= 1) return {.drawn = false};
  const double z = std::sqrt(1 - r);
  return {std::atan2(a, z) / M_PI + 0.5, std::acos(b) / M_PI, 0.5 - std::log2(z) / 2};
}
Place larger(double x, double y) { return {4 * upright(x, y).u, 4 * y}; }

/// Two coefficients a word.
constexpr EvalConfig kTwelveBits{.coef_bits = 12};
void twelve_bits(Draw& draw) {
  draw.format = TextureFormat::lrgb;
  draw.map = levels(256, 256, map_planes(draw.format, kTwelveBits), 0);
}

/// A unit with all that effects may add.
void all_effects(UnitConfig& u) {
  u.extra_sets = u.extra_passes = 4;
  u.half_vector = true;
  u.stages = 7;
}
/// A map with sets and passes of all of them.
std::function<void(Draw&)> effects(TextureFormat format, int sets, int passes) {
  return [=](Draw& draw) {
    draw.format = format;
    draw.mip = Mip::linear;
    draw.effects.sets = sets;
    draw.effects.passes = passes;
    draw.effects.stages = 7;
    for (auto& pass : draw.effects.pass) pass.set = sets;
    draw.map = levels(256, 256, array_planes(draw, {}), 0);
  };
}

const std::array<Scene, 22> kScenes{{
    {"UprightPlane", map(TextureFormat::lrgb, 256, 256), upright},
    {"UprightPlaneInScanLines", map(TextureFormat::lrgb, 256, 256), upright, [](auto&) {},
     FixedMemory{}, 0},
    {"TurnedPlane", map(TextureFormat::lrgb, 256, 256), turned},
    {"TurnedPlaneOneTmu", map(TextureFormat::lrgb, 256, 256), turned,
     [](UnitConfig& u) { u.tmus = 1; }},
    {"TurnedPlaneTwoTmus", map(TextureFormat::lrgb, 256, 256), turned,
     [](UnitConfig& u) { u.tmus = 2; }},
    {"TurnedPlaneTwelveBits", twelve_bits, turned, [](auto&) {}, FixedMemory{}, 16, kTwelveBits},
    {"RgbPlane", map(TextureFormat::rgb, 200, 300), turned},
    {"PalettePlane", map(TextureFormat::palette_lrgb, 256, 256), turned,
     [](UnitConfig& u) { u.palette_lrgb_ports = 1; }},
    {"RecedingPlaneTrilinear", map(TextureFormat::lrgb, 512, 512, Mip::linear), receding},
    {"RecedingPlaneNearestMip", map(TextureFormat::lrgb, 512, 512, Mip::nearest), receding},
    {"RecedingPlaneInDram", map(TextureFormat::lrgb, 512, 512, Mip::nearest), receding,
     [](auto&) {}, DramMemory{}},
    {"SphereTrilinear", map(TextureFormat::lrgb, 512, 256, Mip::linear), sphere},
    {"SphereWithColour", colored, sphere},
    {"Minified", map(TextureFormat::lrgb, 1024, 1024), upright},
    {"SmallOddRepeated", map(TextureFormat::lrgb, 13, 7), larger},
    {"SmallCacheAndFifo", map(TextureFormat::lrgb, 256, 256), turned,
     [](UnitConfig& u) {
       u.cache_kib = 4;
       u.fragment_fifo = 64;
       u.miss_fifo = 16;
     }},
    {"Probes", map(TextureFormat::lrgb, 512, 512, Mip::linear),
     [](double x, double y) {
       Place p = receding(x, y);
       p.probes_log2 = 2;
       p.lod -= 2;
       return p;
     }},
    {"HalfVector", effects(TextureFormat::lrgb, 0, 1), turned, all_effects},
    {"OneSet", effects(TextureFormat::lrgb, 1, 1), receding, all_effects},
    {"AllEffects", effects(TextureFormat::lrgb, 4, 4), turned, all_effects},
    {"AllEffectsRgbOneTmu", effects(TextureFormat::rgb, 4, 4), sphere,
     [](UnitConfig& u) {
       all_effects(u);
       u.tmus = 1;
     }},
    {"PaletteWithSets", effects(TextureFormat::palette_rgb, 2, 2), turned, all_effects},
}};

class Estimates : public testing::TestWithParam<Scene> {};

TEST_P(Estimates, AreWithinThreePercentOfExact) {
  const Scene& scene = GetParam();
  UnitConfig config;
  scene.unit(config);
  UnitState state;
  scene.draw(state.draws.emplace_back());
  ASSERT_EQ(check_draw(state.draws[0], 1 << 26, config, scene.eval), 0U);
  const auto fragments = fragments_of(scene);
  ASSERT_GE(fragments.size(), 65536U);
  const sc_core::sc_time clock(1, sc_core::SC_NS);
  MemoryTarget memory("memory", make_memory(scene.memory), {}, clock);
  TextureUnit unit("unit", config, state.draws, {}, {}, clock, scene.eval);
  unit.memory.socket.bind(memory.socket);
  sc_core::sc_start(sc_core::SC_ZERO_TIME);
  memory.reset();
  const UnitCounters exact = unit.run({fragments}, kPatience).result.counters;
  const UnitEstimate loose =
      estimate_texture_unit(config, state, {fragments}, scene.memory, 16, {}, scene.eval);
  const auto cycles = static_cast<double>(exact[UnitCounter::cycles]);
  const double error = static_cast<double>(loose.cycles) / cycles - 1;
  std::cout << scene.name << ": " << fragments.size() << " fragments, " << cycles << " cycles, "
            << exact[UnitCounter::lines_read] << " lines; loose " << error * 100 << " %, "
            << loose.lines_read << " lines\n";
  EXPECT_LE(std::abs(error), 0.03);
}

INSTANTIATE_TEST_SUITE_P(Scenes, Estimates, testing::ValuesIn(kScenes),
                         [](const auto& scene) { return std::string(scene.param.name); });

}  // namespace
}  // namespace ptm::pipeline
