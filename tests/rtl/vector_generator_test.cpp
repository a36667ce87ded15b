#include "testbench/vectors/vector_generator.h"

#include <gtest/gtest.h>

#include <set>

#include "testbench/rtl/rtl_variants.h"

namespace ptm::testbench {
namespace {

using reference::Value;

constexpr std::uint64_t kCount = 20'000;

/// Lowest and highest value seen.
struct Range {
  Value low = INT64_MAX, high = INT64_MIN;
  void add(Value value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  bool operator==(const Range&) const = default;
};

TEST(VectorGenerator, ReachesBothEndsOfEveryLegalRangeAndLeavesNone) {
  for (const RtlVariant& variant : rtl_variants()) {
    const reference::EvalConfig& c = variant.config;
    Range coef, bias, shift, rgb, light;
    for (std::uint64_t n = 0; n < kCount; ++n) {
      const auto in = lrgb_vector(c, 1, n);
      for (Value value : in.coef) coef.add(value);
      for (Value value : in.bias) bias.add(value);
      for (Value value : in.shift) shift.add(value);
      for (Value value : in.rgb) rgb.add(value);
      light.add(in.lu);
      light.add(in.lv);
    }
    const Value light_top = Value{1} << (c.light_int + c.light_frac - 1);
    EXPECT_EQ(coef, (Range{0, (Value{1} << (c.coef_bits + c.filter_frac)) - 1})) << variant.name;
    EXPECT_EQ(bias, (Range{0, (Value{1} << c.coef_bits) - 1})) << variant.name;
    EXPECT_EQ(shift, (Range{c.shift_min, reference::kShiftMax})) << variant.name;
    EXPECT_EQ(rgb, (Range{0, Value{255} << c.filter_frac})) << variant.name;
    EXPECT_EQ(light, (Range{-light_top, light_top - 1})) << variant.name;
  }
}

TEST(VectorGenerator, IsAPureFunctionOfSeedIndexAndConfiguration) {
  const auto a = lrgb_vector(reference::kBase, 1, 5);
  static_cast<void>(lrgb_vector(reference::kBase, 1, 6));
  const auto b = lrgb_vector(reference::kBase, 1, 5);
  EXPECT_EQ(a.coef, b.coef);
  EXPECT_EQ(a.rgb, b.rgb);
  std::set<std::array<Value, 6>> different;
  for (std::uint64_t n = 0; n < 100; ++n) {
    different.insert(lrgb_vector(reference::kBase, 1, n).coef);
    different.insert(lrgb_vector(reference::kBase, 2, n).coef);
  }
  EXPECT_GT(different.size(), 190U);
}

TEST(VectorGenerator, KeepsTheShiftsOfAGroupEqualWhenThereAreThree) {
  for (std::uint64_t n = 0; n < 1000; ++n) {
    const auto lrgb = lrgb_vector(kSmall, 1, n);
    const auto rgb = rgb_vector(kSmall, 1, n);
    for (const auto& shift : {lrgb.shift, rgb.shift}) {
      EXPECT_EQ(shift[1], shift[0]);
      EXPECT_EQ(shift[2], shift[0]);
      EXPECT_EQ(shift[4], shift[3]);
    }
  }
}

TEST(VectorGenerator, GivesLerpsTheWholeStoredRange) {
  Range stored, weight;
  for (std::uint64_t n = 0; n < kCount; ++n) {
    const LerpOperands in = lerp_vector(kLarge, 1, n);
    stored.add(in.a);
    stored.add(in.b);
    weight.add(in.f);
  }
  EXPECT_EQ(stored, (Range{0, 65535}));
  EXPECT_EQ(weight, (Range{0, 255}));
}

}  // namespace
}  // namespace ptm::testbench
