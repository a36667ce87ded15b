// The fit on real photographs: what the issue asks for, each figure printed.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "golden/files/ptm_file.h"
#include "golden/fit/photo_bands.h"
#include "golden/render/light_map.h"
#include "testbench/program/fit_job.h"
#include "tests/scratch_folder.h"
#include "tests/shared_data.h"

namespace ptm::testbench {
namespace {

using golden::MapKind;
using tests::ScratchFolder;

FitJob job_for(const std::filesystem::path& lp, const ScratchFolder& folder, MapKind kind) {
  FitJob job;
  job.capture.source = lp;
  job.fit.kind = kind;
  job.out = folder / "map.ptm";
  job.config = reference::kBase;
  return job;
}

const char* name_of(MapKind kind) { return kind == MapKind::rgb ? "RGB" : "LRGB"; }

TEST(RealCaptures, LoseLessThanATenthOfADecibelToStorage) {
  const ScratchFolder folder;
  for (const char* name : {"icon/dirs.lp", "dome/Dome/dirs.lp"}) {
    PTM_SHARED_DATA_OR_SKIP(lp, name);
    for (const MapKind kind : {MapKind::lrgb, MapKind::rgb}) {
      const FitOutcome outcome = run_fit(job_for(lp, folder, kind));
      const double real = outcome.training.real.psnr_db, stored = outcome.training.stored.psnr_db;
      std::printf("%s %s: real-valued %.4f dB, stored %.4f dB\n", name, name_of(kind), real,
                  stored);
      EXPECT_NEAR(stored, real, 0.1) << name;
      for (const double scale : outcome.scale)
        EXPECT_EQ(std::exp2(std::round(std::log2(scale))), scale);
    }
  }
}

TEST(RealCaptures, RgbMapsOfTheDomeSeeHeldOutLightsAtNineteenPointEightFiveDecibels) {
  const ScratchFolder folder;
  PTM_SHARED_DATA_OR_SKIP(lp, "dome/Dome/dirs.lp");
  FitJob job = job_for(lp, folder, MapKind::rgb);
  job.test = lp.parent_path().parent_path() / "Test" / "dirs.lp";
  const FitOutcome outcome = run_fit(job);
  ASSERT_TRUE(outcome.held_out);
  EXPECT_EQ(outcome.held_out->names.size(), 20U);
  std::printf("dome, 20 held-out lights, RGB: asked 19.85 dB / ours %.3f dB\n",
              outcome.held_out->stored.psnr_db);
  EXPECT_GE(outcome.held_out->stored.psnr_db, 19.85);
}

TEST(RealCaptures, PrintTheRmseThatThePaperStates) {
  const ScratchFolder folder;
  int measured = 0;
  for (const char* name : {"reference_8x5/reference_8x5.lp", "hostile_lp/item11/dirs.lp",
                           "psbox/Objects", "icon/dirs.lp", "dome/Dome/dirs.lp"}) {
    PTM_SHARED_DATA_OR_SKIP(source, name);
    FitJob job = job_for(source, folder, MapKind::rgb);
    if (std::filesystem::is_directory(source)) {
      job.capture.lights = source.parent_path() / "light_directions.txt";
    }
    const FitOutcome outcome = run_fit(job);
    const auto& rmse = outcome.training.stored.channel_rmse;
    std::printf("RMSE a channel, RGB: paper roughly 10 at most / ours %.2f %.2f %.2f (%s)\n",
                rmse[0], rmse[1], rmse[2], name);
    measured += rmse[0] < 11 && rmse[1] < 11 && rmse[2] < 11 ? 1 : 0;
  }
  EXPECT_GE(measured, 3);  // icon is gilded and dome glossy with cast shadows: not diffuse
}

/// A map's bytes as real coefficients, judged by the photographs as run_fit() judges.
double psnr_of(const golden::PtmMap& map, const std::filesystem::path& lp) {
  golden::CaptureRequest request;
  request.source = lp;
  golden::Capture capture = golden::open_capture(request);
  golden::Capture* const one[] = {&capture};
  golden::PhotoBands bands(one, std::size_t{1} << 30);
  golden::Band band;
  bands.read(0, band);
  std::vector<double> coef;
  for (std::size_t t = 0; t < map.texels(); ++t) {
    const auto a = golden::real_coefficients(map, t);
    coef.insert(coef.end(), a.begin(), a.end());
  }
  std::vector<golden::Squares> squares(capture.names.size());
  golden::add_squares(band.tile(0, band.texels, 0), capture.directions, map.kind, coef, map.color,
                      squares);
  golden::Squares sum{};
  for (const auto& s : squares) {
    for (std::size_t c = 0; c < 3; ++c) sum[c] += s[c];
  }
  return golden::to_residual(sum, double(map.texels()) * double(squares.size())).psnr_db;
}

TEST(RealCaptures, TheDefaultMapBeatsTheOneThatHpsFitterMade) {
  const ScratchFolder folder;
  PTM_SHARED_DATA_OR_SKIP(lp, "reference_8x5/reference_8x5.lp");
  const auto theirs = golden::read_ptm(lp.parent_path() / "reference_8x5.ptm").map;
  const FitJob job = job_for(lp, folder, MapKind::lrgb);
  const FitOutcome outcome = run_fit(job);
  const double hp = psnr_of(theirs, lp), ours = psnr_of(golden::read_ptm(job.out).map, lp);
  std::printf("reference_8x5, LRGB: HP's file %.3f dB / ours %.3f dB\n", hp, ours);
  EXPECT_NEAR(outcome.training.stored.psnr_db, ours, 1e-9);
  EXPECT_GT(ours, hp);
  EXPECT_GT(ours, 49.1);
}

TEST(RealCaptures, AreNearerWhereColourFillsItsRangeThanWhereLuminanceDoes) {
  const ScratchFolder folder;
  const std::pair<const char*, double> cases[] = {
      {"icon/dirs.lp", 0.25}, {"dome/Dome/dirs.lp", 0.9}, {"reference_8x5/reference_8x5.lp", 0.05}};
  for (const auto& [name, gain] : cases) {
    PTM_SHARED_DATA_OR_SKIP(lp, name);
    FitJob job = job_for(lp, folder, MapKind::lrgb);
    const double color = run_fit(job).training.stored.psnr_db;
    job.fit.full_range = golden::FullRange::luminance;
    const double luminance = run_fit(job).training.stored.psnr_db;
    std::printf("%s, LRGB: full range of luminance %.3f dB / of colour %.3f dB\n", name, luminance,
                color);
    EXPECT_GT(color, luminance + gain) << name;
  }
}

TEST(RealCaptures, HpsRecipeMakesHpsFile) {
  const ScratchFolder folder;
  PTM_SHARED_DATA_OR_SKIP(lp, "reference_8x5/reference_8x5.lp");
  const auto theirs = golden::read_ptm(lp.parent_path() / "reference_8x5.ptm").map;
  FitJob job = job_for(lp, folder, MapKind::lrgb);
  job.quantizer = "hp";
  job.fit.truncate_color = true;
  job.fit.full_range = golden::FullRange::luminance;
  (void)run_fit(job);
  const auto ours = golden::read_ptm(job.out).map;
  EXPECT_EQ(ours.scale, theirs.scale);
  EXPECT_EQ(ours.bias, theirs.bias);
  EXPECT_EQ(ours.coef, theirs.coef);
  EXPECT_EQ(ours.color, theirs.color);
  std::printf("HP's recipe: %zu coefficient bytes and %zu colour bytes, all as in HP's file\n",
              ours.coef.size(), ours.color.size());
}

}  // namespace
}  // namespace ptm::testbench
