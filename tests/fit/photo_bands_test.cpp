// Photographs that cannot be read by rows give the same map as those that can.
#include "golden/fit/photo_bands.h"

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "golden/files/ptm_file.h"
#include "golden/scene/relief.h"
#include "testbench/program/fit_job.h"
#include "tests/fit/interlaced_png.h"
#include "tests/scratch_folder.h"

namespace ptm::testbench {
namespace {

using golden::Image8;
using golden::PictureRows;
using tests::ScratchFolder;

constexpr int kLights = 8, kWidth = 43, kHeight = 37;  // neither is whole blocks of a JPEG
using Save = std::function<void(const std::filesystem::path&, const Image8&)>;

void save_jpeg(const std::filesystem::path& path, const Image8& image, bool progressive) {
  const auto output = OIIO::ImageOutput::create(path.string());
  OIIO::ImageSpec spec(image.width, image.height, 3, OIIO::TypeDesc::UINT8);
  spec["Compression"] = "jpeg:95";
  spec["jpeg:progressive"] = progressive ? 1 : 0;
  ASSERT_TRUE(output->open(path.string(), spec));
  ASSERT_TRUE(output->write_image(OIIO::TypeDesc::UINT8, image.samples.data()));
  ASSERT_TRUE(output->close());
}

/// A folder of photographs of one scene, saved in one way, and their lights.
std::filesystem::path save_capture(const ScratchFolder& folder, const std::string& ending,
                                   const Save& save) {
  std::string text;
  const auto lights = golden::spread_lights(kLights);
  for (std::size_t i = 0; i < lights.size(); ++i) {
    const auto& d = lights[i];
    Image8 image(kWidth, kHeight, 3);
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        for (int c = 0; c < 3; ++c) {
          const double slope = 40 * d[0] * (x % 9 - 4) / 4 + 30 * d[1] * (y % 7 - 3) / 3;
          image.at(x, y, c) = static_cast<std::uint8_t>(120 + slope + 25 * c + y);
        }
      }
    }
    std::string name("p");
    name += std::to_string(i) + ending;
    save(folder / name, image);
    text += name + ' ' + std::to_string(d[0]) + ' ' + std::to_string(d[1]) + ' ' +
            std::to_string(d[2]) + '\n';
  }
  return folder.write("c.lp", text);
}

struct Fitted {
  bool streams = false;
  FitOutcome outcome;
  golden::PtmMap map;
};

Fitted fit(const std::string& ending, std::size_t memory, const Save& save) {
  const ScratchFolder folder;
  FitJob job;
  job.capture.source = save_capture(folder, ending, save);
  job.out = folder / "map.ptm";
  job.config = reference::kBase;
  job.memory = memory;
  Fitted fitted;
  fitted.streams = PictureRows(folder / ("p0" + ending), false).streams();
  fitted.outcome = run_fit(job);
  fitted.map = golden::read_ptm(job.out).map;
  return fitted;
}

bool has_note(const FitOutcome& outcome) {
  return std::any_of(outcome.notes.begin(), outcome.notes.end(), [](const std::string& note) {
    return note.find("cannot be read by rows and are decoded once for each band") !=
           std::string::npos;
  });
}

/// Both ways of saving hold the same samples; the second one cannot be read by rows.
void expect_the_same_fit(const std::string& ending, const Save& by_rows, const Save& whole) {
  constexpr std::size_t kFew = 40000, kPlenty = std::size_t{1} << 28;
  const Fitted wanted = fit(ending, kPlenty, by_rows);
  EXPECT_EQ(wanted.outcome.bands, 1);
  for (const std::size_t memory : {kFew, kPlenty}) {
    const Fitted rows = fit(ending, memory, by_rows), found = fit(ending, memory, whole);
    EXPECT_TRUE(rows.streams);
    EXPECT_FALSE(found.streams);
    EXPECT_EQ(found.outcome.bands > 5, memory == kFew) << found.outcome.bands;
    EXPECT_EQ(found.outcome.bands, rows.outcome.bands);
    EXPECT_FALSE(has_note(rows.outcome));
    EXPECT_EQ(has_note(found.outcome), memory == kFew);
    EXPECT_TRUE(rows.map == wanted.map);
    EXPECT_TRUE(found.map == wanted.map);
    EXPECT_NEAR(found.outcome.training.stored.rmse, wanted.outcome.training.stored.rmse, 1e-9);
    EXPECT_LT(found.outcome.training.stored.rmse, 5);
  }
}

TEST(PhotoBands, OfProgressiveJpegsGiveTheMapOfBaselineOnesAndSayWhatItCosts) {
  expect_the_same_fit(
      ".jpg", [](const auto& path, const Image8& image) { save_jpeg(path, image, false); },
      [](const auto& path, const Image8& image) { save_jpeg(path, image, true); });
}

TEST(PhotoBands, OfInterlacedPngsGiveTheMapOfPlainOnesAndSayWhatItCosts) {
  expect_the_same_fit(
      ".png", [](const auto& path, const Image8& image) { golden::write_picture(path, image); },
      [](const auto& path, const Image8& image) { tests::write_interlaced_png(path, image); });
}

}  // namespace
}  // namespace ptm::testbench
