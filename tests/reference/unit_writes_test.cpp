// The register writes that bring a unit to a state, read back by the contract's table.
#include <gtest/gtest.h>

#include <map>

#include "model/reference/unit/unit_memory.h"
#include "tests/reference/refusal.h"
#include "tests/reference/unit_scene.h"

namespace ptm::reference {
namespace {

using tests::UnitScene;
using tests::UnitSceneMaker;

using Registers = std::map<unsigned, std::uint32_t>;

int part(std::uint32_t word, int high, int low) {
  return static_cast<int>((word >> low) & ((1U << (high - low + 1)) - 1U));
}

/// Two's complement at [high : low].
int signed_part(std::uint32_t word, int high, int low) {
  const int value = part(word, high, low), range = 1 << (high - low + 1);
  return value >= range / 2 ? value - range : value;
}

/// A draw from its registers, as the table of unit.md reads.
Draw decode(Registers& r, unsigned d) {
  const auto at = [&](unsigned offset) { return r.at(64 * d + offset); };
  Draw draw;
  const std::uint32_t control = at(0);
  draw.format = static_cast<TextureFormat>(part(control, 2, 0));
  draw.mip = static_cast<Mip>(part(control, 4, 3));
  draw.bilinear = part(control, 5, 5) != 0;
  draw.wrap_u = static_cast<Wrap>(part(control, 7, 6));
  draw.wrap_v = static_cast<Wrap>(part(control, 9, 8));
  draw.combine = static_cast<Combine>(part(control, 12, 10));
  draw.color = part(control, 13, 13) != 0;
  draw.palette = part(control, 15, 14);
  draw.map.width = part(at(1), 12, 0);
  draw.map.height = part(at(1), 28, 16);
  draw.color_texture.width = part(at(2), 12, 0);
  draw.color_texture.height = part(at(2), 28, 16);
  draw.map.levels = part(at(3), 3, 0);
  draw.color_texture.levels = part(at(3), 11, 8);
  draw.color_lod = signed_part(at(3), 28, 16);
  for (unsigned i = 0; i < 6; ++i) {
    draw.bias[i] = part(at(4 + i), 11, 0);
    draw.shift[i] = signed_part(at(4 + i), 20, 16);
  }
  draw.ka = part(at(10), 8, 0);
  draw.kd = part(at(10), 17, 9);
  draw.ks = part(at(10), 26, 18);
  for (unsigned l = 0; l < 13; ++l) {
    draw.map.base[l] = at(16 + l);
    draw.color_texture.base[l] = at(32 + l);
  }
  return draw;
}

/// Expects the writes of a scene, and nothing else, to bring a unit to its state.
void expect_state(const UnitScene& scene) {
  const std::vector<RegisterWrite> writes = register_writes(scene.state);
  Registers registers;
  std::map<unsigned, std::uint64_t> palettes;  // with the upper bits that stood at a word's write
  std::uint64_t upper = 0;
  for (const RegisterWrite& w : writes) {
    if (w.address == 0x1005) {
      EXPECT_GT(scene.config.coef_bits, 10) << "the register is not there";
      EXPECT_LT(w.data, 16U);
      upper = w.data;
      continue;
    }
    if (w.address >= 0x4000) palettes[w.address] = upper << 32 | w.data;
    ASSERT_TRUE(registers.emplace(w.address, w.data).second) << "written twice: " << w.address;
  }
  EXPECT_EQ(upper, 0U) << "the next state begins as after reset";
  EXPECT_EQ(registers.at(0x1001), scene.state.memory.size());
  // Three coefficients a word, whatever their width, the first in the low bits.
  const unsigned bits = static_cast<unsigned>(std::max(8, scene.config.coef_bits));
  const auto word = [&](const std::vector<std::uint16_t>& coef, std::size_t n) {
    const auto at = [&](std::size_t k) { return std::uint64_t{coef[3 * n + k]}; };
    return at(0) | at(1) << bits | at(2) << (2 * bits);
  };
  for (unsigned e = 0; e < 1024; ++e) {
    for (unsigned w = 0; w < 2; ++w) {
      ASSERT_EQ(palettes.at(0x4000 + 2 * e + w),
                word(scene.lrgb_palettes[e / 256], 2 * (e % 256) + w));
    }
  }
  for (unsigned e = 0; e < 4096; ++e) {
    for (unsigned w = 0; w < 6; ++w) {
      ASSERT_EQ(palettes.at(0x8000 + 8 * e + w), word(scene.rgb_palette, 6 * e + w));
    }
  }
  for (unsigned d = 0; d < 4; ++d) EXPECT_EQ(decode(registers, d), scene.state.draws[d]);
  EXPECT_EQ(registers.size(), 1U + 1024 * 2 + 4096 * 6 + 4 * (1 + 3 + 6 + 1 + 26));
}

TEST(RegisterWrites, BringAUnitToTheStateTheyWereMadeFrom) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) expect_state(UnitSceneMaker(seed).scene());
  for (const int coef_bits : {8, 10, 11, 12}) {
    EvalConfig config;
    config.coef_bits = coef_bits;
    expect_state(UnitSceneMaker(7).scene(config));
  }
}

