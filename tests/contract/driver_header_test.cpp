// The C header of the register map, used by a driver in C (driver.c), against the reference's
// registers.
#include <gtest/gtest.h>

#include <random>

#include "model/reference/unit/register_map.h"
#include "model/reference/unit/unit_counters.h"
#include "model/reference/unit/unit_memory.h"
#include "tests/contract/driver.h"

namespace ptm::reference {
namespace {

std::mt19937& rng() {
  static std::mt19937 engine(11);
  return engine;
}
int in(int low, int high) { return std::uniform_int_distribution(low, high)(rng()); }

TextureLevels random_texture() {
  TextureLevels texture{in(0, 8191), in(0, 8191), in(0, 15), {}};
  for (auto& base : texture.base) base = static_cast<std::uint32_t>(in(0, (1 << 26) - 1));
  return texture;
}

Draw random_draw() {
  Draw d;
  d.format = static_cast<TextureFormat>(in(0, 7));
  d.bilinear = in(0, 1) != 0;
  d.mip = static_cast<Mip>(in(0, 3));
  d.wrap_u = static_cast<Wrap>(in(0, 3));
  d.wrap_v = static_cast<Wrap>(in(0, 3));
  d.combine = static_cast<Combine>(in(0, 7));
  d.color = in(0, 1) != 0;
  d.color_lod = in(-4096, 4095);
  d.map = random_texture();
  d.color_texture = random_texture();
  d.palette = in(0, 3);
  d.ka = in(0, 511);
  d.kd = in(0, 511);
  d.ks = in(0, 511);
  for (std::size_t i = 0; i < 6; ++i) {
    d.bias[i] = in(0, 4095);
    d.shift[i] = in(-16, 15);
  }
  if (in(0, 1) == 0) return d;
  DrawEffects& e = d.effects;
  e.sets = in(0, 4);
  for (std::size_t s = 0; s < static_cast<std::size_t>(e.sets); ++s) {
    for (std::size_t i = 0; i < 6; ++i) {
      e.bias[s][i] = in(0, 4095);
      e.shift[s][i] = in(-16, 15);
    }
  }
  e.passes = in(0, 7);
  for (ExtraPass& pass : e.pass) pass = {in(0, 7), in(0, 1) != 0};
  e.stages = static_cast<unsigned>(in(0, 255));
  e.argument = static_cast<std::uint32_t>(rng()());
  return d;
}

driver_texture of(const TextureLevels& from) {
  driver_texture to{};
  to.width = static_cast<std::uint32_t>(from.width);
  to.height = static_cast<std::uint32_t>(from.height);
  to.levels = static_cast<std::uint32_t>(from.levels);
  std::copy(from.base.begin(), from.base.end(), to.base);
  return to;
}

driver_draw of(const Draw& d, const EffectTable& table) {
  driver_draw to{};
  const auto code = [](auto value) { return static_cast<std::uint32_t>(value); };
  to.format = code(d.format);
  to.mip = code(d.mip);
  to.bilinear = d.bilinear ? 1 : 0;
  to.wrap_u = code(d.wrap_u);
  to.wrap_v = code(d.wrap_v);
  to.combine = code(d.combine);
  to.color = d.color ? 1 : 0;
  to.palette = code(d.palette);
  to.map = of(d.map);
  to.color_texture = of(d.color_texture);
  to.color_lod = static_cast<std::int32_t>(d.color_lod);
  to.ka = code(d.ka);
  to.kd = code(d.kd);
  to.ks = code(d.ks);
  to.sets = code(d.effects.sets);
  to.passes = code(d.effects.passes);
  to.stages = d.effects.stages;
  to.argument = d.effects.argument;
  for (std::size_t i = 0; i < 6; ++i) {
    to.bias[i] = static_cast<std::int32_t>(d.bias[i]);
    to.shift[i] = static_cast<std::int32_t>(d.shift[i]);
    for (std::size_t s = 0; s < 4; ++s) {
      to.set_bias[s][i] = static_cast<std::int32_t>(d.effects.bias[s][i]);
      to.set_shift[s][i] = static_cast<std::int32_t>(d.effects.shift[s][i]);
    }
  }
  for (std::size_t k = 0; k < 4; ++k) {
    to.pass_set[k] = code(d.effects.pass[k].set);
    to.pass_half[k] = d.effects.pass[k].half ? 1 : 0;
  }
  std::copy(table.begin(), table.end(), to.table);
  return to;
}

TEST(DriverHeader, WritesADrawAsTheReferenceDoes) {
  for (int n = 0; n < 200; ++n) {
    const Draw draw = random_draw();
    EffectTable table{};
    if (draw.effects.stages != 0) {
      for (auto& entry : table) entry = static_cast<std::uint16_t>(in(0, 4095));
    }
    const std::vector<RegisterWrite> expected = register_writes(draw, n % 4, table);
    std::vector<driver_write> writes(400);
    const driver_draw given = of(draw, table);
    writes.resize(driver_writes(&given, static_cast<unsigned>(n % 4), writes.data()));
    ASSERT_EQ(writes.size(), expected.size());
    for (std::size_t i = 0; i < writes.size(); ++i) {
      ASSERT_EQ(writes[i].address, expected[i].address) << i;
      ASSERT_EQ(writes[i].data, expected[i].data) << "address " << writes[i].address;
    }
  }
}

TEST(DriverHeader, ReadsWhatTheUnitIsBuiltWith) {
  const EvalConfig config{.coef_bits = 10, .guard = 11, .shift_min = -7};
  const UnitConfig unit{.tmus = 2, .cache_kib = 64, .miss_fifo = 256, .stages = 0xa5};
  const auto words = capability_words(config, unit);
  const driver_unit read = driver_capabilities(words.data());
  EXPECT_EQ(read.tmus, 2U);
  EXPECT_EQ(read.cache_kib, 64U);
  EXPECT_EQ(read.miss_fifo, 256U);
  EXPECT_EQ(read.stages, 0xa5U);
  EXPECT_EQ(read.draws, 4U);
  EXPECT_EQ(read.coef_bits, 10U);
  EXPECT_EQ(read.guard, 11U);
  EXPECT_EQ(read.shift_min, -7);
}

TEST(DriverHeader, KnowsTheUnitBySignatureAndMajorVersion) {
  EXPECT_TRUE(driver_knows(kRegisterMagic, kRegisterMapVersion));
  EXPECT_TRUE(driver_knows(kRegisterMagic, kRegisterMapVersion + 1)) << "another minor version";
  EXPECT_FALSE(driver_knows(kRegisterMagic, kRegisterMapVersion + 0x10000));
  EXPECT_FALSE(driver_knows(kRegisterMagic ^ 1, kRegisterMapVersion));
}

TEST(DriverHeader, ExtendsSignsAndFindsWhatRepeats) {
  EXPECT_EQ(driver_color_lod(0x1fff0000U), -1);
  EXPECT_EQ(driver_color_lod(0x10000f0fU), -4096);
  EXPECT_EQ(driver_color_lod(0xefffffffU), 4095);
  for (unsigned d = 0; d < 4; ++d)
    EXPECT_EQ(driver_errors(0x0a040208U, d), 0x0a040208U >> 8 * d & 15U);
  EXPECT_EQ(driver_counter_high(37), 0x2000U + 2 * 37 + 1);
  EXPECT_EQ(driver_counter_of_cycles(), 2U);
}

/// Drivers in the field know the numbers: a table that moves one breaks them, and all models with
/// it in the same way.
TEST(DriverHeader, NumbersCountersAndCodesAsItAlwaysHas) {
  const std::vector<std::string_view> shared{"fragments",
                                             "pixels",
                                             "cycles",
                                             "cycles_moved",
                                             "cycles_output_blocked",
                                             "cycles_line_wait",
                                             "cycles_ring_full",
                                             "cycles_input_empty",
                                             "beats",
                                             "bank_conflicts",
                                             "words",
                                             "taps",
                                             "tag_hits",
                                             "tag_misses",
                                             "lines_read",
                                             "duplicate_lines",
                                             "palette_lookups",
                                             "multiplies_address",
                                             "multiplies_filter",
                                             "multiplies_eval",
                                             "multiplies_combine"};
  for (std::size_t n = 0; n < shared.size(); ++n) EXPECT_EQ(unit_counter_names()[n], shared[n]);
  for (unsigned d = 0; d < 4; ++d) {
    for (unsigned t = 0; t < 2; ++t) {
      const std::string of = "_d" + std::to_string(d) + (t == 0 ? "_map" : "_color");
      EXPECT_EQ(unit_counter_names()[21 + 4 * d + 2 * t], "hits" + of);
      EXPECT_EQ(unit_counter_names()[22 + 4 * d + 2 * t], "misses" + of);
    }
  }
  EXPECT_EQ(unit_counter_names()[37], "multiplies_effects");

  const auto code = [](auto value) { return static_cast<int>(value); };
  EXPECT_EQ(code(TextureFormat::none), 0);
  EXPECT_EQ(code(TextureFormat::lrgb), 1);
  EXPECT_EQ(code(TextureFormat::rgb), 2);
  EXPECT_EQ(code(TextureFormat::palette_lrgb), 3);
  EXPECT_EQ(code(TextureFormat::palette_rgb), 4);
  EXPECT_EQ(code(Mip::nearest), 1);
  EXPECT_EQ(code(Mip::linear), 2);
  EXPECT_EQ(code(Wrap::mirror), 1);
  EXPECT_EQ(code(Wrap::clamp), 2);
  EXPECT_EQ(code(Combine::modulate), 1);
  EXPECT_EQ(code(Combine::decal), 2);
  EXPECT_EQ(code(Combine::blend), 3);
  EXPECT_EQ(code(Combine::add), 4);
  EXPECT_EQ(code(Combine::replace), 5);
}

}  // namespace
}  // namespace ptm::reference
