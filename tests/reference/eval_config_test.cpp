#include <gtest/gtest.h>

#include <stdexcept>

#include "model/reference/evaluate.h"
#include "model/reference/texture_words.h"

namespace ptm::reference {
namespace {

TEST(EvalConfig, OfEveryPresetIsInRange) {
  for (const Preset& preset : kPresets) EXPECT_NO_THROW(validate(preset.config)) << preset.name;
}

TEST(EvalConfig, OutOfRangeNamesTheFieldTheValueAndTheRange) {
  EvalConfig config;
  config.basis_frac = 17;
  try {
    validate(config);
    FAIL() << "17 fraction bits of an 8-bit light's square were accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "basis_frac = 17, expected 4 to 16");
  }
}

TEST(EvalConfig, UnknownPresetListsTheKnownOnes) {
  try {
    (void)find_preset("medium");
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "preset 'medium', expected one of paper8, base, wide");
  }
}

TEST(TextureWords, GiveBackEveryFieldFromItsOwnAddress) {
  for (const bool rgb : {false, true}) {
    for (const int coef_bits : {4, 8, 10, 11, 12}) {
      EvalConfig config;
      config.coef_bits = coef_bits;
      StoredTexture texture{.width = 7, .height = 5, .rgb = rgb};
      const std::size_t polynomials = rgb ? 3 : 1;
      for (std::size_t i = 0; i < 35 * polynomials * 6; ++i) {
        texture.coef.push_back(static_cast<std::uint16_t>((i * 37) % (1U << coef_bits)));
      }
      for (std::size_t i = 0; i < 35 * 3; ++i) {
        texture.color.push_back(static_cast<std::uint8_t>(i * 11));
      }
      const TextureLayout layout = layout_of(config, texture);
      EXPECT_EQ(layout.planes, coef_bits > 10 ? (rgb ? 9 : 4) : (rgb ? 6 : 3));
      EXPECT_EQ(layout.words(), static_cast<std::uint64_t>(layout.planes) * 2 * 2 * 16);
      const auto words = pack_texture(layout, texture);
      for (std::uint64_t y = 0; y < 5; ++y) {
        for (std::uint64_t x = 0; x < 7; ++x) {
          for (int plane = 0; plane < layout.planes; ++plane) {
            const std::uint32_t word = words[layout.word(plane, x, y)];
            const std::size_t a_word = coef_bits > 10 ? 2 : 3, texel = y * 7 + x;
            const bool color = !rgb && plane == static_cast<int>(6 / a_word);
            for (std::size_t k = 0; k < (color ? 3 : a_word); ++k) {
              const std::size_t n = static_cast<std::size_t>(plane) * a_word + k;
              const Value expected =
                  color ? texture.color[texel * 3 + k] : texture.coef[texel * polynomials * 6 + n];
              ASSERT_EQ(word_field(word, static_cast<int>(k), color ? 8 : std::max(8, coef_bits)),
                        expected);
            }
          }
        }
      }
    }
  }
}

TEST(TextureWords, RefuseWhatTheAddressCannotHold) {
  EXPECT_THROW((void)layout_of(kBase, {.width = 4097, .height = 4}), std::invalid_argument);
}

}  // namespace
}  // namespace ptm::reference