TEST(RegisterWrites, RefuseAPalettesWordOfMoreThan36Bits) {
  UnitState state;
  state.palettes.lrgb = {{std::uint64_t{1} << 36, 0}};
  EXPECT_EQ(tests::refusal([&] { (void)register_writes(state); }),
            "bits of a palette's word above 31 = 16, expected 0 to 15");
}

TEST(RegisterWrites, TellADrawsControlLastAndAfterTheMemorysSize) {
  const UnitScene scene = UnitSceneMaker(3).scene();
  const std::vector<RegisterWrite> writes = register_writes(scene.state);
  EXPECT_EQ(writes.front().address, 0x1001);
  for (unsigned d = 0; d < 4; ++d) {
    std::size_t control = 0, last = 0;
    for (std::size_t n = 0; n < writes.size(); ++n) {
      if (writes[n].address == 64 * d) control = n;
      if (writes[n].address >= 64 * d && writes[n].address < 64 * (d + 1)) last = n;
    }
    EXPECT_EQ(control, last) << "draw " << d;
  }
}

TEST(RegisterWrites, PassAnIllegalDrawOnButNotAValueWithoutARegister) {
  Draw draw;
  draw.map = {0, 8191, 15, {}};
  draw.format = TextureFormat{7};
  Registers registers;
  for (const RegisterWrite& w : register_writes(draw, 3)) registers[w.address] = w.data;
  EXPECT_EQ(decode(registers, 3), draw);
  EXPECT_NE(check_draw(draw, 100), 0U);

  const auto sentence = [](auto change) {
    Draw broken;
    change(broken);
    return tests::refusal([&] { (void)register_writes(broken, 0); });
  };
  EXPECT_EQ(sentence([](Draw& d) { d.map.width = 8192; }), "width = 8192, expected 0 to 8191");
  EXPECT_EQ(sentence([](Draw& d) { d.color_lod = 4096; }),
            "color_lod = 4096, expected -4096 to 4095");
  EXPECT_EQ(sentence([](Draw& d) { d.shift[3] = -17; }), "shift = -17, expected -16 to 15");
  EXPECT_EQ(sentence([](Draw& d) { d.palette = 4; }), "palette = 4, expected 0 to 3");
  EXPECT_EQ(sentence([](Draw& d) { d.ka = 512; }), "ka = 512, expected 0 to 511");
  EXPECT_EQ(sentence([](Draw& d) { d.map.base[12] = 1U << 26; }),
            "base = 67108864, expected 0 to 67108863");
  EXPECT_EQ(tests::refusal([] { (void)register_writes(Draw{}, 4); }), "draw = 4, expected 0 to 3");
}

}  // namespace
}  // namespace ptm::reference
