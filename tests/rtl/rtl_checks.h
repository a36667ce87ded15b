#pragma once
#include <gtest/gtest.h>

#include <sstream>
#include <string>

#include "model/reference/constant_config.h"
#include "testbench/rtl/rtl_variants.h"
#include "testbench/vectors/vector_generator.h"

/// Streams compared pixel by pixel against the reference.
namespace ptm::testbench {

inline void PrintTo(const RtlPixel& pixel, std::ostream* out) {
  *out << "lum " << pixel.lum[0] << ' ' << pixel.lum[1] << ' ' << pixel.lum[2] << " ("
       << pixel.lum_saturated << "), out " << int{pixel.out[0]} << ' ' << int{pixel.out[1]} << ' '
       << int{pixel.out[2]} << " (" << pixel.color_saturated << ')';
}
inline void PrintTo(const RtlVariant& variant, std::ostream* out) { *out << variant.name; }

inline std::string describe(const reference::LrgbOperands<>& in) {
  std::ostringstream text;
  for (unsigned i = 0; i < 6; ++i) {
    text << "a" << i << ' ' << in.coef[i] << " - " << in.bias[i] << " >> " << in.shift[i] << ", ";
  }
  text << "rgb " << in.rgb[0] << ' ' << in.rgb[1] << ' ' << in.rgb[2] << ", light code " << in.lu
       << ' ' << in.lv;
  return text.str();
}

/// Counts differences and tells the first of them in full.
class Differences {
 public:
  explicit Differences(std::string what) : what_(std::move(what)) {}
  ~Differences() { EXPECT_EQ(count_, 0U) << what_ << ", first: " << first_; }
  Differences(const Differences&) = delete;
  Differences& operator=(const Differences&) = delete;

  template <class Describe>
  void expect_equal(const RtlPixel& rtl, const RtlPixel& expected, std::uint64_t index,
                    const Describe& operands) {
    if (rtl == expected) return;
    if (count_++ != 0) return;
    std::ostringstream text;
    text << "vector " << index << ": " << operands() << "\n  rtl       ";
    PrintTo(rtl, &text);
    text << "\n  reference ";
    PrintTo(expected, &text);
    first_ = text.str();
  }

 private:
  std::string what_, first_;
  std::uint64_t count_ = 0;
};

/// Vectors 0..count-1 of that seed through the RTL and the reference. Returns how many luminances
/// did not saturate, so that a test can say that its vectors are worth something.
inline std::uint64_t check_lrgb(const RtlVariant& variant, RtlEvaluator& rtl, std::uint64_t seed,
                                std::uint64_t count, const pipeline::StreamTiming& timing) {
  Differences differences(std::string(variant.name) + " LRGB, seed " + std::to_string(seed));
  std::uint64_t within = 0;
  reference::LrgbOperands<> operands;
  reference::with_constant_config(variant.config, [&](const auto& config) {
    rtl.stream_lrgb(
        count, timing,
        [&](std::uint64_t n) -> const auto& {
          operands = lrgb_vector(variant.config, seed, n);
          return operands;
        },
        [&](std::uint64_t n, const RtlPixel& pixel, std::uint64_t) {
          const auto in = lrgb_vector(variant.config, seed, n);
          const RtlPixel expected = to_pixel(reference::evaluate_lrgb(config, in));
          differences.expect_equal(pixel, expected, n, [&] { return describe(in); });
          within += !expected.lum_saturated;
        });
  });
  return within;
}

inline void check_rgb(const RtlVariant& variant, RtlEvaluator& rtl, std::uint64_t seed,
                      std::uint64_t count, const pipeline::StreamTiming& timing) {
  Differences differences(std::string(variant.name) + " RGB, seed " + std::to_string(seed));
  reference::RgbOperands<> operands;
  rtl.stream_rgb(
      count, timing,
      [&](std::uint64_t n) -> const auto& {
        operands = rgb_vector(variant.config, seed, n);
        return operands;
      },
      [&](std::uint64_t n, const RtlPixel& pixel, std::uint64_t) {
        const auto in = rgb_vector(variant.config, seed, n);
        const RtlPixel expected = to_pixel(reference::evaluate_rgb(variant.config, in));
        differences.expect_equal(pixel, expected, n, [&] {
          return describe({in.coef[0], in.bias, in.shift, {}, in.lu, in.lv}) + " (red's)";
        });
      });
}

}  // namespace ptm::testbench
