// Room for luminance in a fitted map: what the hardware's D6 would clamp moves into the colour.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "golden/files/ptm_file.h"
#include "golden/render/light_map.h"
#include "testbench/program/fit_job.h"
#include "testbench/run/hardware_map.h"
#include "tests/scratch_folder.h"

namespace ptm::testbench {
namespace {

using tests::ScratchFolder;

constexpr int kWidth = 5, kHeight = 4, kTexels = kWidth * kHeight;

/// Photographs under nine lights near the zenith of a surface that goes on brightening to the
/// horizon: with full range of luminance 255 is the brightest photograph, so lights beyond exceed
/// it.
std::filesystem::path slanted_capture(const ScratchFolder& folder) {
  std::string text;
  for (const double u : {-0.4, 0.0, 0.4}) {
    for (const double v : {-0.4, 0.0, 0.4}) {
      golden::Image8 image(kWidth, kHeight, 3);
      for (std::size_t n = 0; n < image.samples.size(); ++n) {
        const double level = 60 + 45 * u - 20 * v + static_cast<double>(n / 3);
        image.samples[n] = static_cast<std::uint8_t>(level * (n % 3 == 0 ? 1.0 : 0.8) + 0.5);
      }
      const std::string name = std::to_string(10 * u + v) + ".png";
      golden::write_picture(folder / name, image);
      text += name + ' ' + std::to_string(u) + ' ' + std::to_string(v) + ' ' +
              std::to_string(std::sqrt(1 - u * u - v * v)) + '\n';
    }
  }
  return folder.write("c.lp", text);
}

FitOutcome fit(const ScratchFolder& folder, const reference::EvalConfig& config,
               golden::MapKind kind = golden::MapKind::lrgb, const std::string& quantizer = "plain",
               std::size_t memory = std::size_t{1} << 28,
               golden::FullRange full_range = golden::FullRange::luminance) {
  FitJob job;
  job.capture.source = slanted_capture(folder);
  job.fit.kind = kind;
  job.fit.full_range = full_range;
  job.out = folder / "map.ptm";
  job.config = config;
  job.quantizer = quantizer;
  job.memory = memory;
  return run_fit(job);
}

/// The most luminance that any texel of a map reaches under lights all round.
double highest(const golden::PtmMap& map) {
  double most = 0;
  for (std::size_t t = 0; t < map.texels(); ++t) {
    const golden::Coefficients a = golden::real_coefficients(map, t);
    for (const auto& [u, v] : hemisphere_lights()) {
      most =
          std::max(most, a[0] * u * u + a[1] * v * v + a[2] * u * v + a[3] * u + a[4] * v + a[5]);
    }
  }
  return most;
}

TEST(FitBalance, KeepsLuminanceWithinTheHardwaresWithoutChangingThePicture) {
  const ScratchFolder folder;
  const FitOutcome outcome = fit(folder, reference::kPaper8);
  EXPECT_EQ(outcome.balance.exceeding, kTexels);
  EXPECT_EQ(outcome.balance.scaled, kTexels);
  EXPECT_EQ(outcome.balance.remaining, 0U);
  EXPECT_TRUE(std::any_of(outcome.notes.begin(), outcome.notes.end(), [](const std::string& n) {
    return n.find("20 texels exceeded") != std::string::npos;
  }));
  // 255, and what rounding the coefficients may add.
  EXPECT_LT(highest(golden::read_ptm(folder / "map.ptm").map), 255 + 3 * outcome.loss.worst);
  EXPECT_LT(outcome.training.real.rmse, 0.6);  // pictures and colours are rounded to whole levels
  EXPECT_LT(outcome.training.stored.rmse, 1.0);
}

TEST(FitBalance, RecordsWhatStoringLostAgainstTheBalancedLuminance) {
  const ScratchFolder folder;
  const FitOutcome outcome = fit(folder, reference::kPaper8);
  EXPECT_GT(outcome.loss.rms(), 0);
  EXPECT_GE(outcome.loss.worst, outcome.loss.rms());
  double bound = 0;  // of plain rounding: half a step times the basis' root mean square
  for (std::size_t k = 0; k < 6; ++k) bound += outcome.scale[k] / 2;
  EXPECT_LE(outcome.loss.worst, bound);
  EXPECT_EQ(outcome.loss.saturated, (std::array<std::uint64_t, 6>{}));
}

TEST(FitBalance, CountsEachTexelOnceHoweverManyBandsThereAre) {
  const ScratchFolder folder;
  const FitOutcome whole = fit(folder, reference::kPaper8);
  const golden::PtmMap map = golden::read_ptm(folder / "map.ptm").map;
  const FitOutcome bands =
      fit(folder, reference::kPaper8, golden::MapKind::lrgb, "plain", std::size_t{1});
  EXPECT_EQ(bands.bands, kHeight);
  EXPECT_EQ(whole.balance.scaled, kTexels);
  EXPECT_EQ(bands.balance.scaled, kTexels);
  EXPECT_TRUE(golden::read_ptm(folder / "map.ptm").map == map);
}

TEST(FitBalance, LeavesMapsAloneThatHaveRoomOrNoColourToMoveInto) {
  const ScratchFolder folder;
  EXPECT_EQ(fit(folder, reference::kBase).balance.exceeding, 0U);
  EXPECT_EQ(fit(folder, reference::kPaper8, golden::MapKind::rgb).balance.exceeding, 0U);
  const FitOutcome hp = fit(folder, reference::kPaper8, golden::MapKind::lrgb, "hp");
  EXPECT_EQ(hp.balance.exceeding, 0U);
  EXPECT_GT(highest(golden::read_ptm(folder / "map.ptm").map), 290);  // so the others had to move
}

TEST(FitBalance, HasNothingToDoWhereAFullColourLeavesLuminanceLow) {
  const ScratchFolder folder;
  const FitOutcome outcome = fit(folder, reference::kPaper8, golden::MapKind::lrgb, "plain",
                                 std::size_t{1} << 28, golden::FullRange::color);
  EXPECT_EQ(outcome.balance.exceeding, 0U);
  // The last texel's red: 79 + 45 u - 20 v, whose slope is 49.2.
  EXPECT_NEAR(highest(golden::read_ptm(folder / "map.ptm").map), 79 + 49.2, 2);
}

}  // namespace
}  // namespace ptm::testbench
