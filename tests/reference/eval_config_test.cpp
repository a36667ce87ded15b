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
    for (const int coef_bits : {4, 8, 10}) {
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
      EXPECT_EQ(layout.words(), static_cast<std::uint64_t>(layout.planes) * 2 * 2 * 16);
      const auto words = pack_texture(layout, texture);
      for (std::uint64_t y = 0; y < 5; ++y) {
        for (std::uint64_t x = 0; x < 7; ++x) {
          for (int plane = 0; plane < layout.planes; ++plane) {
            const bool color = !rgb && plane == 2;
            const auto fields =
                unpack_word(words[layout.word(plane, x, y)], color ? 8 : layout.field_bits);
            for (std::size_t k = 0; k < 3; ++k) {
              const std::size_t texel = y * 7 + x;
              const Value expected = color ? texture.color[texel * 3 + k]
                                           : texture.coef[texel * polynomials * 6 +
                                                          static_cast<std::size_t>(plane) * 3 + k];
              ASSERT_EQ(fields[k], expected);
            }
          }
        }
      }
    }
  }
}

TEST(TextureWords, RefuseWhatAWordOrTheAddressCannotHold) {
  EvalConfig config;
  config.coef_bits = 11;
  EXPECT_THROW((void)layout_of(config, {.width = 4, .height = 4}), std::invalid_argument);
  EXPECT_THROW((void)layout_of(kBase, {.width = 4097, .height = 4}), std::invalid_argument);
}

}  // namespace
}  // namespace ptm::reference
