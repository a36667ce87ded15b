#pragma once
#include <gtest/gtest.h>

#include <numeric>
#include <string>
#include <vector>

#include "model/pipeline/memory_timing.h"
#include "model/reference/unit/shade.h"
#include "testbench/rtl/unit_variants.h"
#include "tests/reference/unit_scene.h"

/// Frames for the RTL unit and what to expect of them.
namespace ptm::tests {

using reference::UnitCounter;

/// The presets' units and the small one.
inline std::vector<testbench::RtlUnitVariant> unit_variants() {
  const auto variants = testbench::rtl_unit_variants();
  return {variants.begin(), variants.end()};
}

/// Those with something that effects need.
inline std::vector<testbench::RtlUnitVariant> effect_variants() {
  std::vector<testbench::RtlUnitVariant> out;
  for (const auto& variant : unit_variants()) {
    if (variant.unit.extra_passes > 0) out.push_back(variant);
  }
  return out;
}

/// Biases and shifts with which luminances spread over the levels; with those of a random scene
/// most lie at either end, and a value that is another pass's goes unseen.
inline void spread_luminance(UnitScene& scene) {
  const reference::Value middle = reference::Value{1} << (scene.config.coef_bits - 1);
  const reference::Six<reference::Value> bias{middle, middle, middle, middle, middle, 0};
  for (reference::Draw& draw : scene.state.draws) {
    draw.bias = bias;
    draw.shift = {3, 3, 3, 2, 2, 0};
    for (std::size_t s = 0; s < static_cast<std::size_t>(draw.effects.sets); ++s) {
      draw.effects.bias[s] = bias;
      draw.effects.bias[s][5] = static_cast<reference::Value>(8 * s);
      draw.effects.shift[s] = {3, 3, 3, 2, 2, static_cast<reference::Value>(s / 2)};
    }
  }
}

/// Fragments that jump, and runs of them that walk, so that lines are missed and hit.
inline std::vector<reference::UnitFragment> random_fragments(UnitSceneMaker& make,
                                                             const UnitScene& scene,
                                                             std::size_t count) {
  std::vector<reference::UnitFragment> fragments;
  while (fragments.size() < count) {
    if (fragments.empty() || make.in(0, 3) == 0) {
      fragments.push_back(make.fragment(scene));
      continue;
    }
    reference::UnitFragment f = fragments.back();
    constexpr int kLimit = (1 << 28) - (1 << 15);
    f.u = std::clamp(f.u + make.in(-20000, 20000), -kLimit, kLimit);
    f.v = std::clamp(f.v + make.in(-20000, 20000), -kLimit, kLimit);
    f.x = static_cast<std::uint16_t>((f.x + 1) % 16384);
    fragments.push_back(f);
  }
  return fragments;
}

/// What must hold of any frame's counters in that unit.
inline void expect_sound(const reference::UnitCounters& c, std::size_t fragments,
                         const reference::UnitConfig& unit) {
  for (std::size_t n = 0; n < reference::kUnitCounters; ++n) {
    if (has_counter(unit, n)) continue;
    EXPECT_EQ(c.value[n], 0U) << reference::unit_counter_names()[n];
  }
  if (!unit.counters) return;
  EXPECT_EQ(c[UnitCounter::fragments], fragments);
  EXPECT_EQ(c[UnitCounter::pixels], fragments);
  EXPECT_EQ(c[UnitCounter::cycles_moved] + c[UnitCounter::cycles_output_blocked] +
                c[UnitCounter::cycles_line_wait] + c[UnitCounter::cycles_ring_full] +
                c[UnitCounter::cycles_input_empty],
            c[UnitCounter::cycles]);
  EXPECT_EQ(c[UnitCounter::beats], c[UnitCounter::cycles_moved]);
  EXPECT_EQ(c[UnitCounter::lines_read], c[UnitCounter::tag_misses]);
  std::uint64_t hits = 0, misses = 0;
  const auto first = static_cast<std::size_t>(reference::kFirstTextureCounter);
  for (std::size_t n = first; n < first + 4 * reference::kDraws; n += 2) {
    hits += c.value[n];
    misses += c.value[n + 1];
  }
  EXPECT_EQ(hits, c[UnitCounter::tag_hits]);
  EXPECT_EQ(misses, c[UnitCounter::tag_misses]);
}

inline void expect_pixels(const UnitScene& scene,
                          const std::vector<reference::UnitFragment>& fragments,
                          const std::vector<reference::UnitPixel>& pixels) {
  ASSERT_EQ(pixels.size(), fragments.size());
  std::vector<reference::UnitPixel> expected(fragments.size());
  shade_all(scene.config, scene.state, fragments, expected);
  std::size_t wrong = 0;
  for (std::size_t n = 0; n < pixels.size(); ++n) {
    if (pixels[n] == expected[n]) continue;
    if (++wrong > 3) continue;
    const auto text = [](const reference::UnitPixel& p) {
      return std::to_string(p.x) + ',' + std::to_string(p.y) + ": " + std::to_string(p.rgb[0]) +
             ' ' + std::to_string(p.rgb[1]) + ' ' + std::to_string(p.rgb[2]) + ' ' +
             std::to_string(p.alpha) + ' ' + std::to_string(p.lum_saturated) +
             std::to_string(p.color_saturated);
    };
    ADD_FAILURE() << "fragment " << n << " (" << describe(fragments[n]) << "): " << text(pixels[n])
                  << ", expected " << text(expected[n]);
  }
  EXPECT_EQ(wrong, 0U);
}

}  // namespace ptm::tests
