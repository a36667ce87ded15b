#pragma once
#include <algorithm>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "model/pipeline/unit_run.h"
#include "model/reference/effects/stages.h"

namespace ptm::tests {

/// A unit, what it draws and how it is disturbed, all from one seed. Small caches, FIFOs and rings,
/// so that every limit binds somewhere.
struct RandomUnit {
  reference::UnitConfig unit;
  reference::EvalConfig eval;
  std::vector<reference::Draw> draws;
  std::vector<reference::UnitFragment> fragments;
  pipeline::StreamTiming timing;
  pipeline::MemoryModel memory;
  bool keep_cache = false;  ///< in a second frame

  /// With effects: what the unit has of them, and what each draw uses, from the same seed.
  explicit RandomUnit(std::uint64_t seed, bool with_effects = false) : random_(seed) {
    make_config();
    unit.eval_lanes = seed % 3 == 2 ? 3 : 1;
    if (seed % 4 == 1) eval.coef_bits = 12;  // two coefficients a word
    if (with_effects) add_effects(seed);
    make_disturbance(seed);
    const int count = pick({1, 1, 2, 4});
    for (int d = 0; d < count; ++d) draws.push_back(make_draw());
    make_fragments(static_cast<std::size_t>(pick({40, 200, 500})));
  }

 private:
  std::mt19937_64 random_;
  std::uint32_t next_line_ = 0;

  int pick(std::initializer_list<int> values) {
    return *(values.begin() + static_cast<std::ptrdiff_t>(random_() % values.size()));
  }
  int below(int limit) { return static_cast<int>(random_() % static_cast<std::uint64_t>(limit)); }
  bool one_in(int n) { return below(n) == 0; }

  void make_config() {
    unit.tmus = 1 + below(3);
    unit.cache_kib = pick({1, 1, 2, 4, 16});
    unit.ways = pick({1, 2, 4});
    unit.fragment_fifo = pick({4, 5, 8, 33, 192});
    unit.miss_fifo = one_in(3) ? 64 : 4 * unit.tmus + below(5);
    unit.palette_lrgb_ports = pick({1, 2, 4});
    unit.palette_rgb_ports = pick({1, 2, 4});
  }

  /// Every part of the effects, alone and with the others.
  void add_effects(std::uint64_t seed) {
    unit.extra_passes = pick({0, 1, 2, 4});
    unit.extra_sets = below(unit.extra_passes + 1);
    unit.half_vector = unit.extra_passes > 0 && one_in(2);
    unit.stages = static_cast<unsigned>(seed % 8) & reference::effects::kStages;
    eval.lum_frac = pick({0, 4});
  }

  /// Of a draw: often all that the unit has, sometimes none.
  void use_effects(reference::Draw& draw) {
    reference::DrawEffects& e = draw.effects;
    const bool map = draw.format != reference::TextureFormat::none;
    const bool own = draw.format == reference::TextureFormat::lrgb ||
                     draw.format == reference::TextureFormat::palette_lrgb;
    if (map) e.sets = one_in(2) ? unit.extra_sets : below(unit.extra_sets + 1);
    if (map && (own || e.sets > 0)) {
      e.passes = one_in(2) ? unit.extra_passes : below(unit.extra_passes + 1);
    }
    for (auto& pass : e.pass) {
      pass.set = own ? below(e.sets + 1) : 1 + below(std::max(e.sets, 1));
      pass.half = unit.half_vector && one_in(2);
    }
    for (int k = e.passes; k < reference::kExtraPasses; ++k)
      e.pass[static_cast<std::size_t>(k)] = {};
    e.stages = unit.stages & static_cast<unsigned>(one_in(2) ? 255 : below(8));
    e.argument = static_cast<std::uint32_t>(below(4));
  }

  void make_disturbance(std::uint64_t seed) {
    timing.seed = seed;
    timing.input_gap = pick({0, 0, 3, 9}) / 10.0;
    timing.output_stall = pick({0, 0, 3, 8}) / 10.0;
    if (one_in(5)) {
      timing.idle = 7;
      timing.group = 3;
    }
    const auto cycles = [&](std::initializer_list<int> v) {
      return static_cast<pipeline::Cycle>(pick(v));
    };
    switch (below(4)) {
      case 0:
        memory = pipeline::FixedMemory{cycles({1, 20, 100}), cycles({1, 4})};
        break;
      case 1:
        memory = pipeline::DramMemory{.page_lines = 4, .tREFI = 900, .tRFC = 60, .overhead = 5};
        break;
      default:
        memory = pipeline::RandomMemory{seed, cycles({1, 5}), cycles({6, 60, 300})};
    }
    keep_cache = one_in(2);
  }

