// The registers' map: what each parameter does to the capability words, and that the bits which
// can be read back are those that a state's writes use.
#include "model/reference/unit/register_map.h"

#include <gtest/gtest.h>

#include <bit>

#include "model/reference/unit/unit_memory.h"
#include "tests/reference/unit_scene.h"

namespace ptm::reference {
namespace {

/// A field of a capability word: docs/spec/unit.md, "Identification and capabilities".
struct CapabilityField {
  const char* name;
  unsigned word, high, low;
};

unsigned part(const std::array<std::uint32_t, kCapabilityWords>& words, const CapabilityField& f) {
  return words[f.word] >> f.low & ((2U << (f.high - f.low)) - 1U);
}

TEST(CapabilityWords, OfTheBaseUnitAreThoseOfThePage) {
  const std::array<std::uint32_t, kCapabilityWords> expected{
      0x31141023,   // 3 TMUs, 2 ways, 16 KiB, 4 ports, 1 port, 1 evaluator, counters
      0x004000c0,   // 192 beats, 64 lines
      0x00000000,   //
      0x413f771f,   // formats 0 to 4, mip 0 to 2, wrap 0 to 2, combine 0 to 5, bilinear, 16 probes
      0xd40d1000,   // 4096 texels, 13 levels, 4 draws, 26 bits of a line
      0x00000c84,   // 4 palettes of 256, one of 4096
      0x14088298,   // 8, 9, 2.8, 8, 4, nearest
      0x00006c0a};  // 10, 0, -4, 6, 0
  EXPECT_EQ(capability_words(kBase, {}), expected);
}

TEST(CapabilityWords, HoldEveryParameterAtBothEndsOfItsRange) {
  EvalConfig low{.coef_bits = 4,
                 .delta_bits = 5,
                 .light_int = 1,
                 .light_frac = 4,
                 .basis_frac = 4,
                 .guard = 0,
                 .rounding = Rounding::truncate,
                 .lum_bits = 8,
                 .lum_frac = 0,
                 .shift_min = -8,
                 .shift_groups = 3,
                 .filter_frac = 0};
  EvalConfig high{.coef_bits = 12,
                  .delta_bits = 13,
                  .light_int = 3,
                  .light_frac = 14,
                  .basis_frac = 28,
                  .guard = 12,
                  .rounding = Rounding::nearest,
                  .lum_bits = 12,
                  .lum_frac = 4,
                  .shift_min = 0,
                  .shift_groups = 6,
                  .filter_frac = 4};
  const UnitConfig small{.tmus = 1,
                         .cache_kib = 1,
                         .ways = 1,
                         .fragment_fifo = 4,
                         .miss_fifo = 4,
                         .palette_lrgb_ports = 1,
                         .palette_rgb_ports = 1,
                         .eval_lanes = 1,
                         .counters = false,
                         .duplicate_lines = false};
  const UnitConfig large{.tmus = 3,
                         .cache_kib = 64,
                         .ways = 4,
                         .fragment_fifo = 1024,
                         .miss_fifo = 256,
                         .palette_lrgb_ports = 4,
                         .palette_rgb_ports = 4,
                         .eval_lanes = 3,
                         .extra_sets = 4,
                         .extra_passes = 4,
                         .half_vector = true,
                         .stages = 255};
  struct Case {
    CapabilityField field;
    unsigned low, high;
  };
  const std::array<Case, 26> cases{{{{"Tmus", 0, 1, 0}, 1, 3},
                                    {{"Ways", 0, 6, 4}, 1, 4},
                                    {{"CacheKib", 0, 14, 8}, 1, 64},
                                    {{"PaletteLrgbPorts", 0, 18, 16}, 1, 4},
                                    {{"PaletteRgbPorts", 0, 22, 20}, 1, 4},
                                    {{"EvalLanes", 0, 25, 24}, 1, 3},
                                    {{"Counters", 0, 28, 28}, 0, 1},
                                    {{"DuplicateLines", 0, 29, 29}, 0, 1},
                                    {{"FragmentFifo", 1, 10, 0}, 4, 1024},
                                    {{"MissFifo", 1, 24, 16}, 4, 256},
                                    {{"ExtraSets", 2, 2, 0}, 0, 4},
                                    {{"ExtraPasses", 2, 6, 4}, 0, 4},
                                    {{"HalfVector", 2, 8, 8}, 0, 1},
                                    {{"Stages", 2, 23, 16}, 0, 255},
                                    {{"CoefBits", 6, 3, 0}, 4, 12},
                                    {{"DeltaBits", 6, 7, 4}, 5, 13},
                                    {{"LightInt", 6, 9, 8}, 1, 3},
                                    {{"LightFrac", 6, 15, 12}, 4, 14},
                                    {{"BasisFrac", 6, 20, 16}, 4, 28},
                                    {{"Guard", 6, 27, 24}, 0, 12},
                                    {{"RoundNearest", 6, 28, 28}, 0, 1},
                                    {{"LumBits", 7, 3, 0}, 8, 12},
                                    {{"LumFrac", 7, 6, 4}, 0, 4},
                                    {{"ShiftMin", 7, 11, 8}, 8, 0},  // -8 in four bits
                                    {{"ShiftGroups", 7, 14, 12}, 3, 6},
                                    {{"FilterFrac", 7, 18, 16}, 0, 4}}};
  const auto lowest = capability_words(low, small), highest = capability_words(high, large);
  for (const Case& c : cases) {
    EXPECT_EQ(part(lowest, c.field), c.low) << c.field.name;
    EXPECT_EQ(part(highest, c.field), c.high) << c.field.name;
  }
}

/// Of a unit that has everything, each bit that a write of random draws sets can be read back; and
/// every register that can be read back is written for them.
TEST(StoredBits, AreThoseThatTheWritesOfDrawsUse) {
  const UnitConfig all{.extra_sets = 4, .extra_passes = 4, .half_vector = true, .stages = 255};
  std::array<std::uint32_t, 0x10000> seen{};
  std::mt19937 rng(5);
  const auto in = [&rng](int low, int high) {
    return std::uniform_int_distribution(low, high)(rng);
  };
  for (int n = 0; n < 400; ++n) {
    Draw d;
    d.format = static_cast<TextureFormat>(in(0, 7));
    d.bilinear = in(0, 1) != 0;
    d.mip = static_cast<Mip>(in(0, 3));
    d.wrap_u = static_cast<Wrap>(in(0, 3));
    d.wrap_v = static_cast<Wrap>(in(0, 3));
    d.combine = static_cast<Combine>(in(0, 7));
    d.color = in(0, 1) != 0;
    d.color_lod = in(-4096, 4095);
    for (TextureLevels* t : {&d.map, &d.color_texture}) {
      *t = {in(0, 8191), in(0, 8191), in(0, 15), {}};
      for (auto& base : t->base) base = static_cast<std::uint32_t>(in(0, (1 << 26) - 1));
    }
    d.palette = in(0, 3);
    d.ka = in(0, 511);
    d.kd = in(0, 511);
    d.ks = in(0, 511);
    for (std::size_t i = 0; i < 6; ++i) {
      d.bias[i] = in(0, 4095);
      d.shift[i] = in(-16, 15);
      for (std::size_t s = 0; s < 4; ++s) {
        d.effects.bias[s][i] = in(0, 4095);
        d.effects.shift[s][i] = in(-16, 15);
      }
    }
    d.effects.sets = in(0, 7);
    d.effects.passes = in(0, 7);
    for (ExtraPass& pass : d.effects.pass) pass = {in(0, 7), in(0, 1) != 0};
    d.effects.stages = static_cast<unsigned>(in(0, 255));
    d.effects.argument = static_cast<std::uint32_t>(rng());
    for (const RegisterWrite& w : register_writes(d, n % 4)) seen[w.address] |= w.data;
  }
  for (unsigned address = 0; address < registers::kTables; ++address) {
    if (address == registers::kMemoryLines || address == registers::kMemoryBase ||
        address == registers::kEnable) {
      continue;
    }
    EXPECT_EQ(stored_bits(static_cast<std::uint16_t>(address), all), seen[address]) << address;
  }
  EXPECT_EQ(stored_bits(registers::kMemoryLines, all), 0x7ffffffU);
  EXPECT_EQ(stored_bits(registers::kMemoryBase, all), 0x3ffffffU);
}

TEST(StoredBits, AreNoneOfWhatIsNotBuiltIn) {
  for (unsigned d = 0; d < 4; ++d) {
    for (const unsigned at : {12U, 13U, 14U, 0x2800U - 32 * d}) {
      EXPECT_EQ(stored_bits(static_cast<std::uint16_t>(64 * d + at), {}), 0U) << d << ' ' << at;
    }
  }
  const UnitConfig passes{.extra_passes = 2};
  EXPECT_EQ(stored_bits(12, passes), 0xff7U);
  EXPECT_EQ(stored_bits(13, passes), 0U);
  const UnitConfig sets{.extra_sets = 1, .extra_passes = 1};
  EXPECT_EQ(stored_bits(13, sets), 7U);
  EXPECT_EQ(stored_bits(0x2805, sets), 0x1f0fffU);
  EXPECT_EQ(stored_bits(0x2806, sets), 0U);
  EXPECT_EQ(stored_bits(0x2808, sets), 0U);
  EXPECT_EQ(stored_bits(0x1005, {}, {.coef_bits = 10}), 0U);
  EXPECT_EQ(stored_bits(0x1005, {}, {.coef_bits = 11}), 15U);
  const UnitConfig stages{.stages = 4};
  EXPECT_EQ(stored_bits(13, stages), 0xff00U);
  EXPECT_EQ(stored_bits(14, stages), 0xffffffffU);
}

}  // namespace
}  // namespace ptm::reference
