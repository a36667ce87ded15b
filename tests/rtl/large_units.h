#pragma once
#include "tests/rtl/drive_frame.h"
#include "tests/rtl/exact_frames.h"

/// Scenes for units that are as large as they may be.
namespace ptm::tests {

inline constexpr int kLargeTiles = 32;  ///< across and down: 1,024 lines of each word, 64 KiB

/// Random draws, of which the first is an LRGB map of 256 x 256 texels, the second a colour texture
/// of as many, and the third a palettised map with that texture, which another TMU then fetches.
inline UnitScene make_large_scene(UnitSceneMaker& make, const testbench::RtlUnitVariant& variant) {
  UnitScene scene = make.scene(variant.config, variant.unit);
  constexpr int kSide = 256;
  const auto fill = [&make](auto& values, std::size_t count, int most) {
    values.resize(count);
    for (auto& v : values) v = static_cast<std::decay_t<decltype(v)>>(make.in(0, most));
  };
  reference::StoredTexture map{kSide, kSide, false, {}, {}, {}, {}};
  fill(map.coef, std::size_t{kSide} * kSide * 6, (1 << variant.config.coef_bits) - 1);
  fill(map.color, std::size_t{kSide} * kSide * 3, 255);
  reference::Draw draw = scene.state.draws[0];
  draw.effects = {};
  draw.format = reference::TextureFormat::lrgb;
  draw.combine = reference::Combine::none;
  draw.color = false;
  draw.bilinear = true;
  draw.mip = reference::Mip::none;
  draw.wrap_u = draw.wrap_v = reference::Wrap::repeat;
  draw.map = append_map(variant.config, std::span(&map, 1), scene.state.memory);
  scene.state.draws[0] = draw;
  reference::StoredPicture picture{kSide, kSide, {}};
  fill(picture.rgba, std::size_t{kSide} * kSide * 4, 255);
  draw.format = reference::TextureFormat::none;
  draw.combine = reference::Combine::replace;
  draw.color = true;
  draw.map = {};
  draw.color_texture = append_picture(std::span(&picture, 1), scene.state.memory);
  scene.state.draws[1] = draw;
  reference::StoredPaletteMap indices{kSide, kSide, false, {}, {}};
  fill(indices.index, std::size_t{kSide} * kSide, 255);
  fill(indices.color, std::size_t{kSide} * kSide * 3, 255);
  draw.format = reference::TextureFormat::palette_lrgb;
  draw.combine = reference::Combine::modulate;
  draw.map = append_palette_map(std::span(&indices, 1), scene.state.memory);
  scene.state.draws[2] = draw;
  return scene;
}

/// A fragment amid texels of that tile of one of the first three draws' textures.
inline reference::UnitFragment in_tile(int across, int down, int draw) {
  reference::UnitFragment f;
  f.u = (16 * across + 7) << 10;  // between texels 1 and 2 of the tile
  f.v = (16 * down + 7) << 10;
  f.lu = 8 * across;
  f.lv = -8 * down;
  f.lit = true;
  f.draw = static_cast<std::uint8_t>(draw);
  f.x = static_cast<std::uint16_t>(across);
  f.y = static_cast<std::uint16_t>(down);
  return f;
}

/// Every tile that 64 KiB hold, row by row.
inline std::vector<reference::UnitFragment> sweep(int draw) {
  std::vector<reference::UnitFragment> fragments;
  for (int down = 0; down < kLargeTiles; ++down) {
    for (int across = 0; across < kLargeTiles; ++across) {
      fragments.push_back(in_tile(across, down, draw));
    }
  }
  return fragments;
}

/// First as many lines after each other as the ring may hold; then leaps over the large textures
/// and all draws, and walks that hit.
inline std::vector<reference::UnitFragment> large_fragments(UnitSceneMaker& make,
                                                            const UnitScene& scene,
                                                            std::size_t count) {
  std::vector<reference::UnitFragment> fragments = sweep(0);
  fragments.resize(256);
  const auto walks = random_fragments(make, scene, count / 2);
  fragments.insert(fragments.end(), walks.begin(), walks.end());
  while (fragments.size() < count) {
    fragments.push_back(in_tile(make.in(0, 31), make.in(0, 31), make.in(0, 2)));
    for (int n = make.in(0, 9); n > 0 && fragments.size() < count; --n) {
      fragments.push_back(fragments.back());
      fragments.back().u += make.in(-3000, 3000);
    }
  }
  return fragments;
}

/// A memory that answers so late that the ring before it fills; outputs that block it.
inline constexpr pipeline::Cycle kLate = 5000;
inline const std::array<Condition, 2> kFillingConditions{
    {{"LateMemory", pipeline::FixedMemory{.latency = kLate, .interval = 1}, {}},
     {"StallsAndGaps",
      pipeline::RandomMemory{.seed = 6, .latency_max = 600},
      {.seed = 7, .input_gap = 0.1, .output_stall = 0.7}}}};

/// Random frames, cold and with the cache kept, equal the reference and `exact`; with the late
/// memory the ring fills before the first answer comes.
inline void expect_large_unit_exact(const testbench::RtlUnitVariant& variant,
                                    const Condition& condition, std::uint64_t seed) {
  UnitSceneMaker make(seed);
  const UnitScene scene = make_large_scene(make, variant);
  const auto fragments = large_fragments(make, scene, 1500);
  expect_same_frames(variant, condition, scene, fragments);
  if (condition.timing.output_stall > 0) return;
  const auto unit = variant.make();
  unit->load(scene.state);
  const auto memory = make_memory(condition.memory);
  const auto result = unit->run({.fragments = fragments}, *memory, condition.timing);
  // What was asked for before the first answer came is what the ring holds, a rank more or less.
  ASSERT_FALSE(result.answered.empty());
  const auto at_first = static_cast<std::size_t>(std::ranges::count_if(
      result.answered, [&](pipeline::Cycle c) { return c < result.answered[0] + kLate; }));
  const auto ring = static_cast<std::size_t>(variant.unit.miss_fifo);
  EXPECT_LE(at_first, ring);
  EXPECT_GT(at_first + static_cast<std::size_t>(variant.unit.tmus), ring);
  if (variant.unit.tmus > 1) {
    EXPECT_GT(result.counters[UnitCounter::duplicate_lines], 0U);
  }
}

/// How often the first TMU's cache is asked in vain for the lines of a texture of 64 KiB that was
/// just drawn: at least 1,024 less what the cache holds.
inline std::uint64_t misses_of_a_second_sweep(const testbench::RtlUnitVariant& variant) {
  UnitSceneMaker make(8);
  const UnitScene scene = make_large_scene(make, variant);
  const auto unit = variant.make();
  unit->load(scene.state);
  const auto memory = make_memory(pipeline::FixedMemory{.latency = 20, .interval = 1});
  const auto fragments = sweep(1);
  (void)unit->run({.fragments = fragments}, *memory, {});
  const auto again = unit->run({.fragments = fragments, .keep_cache = true}, *memory, {});
  expect_pixels(scene, fragments, again.pixels);
  return again.counters[UnitCounter::tag_misses];
}

/// Fragments of one beat that are accepted while no pixel is taken; then all are drawn.
inline std::size_t accepted_while_blocked(const testbench::RtlUnitVariant& variant) {
  UnitSceneMaker make(9);
  const UnitScene scene = make_large_scene(make, variant);
  const auto unit = variant.make();
  unit->load(scene.state);
  unit->write(0x1000, 3);
  std::vector<reference::UnitFragment> fragments;  // eight lines: else the ring fills, not the FIFO
  for (int n = 0; n < 1500; ++n) fragments.push_back(in_tile(n % 8, 0, 1));
  const Drive drive{.blocked = 6000, .latency_max = 3};
  const DrivenFrame frame = drive_frame(*unit, scene.state, fragments, 256, drive);
  expect_pixels(scene, fragments, frame.pixels);
  return static_cast<std::size_t>(std::ranges::count_if(
      frame.accepted, [&drive](std::uint64_t cycle) { return cycle < drive.blocked; }));
}

/// Tags of the requests that leave while nothing is answered.
inline std::vector<std::uint8_t> asked_without_answers(const testbench::RtlUnitVariant& variant) {
  UnitSceneMaker make(10);
  const UnitScene scene = make_large_scene(make, variant);
  const auto unit = variant.make();
  unit->load(scene.state);
  unit->write(0x1000, 3);
  std::vector<reference::UnitFragment> fragments = sweep(0);
  for (std::size_t n = 0; n < fragments.size(); n += 2) fragments[n].draw = 1;  // ranks of one line
  const Drive drive{.limit = 2000, .latency_max = 1'000'000};
  return drive_frame(*unit, scene.state, fragments, 256, drive).requests;
}

}  // namespace ptm::tests