  reference::TextureLevels make_texture(int planes) {
    reference::TextureLevels texture;
    const auto side = [&] {
      return one_in(4) ? 1 + below(4096 / 16)
                       : pick({1, 2, 3, 4, 5, 6, 7, 8, 11, 12, 13, 16, 20, 31, 32, 64, 100});
    };
    texture.width = side();
    texture.height = side();
    int most = 1;
    while (std::max(texture.width, texture.height) >> most != 0) ++most;
    texture.levels = one_in(3) ? most : 1 + below(most);
    for (int l = 0; l < texture.levels; ++l) {
      texture.base[static_cast<std::size_t>(l)] = next_line_;
      const int tiles = ((texture.level_width(l) + 3) / 4) * ((texture.level_height(l) + 3) / 4);
      next_line_ += static_cast<std::uint32_t>(tiles * planes);
    }
    return texture;
  }

  reference::Draw make_draw() {
    using namespace reference;
    Draw draw;
    draw.format = static_cast<TextureFormat>(below(5));
    draw.bilinear = !one_in(5);
    draw.mip = static_cast<Mip>(below(3));
    draw.wrap_u = one_in(2) ? Wrap::repeat : static_cast<Wrap>(below(3));
    draw.wrap_v = one_in(2) ? Wrap::repeat : static_cast<Wrap>(below(3));
    draw.color = one_in(2);
    if (draw.color) draw.combine = static_cast<Combine>(below(6));
    if (draw.format == TextureFormat::none) {
      draw.color = true;
      draw.combine = Combine::replace;
    }
    draw.color_lod = below(2048) - 1024;
    if (unit.extra_passes > 0 || unit.stages != 0) use_effects(draw);
    if (draw.format != TextureFormat::none) draw.map = make_texture(array_planes(draw, eval));
    if (draw.color) draw.color_texture = make_texture(1);
    // The same lines under two names: what duplicate_lines counts.
    if (one_in(2) && draw.color && !draws.empty() && draws[0].color) {
      draw.color_texture = draws[0].color_texture;
    }
    return draw;
  }

  /// A walk over the textures, now and then a leap.
  void make_fragments(std::size_t count) {
    const int step = pick({100, 2000, 20000, 400000});
    const int probes = pick({0, 0, 0, 1, 4});
    const int lod = pick({0, 200, 600, 4000});
    std::int32_t u = below(1 << 21) - (1 << 20), v = below(1 << 21) - (1 << 20);
    while (fragments.size() < count) {
      reference::UnitFragment f;
      u += below(step) - step / 3;
      v += one_in(8) ? below(step) : 0;
      if (one_in(60)) u = below(1 << 28) - (1 << 27);
      if (one_in(60)) v = below(1 << 28) - (1 << 27);
      u = std::clamp(u, -(1 << 28), (1 << 28) - 1);
      v = std::clamp(v, -(1 << 28), (1 << 28) - 1);
      f.u = u;
      f.v = v;
      if (one_in(10)) f.u = f.v = below(64) - 32;  // the corner where four texels meet
      f.lod = static_cast<std::uint16_t>(one_in(3) ? 0 : below(lod + 90));
      f.axis_u = below(2 * step) - step;
      f.axis_v = below(2 * step) - step;
      f.probes_log2 = static_cast<std::uint8_t>(below(probes + 1));
      f.draw = static_cast<std::uint8_t>(one_in(5) || fragments.empty()
                                             ? below(static_cast<int>(draws.size()))
                                             : fragments.back().draw);
      f.x = static_cast<std::uint16_t>(fragments.size());
      // Some fragments twice: look-ups that repeat.
      fragments.push_back(f);
      if (one_in(3)) fragments.push_back(f);
    }
  }
};

}  // namespace ptm::tests
