// What each preset's bits cost on a real map, against golden, over lights on the hemisphere.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <numbers>

#include "golden/render/light_map.h"
#include "testbench/run/hardware_map.h"
#include "testbench/run/map_bound.h"
#include "testbench/run/picture_models.h"
#include "tests/shared_data.h"

namespace ptm::testbench {
namespace {

struct Accuracy {
  double psnr_db = 0, largest = 0;
};

/// Forty lights spread on the hemisphere: equal steps of height, the golden angle around.
std::vector<golden::Light> forty_lights() {
  std::vector<golden::Light> lights;
  const double golden_angle = std::numbers::pi * (3 - std::sqrt(5.0));
  for (int i = 0; i < 40; ++i) {
    const double z = (i + 0.5) / 40;
    const double r = std::sqrt(1 - z * z);
    lights.push_back({r * std::cos(i * golden_angle), r * std::sin(i * golden_angle), "a light"});
  }
  return lights;
}

FlatJob tablet_job(const std::string& preset) {
  FlatJob job;
  job.map = golden::read_ptm(tests::shared_data() / "tablet2" / "tablet2_LRGB.ptm").map;
  job.width = job.map.width;
  job.height = job.map.height;
  job.lights = forty_lights();
  choose_config(job, reference::find_preset(preset).config);
  return job;
}

/// Error of the hardware's integers against golden's unrounded levels.
Accuracy measure(const std::string& preset) {
  const FlatJob job = tablet_job(preset);
  Accuracy accuracy;
  double squares = 0;
  std::size_t samples = 0;
  const ModelResult hardware = render_reference(job);
  for (std::size_t frame = 0; frame < job.lights.size(); ++frame) {
    const auto truth = golden::light_map(job.map, job.lights[frame].u, job.lights[frame].v);
    for (std::size_t i = 0; i < truth.samples.size(); ++i) {
      const double error = std::abs(hardware.frames[frame].samples[i] - truth.samples[i]);
      accuracy.largest = std::max(accuracy.largest, error);
      squares += error * error;
    }
    samples += truth.samples.size();
  }
  accuracy.psnr_db = 10 * std::log10(255.0 * 255.0 * static_cast<double>(samples) / squares);
  std::cout << preset << ": " << accuracy.psnr_db << " dB, largest error " << accuracy.largest
            << " levels, over 40 lights\n";
  return accuracy;
}

TEST(PresetAccuracy, OfBaseOnATabletIsAbove56_5DbWithNoErrorOfTwoLevels) {
  PTM_SHARED_DATA_OR_SKIP(map, "tablet2/tablet2_LRGB.ptm");
  const Accuracy accuracy = measure("base");
  EXPECT_GE(accuracy.psnr_db, 56.5);
  EXPECT_LT(accuracy.largest, 2);
}

TEST(PresetAccuracy, OfWideOnATabletIsAbove58_5DbWithNoErrorAbove0_6) {
  PTM_SHARED_DATA_OR_SKIP(map, "tablet2/tablet2_LRGB.ptm");
  const Accuracy accuracy = measure("wide");
  EXPECT_GE(accuracy.psnr_db, 58.5);
  EXPECT_LE(accuracy.largest, 0.6);
}

/// The largest error of a sample as a share of what is proved of its texel.
double largest_share(const std::string& preset) {
  const FlatJob job = tablet_job(preset);
  const auto stored = import_map(job.map, reference::find_preset(preset).config);
  const std::vector<double> bounds =
      texel_error_bounds(job.map, stored.map.value(), reference::find_preset(preset).config);
  const ModelResult hardware = render_reference(job);
  double share = 0;
  for (std::size_t frame = 0; frame < job.lights.size(); ++frame) {
    const auto truth = golden::light_map(job.map, job.lights[frame].u, job.lights[frame].v);
    for (std::size_t i = 0; i < truth.samples.size(); ++i) {
      const double error = std::abs(hardware.frames[frame].samples[i] - truth.samples[i]);
      share = std::max(share, error / bounds[i / 3]);
    }
  }
  std::cout << preset << ": a sample comes to " << share
            << " of its texel's bound; the largest bound is "
            << *std::max_element(bounds.begin(), bounds.end()) << " levels\n";
  return share;
}

TEST(PresetAccuracy, IsWithinWhatIsProvedOfEachTexel) {
  PTM_SHARED_DATA_OR_SKIP(map, "tablet2/tablet2_LRGB.ptm");
  for (const char* preset : {"base", "wide"}) {
    const double share = largest_share(preset);
    EXPECT_LE(share, 1) << preset;
    EXPECT_GT(share, 0.5) << preset;
  }
}

TEST(PresetAccuracy, GrowsWithTheBitsThatAreSpent) {
  PTM_SHARED_DATA_OR_SKIP(map, "tablet2/tablet2_LRGB.ptm");
  const Accuracy paper8 = measure("paper8"), base = measure("base"), wide = measure("wide");
  EXPECT_LT(paper8.psnr_db, base.psnr_db);
  EXPECT_LT(base.psnr_db, wide.psnr_db);
  EXPECT_GT(paper8.largest, base.largest);
  EXPECT_GT(base.largest, wide.largest);
}

}  // namespace
}  // namespace ptm::testbench
