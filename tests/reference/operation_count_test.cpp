// The paper's eleven multiplies and five adds, counted in the code that is the reference.
#include <gtest/gtest.h>

#include <iostream>

#include "tests/reference/counting_integer.h"
// The counting type must be complete before the datapath's templates look its functions up.
#include "model/reference/evaluate.h"
#include "model/reference/lerp.h"

namespace ptm {
namespace {

using reference::Step;
using tests::Counting;
using tests::OperationLog;

constexpr std::array<std::pair<Step, const char*>, 10> kSteps{
    {{Step::unpack, "D1 unpack"},
     {Step::basis, "D2 basis"},
     {Step::products, "D3 products"},
     {Step::align, "D4 align"},
     {Step::sum, "D5 sum"},
     {Step::luminance, "D6 luminance"},
     {Step::color_products, "D7 colour products"},
     {Step::color_scale, "D7 division by 255"},
     {Step::narrow, "narrow"},
     {Step::lerp, "lerp"}}};

void print_counts(const char* what, const char* preset) {
  std::cout << what << ", " << preset << ":\n";
  for (const auto& [step, name] : kSteps) {
    const auto n = OperationLog::instance().of(step);
    std::cout << "  " << name << ": " << n.multiplies << " multiplies, " << n.adds << " adds, "
              << n.subtracts << " subtracts, " << n.shifts << " variable shifts, " << n.comparisons
              << " comparisons\n";
  }
}

int multiplies_outside_counted_steps() {
  int total = 0;
  for (const Step step :
       {Step::unpack, Step::align, Step::luminance, Step::color_scale, Step::narrow}) {
    total += OperationLog::instance().of(step).multiplies;
  }
  return total;
}

class OperationCount : public testing::TestWithParam<reference::Preset> {};

TEST_P(OperationCount, OfAnLrgbPixelIsElevenMultipliesAndFiveAdds) {
  OperationLog& log = OperationLog::instance();
  log.clear();
  (void)reference::evaluate_lrgb(GetParam().config, reference::LrgbOperands<Counting>{});
  print_counts("LRGB pixel", GetParam().name.data());
  EXPECT_EQ(log.of(Step::basis).multiplies, 3);
  EXPECT_EQ(log.of(Step::products).multiplies, 5);
  EXPECT_EQ(log.of(Step::color_products).multiplies, 3);
  EXPECT_EQ(log.of(Step::sum).adds, 5);
  EXPECT_EQ(log.of(Step::sum).multiplies, 0);
  for (const Step step : {Step::basis, Step::products, Step::color_products}) {
    EXPECT_EQ(log.of(step).adds + log.of(step).subtracts, 0);
  }
  EXPECT_EQ(multiplies_outside_counted_steps(), 0);
}

TEST_P(OperationCount, OfAnRgbPixelIsTwentyFourMultipliesAndFifteenAdds) {
  OperationLog& log = OperationLog::instance();
  log.clear();
  (void)reference::evaluate_rgb(GetParam().config, reference::RgbOperands<Counting>{});
  print_counts("RGB pixel", GetParam().name.data());
  EXPECT_EQ(log.of(Step::basis).multiplies + log.of(Step::products).multiplies, 24);
  EXPECT_EQ(log.of(Step::color_products).multiplies, 0);
  EXPECT_EQ(log.of(Step::sum).adds, 15);
  EXPECT_EQ(multiplies_outside_counted_steps(), 0);
}

INSTANTIATE_TEST_SUITE_P(Presets, OperationCount, testing::ValuesIn(reference::kPresets),
                         [](const auto& preset) { return std::string(preset.param.name); });

TEST(OperationCount, OfALerpIsOneMultiply) {
  OperationLog& log = OperationLog::instance();
  log.clear();
  (void)reference::lerp(reference::Rounding::nearest, Counting{3}, Counting{9}, Counting{128});
  EXPECT_EQ(log.of(Step::lerp).multiplies, 1);
  EXPECT_EQ(log.of(Step::lerp).adds, 1);
  EXPECT_EQ(log.of(Step::lerp).subtracts, 1);
}

}  // namespace
}  // namespace ptm
