#include <gtest/gtest.h>

#include "model/pipeline/simulate.h"

namespace ptm::pipeline {
namespace {

using reference::Fragment;
using reference::StoredTexture;

StoredTexture make_texture(int width, int height, bool rgb) {
  StoredTexture texture{.width = width, .height = height, .rgb = rgb};
  const auto texels = static_cast<std::size_t>(width * height);
  for (std::size_t i = 0; i < texels * (rgb ? 18 : 6); ++i) {
    texture.coef.push_back(static_cast<std::uint16_t>((i * 73 + 11) % 256));
  }
  for (std::size_t i = 0; !rgb && i < texels * 3; ++i) {
    texture.color.push_back(static_cast<std::uint8_t>(i * 29 + 5));
  }
  texture.bias = {100, 120, 90, 128, 127, 0};
  texture.shift = {-1, 0, 1, 0, -1, 0};
  return texture;
}

std::vector<Fragment> fragments_over(int width, int height) {
  std::vector<Fragment> fragments;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      fragments.push_back(*quantize_fragment(reference::kBase, x, y,
                                             {(x + 0.5) / width, (y + 0.5) / height, 0.3, -0.4}));
    }
  }
  return fragments;
}

std::vector<FrameResult> simulate(const UnitConfig& unit, const StoredTexture& texture,
                                  const std::vector<std::vector<Fragment>>& frames,
                                  const StreamTiming& timing = {},
                                  const reference::EvalConfig& config = reference::kBase) {
  std::vector<FrameResult> results;
  const FrameStream stream{frames.size(),
                           [&](std::size_t n) { return std::span<const Fragment>(frames[n]); },
                           [&](std::size_t, FrameResult&& r) { results.push_back(std::move(r)); }};
  simulate_unit(config, unit, texture, stream, timing);
  return results;
}

struct Rate {
  int tmus;
  bool rgb;
  std::uint64_t cycles_a_pixel, first_operand;
};

class FlatUnit : public testing::TestWithParam<Rate> {};

TEST_P(FlatUnit, TakesTheCyclesThatWordsAndPassesCallFor) {
  const Rate rate = GetParam();
  const auto texture = make_texture(13, 9, rate.rgb);
  const std::vector<std::vector<Fragment>> frames{fragments_over(13, 9)};
  const auto results = simulate({rate.tmus}, texture, frames);
  ASSERT_EQ(results.size(), 1U);
  const FrameResult& frame = results[0];
  EXPECT_EQ(frame.first_operand, rate.first_operand);
  const std::uint64_t passes = rate.rgb ? 3 : 1;
  for (std::size_t n = 0; n < frame.cycles.size(); ++n) {
    ASSERT_EQ(frame.cycles[n], rate.first_operand + passes - 1 + 8 + n * rate.cycles_a_pixel);
  }
  EXPECT_EQ(frame.words_fetched, 13U * 9 * (rate.rgb ? 6 : 3));
  EXPECT_EQ(frame.total_cycles, frame.cycles.back() + 1);
}

INSTANTIATE_TEST_SUITE_P(Formats, FlatUnit,
                         testing::Values(Rate{3, false, 1, 4}, Rate{2, false, 2, 5},
                                         Rate{1, false, 3, 6}, Rate{3, true, 3, 5},
                                         Rate{2, true, 3, 6}, Rate{1, true, 6, 9}));

TEST(FlatUnit, GivesTheReferencesPixelsThroughWordsInMemory) {
  const auto texture = make_texture(13, 9, false);
  const std::vector<std::vector<Fragment>> frames{fragments_over(13, 9)};
  const auto frame = simulate({2}, texture, frames, {9, 0.4, 0.4}).front();
  for (std::size_t n = 0; n < frame.pixels.size(); ++n) {
    const Fragment& f = frames[0][n];
    const auto trace = evaluate_lrgb(reference::kBase, lrgb_operands(texture, n, f.lu, f.lv));
    for (std::size_t c = 0; c < 3; ++c) {
      ASSERT_EQ(frame.pixels[n].out[c], trace.color.out[c]) << "texel " << n;
    }
    ASSERT_EQ(frame.pixels[n].lum[0], trace.luminance.lum.lum);
  }
}

/// Coefficients of more than ten bits, two a word: width and the number of polynomials.
class WideCoefficients : public testing::TestWithParam<std::tuple<int, bool>> {};

TEST_P(WideCoefficients, GiveTheReferencesPixelsAndTakeAWordMoreForEachPolynomial) {
  const auto [coef_bits, rgb] = GetParam();
  reference::EvalConfig config;
  config.coef_bits = coef_bits;
  config.delta_bits = coef_bits + 1;
  StoredTexture texture = make_texture(13, 9, rgb);
  for (std::size_t i = 0; i < texture.coef.size(); ++i) {
    texture.coef[i] = static_cast<std::uint16_t>((i * 1973 + 11) % (1U << coef_bits));
  }
  texture.bias = {1700, 2000, 1500, 2040, 2030, 0};
  texture.shift = {4, 4, 5, 4, 3, 4};
  const std::vector<std::vector<Fragment>> frames{fragments_over(13, 9)};
  const auto frame = simulate({3}, texture, frames, {}, config).front();
  EXPECT_EQ(frame.words_fetched, 13U * 9 * (rgb ? 9 : 4));
  const std::uint64_t cycles_a_pixel = rgb ? 3 : 2;  // beats of three words
  EXPECT_EQ(frame.first_operand, 3 + cycles_a_pixel);
  for (std::size_t n = 0; n < frame.pixels.size(); ++n) {
    ASSERT_EQ(frame.cycles[n] - frame.cycles[0], n * cycles_a_pixel);
    const Fragment& f = frames[0][n];
    const auto out = rgb ? evaluate_rgb(config, rgb_operands(texture, n, f.lu, f.lv)).color.out
                         : evaluate_lrgb(config, lrgb_operands(texture, n, f.lu, f.lv)).color.out;
    for (std::size_t c = 0; c < 3; ++c) ASSERT_EQ(frame.pixels[n].out[c], out[c]) << "texel " << n;
  }
}

INSTANTIATE_TEST_SUITE_P(Widths, WideCoefficients,
                         testing::Combine(testing::Values(11, 12), testing::Bool()));

TEST(FlatUnit, GivesTheReferencesPixelsOfAnRgbMapInEveryFrame) {
  const auto texture = make_texture(7, 5, true);
  const std::vector<std::vector<Fragment>> frames{fragments_over(7, 5), fragments_over(7, 5)};
  const auto results = simulate({3}, texture, frames, {1, 0.2, 0.2});
  ASSERT_EQ(results.size(), 2U);
  EXPECT_EQ(results[0].cycles, results[1].cycles) << "a frame starts from an idle unit";
  for (std::size_t n = 0; n < results[1].pixels.size(); ++n) {
    const Fragment& f = frames[1][n];
    const auto trace = evaluate_rgb(reference::kBase, rgb_operands(texture, n, f.lu, f.lv));
    for (std::size_t c = 0; c < 3; ++c) {
      ASSERT_EQ(results[1].pixels[n].out[c], trace.color.out[c]) << "texel " << n;
    }
  }
}

}  // namespace
}  // namespace ptm::pipeline
