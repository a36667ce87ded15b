#include "testbench/report/run_comparison.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/report/made_run.h"

namespace ptm::testbench {
namespace {

using tests::made_faulty_run;
using tests::made_run;

TEST(RunComparison, ComparesEveryPairOnceInTheOrderOfTheModels) {
  const RunComparison comparison = compare_run(made_run(12, 9, 2));
  const char* expected[6][2] = {{"golden", "reference"}, {"golden", "pipeline"},
                                {"golden", "rtl"},       {"reference", "pipeline"},
                                {"reference", "rtl"},    {"pipeline", "rtl"}};
  ASSERT_EQ(comparison.pairs.size(), 6U);
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(comparison.pairs[i].a, expected[i][0]);
    EXPECT_EQ(comparison.pairs[i].b, expected[i][1]);
    EXPECT_EQ(comparison.pairs[i].must_agree, i >= 3);
    EXPECT_EQ(comparison.pairs[i].difference.samples, 12U * 9 * 3 * 2);
  }
  EXPECT_TRUE(comparison.models_agree());
}

/// Equal pictures are compared once and the result reused: it must be the one that comparing gives.
TEST(RunComparison, GivesEveryPairItsOwnDifferenceThoughEqualPicturesAreComparedOnce) {
  const RunResult run = made_faulty_run(12, 9, 2);
  for (const PairDifference& pair : compare_run(run).pairs) {
    const ModelResult *a = nullptr, *b = nullptr;
    for (const ModelResult& model : run.models) {
      if (model.model == pair.a) a = &model;
      if (model.model == pair.b) b = &model;
    }
    const PictureDifference d = compare_frames(a->frames, b->frames);
    EXPECT_EQ(pair.difference.differing, d.differing) << pair.a << ' ' << pair.b;
    EXPECT_EQ(pair.difference.rmse, d.rmse) << pair.a << ' ' << pair.b;
    EXPECT_EQ(pair.difference.worst, d.worst) << pair.a << ' ' << pair.b;
  }
}

TEST(RunComparison, PutsPixelsInWhichHardwareDisagreesBeforeLargerErrorsAgainstGolden) {
  RunResult run = made_run(16, 16, 1);
  run.models[0].frames[0].at(2, 3, 0) = run.models[1].frames[0].at(2, 3, 0) > 128 ? 0 : 255;
  double& sample = run.models[3].frames[0].at(9, 5, 1);
  sample += sample > 128 ? -1 : 1;
  const RunComparison comparison = compare_run(run);
  EXPECT_FALSE(comparison.models_agree());
  ASSERT_EQ(comparison.worst.size(), 10U);
  EXPECT_EQ(comparison.worst[0].a, "reference");
  EXPECT_EQ(comparison.worst[0].b, "rtl");
  EXPECT_EQ(comparison.worst[0].where, (WorstPixel{0, 9, 5, 1}));
  EXPECT_EQ(comparison.worst[1].a, "golden");
  EXPECT_EQ(comparison.worst[1].where.x, 2);
  EXPECT_EQ(comparison.worst[1].where.y, 3);
  EXPECT_GT(comparison.worst[1].where.error, 100);
}

TEST(RunComparison, ListsNoPixelTwice) {
  const RunComparison comparison = compare_run(made_faulty_run(20, 20, 2));
  for (std::size_t i = 0; i < comparison.worst.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const WorstPixel &p = comparison.worst[i].where, &q = comparison.worst[j].where;
      EXPECT_FALSE(p.frame == q.frame && p.x == q.x && p.y == q.y) << i << ' ' << j;
    }
  }
}

TEST(RunComparison, AsksEveryModelForItsValuesAtAWorstPixel) {
  RunResult run = made_run(8, 8, 2);
  run.probe = [](const std::string& model, int frame, int x, int y) {
    return std::vector<NamedValue>{{"where", model + std::to_string(frame) + "," +
                                                 std::to_string(x) + "," + std::to_string(y)}};
  };
  const ProbedPixel pixel = compare_run(run).worst.at(0);
  ASSERT_EQ(pixel.models.size(), 4U);
  for (std::size_t m = 0; m < 4; ++m) {
    const WorstPixel& at = pixel.where;
    EXPECT_EQ(pixel.models[m].values.at(0).value, run.models[m].model + std::to_string(at.frame) +
                                                      "," + std::to_string(at.x) + "," +
                                                      std::to_string(at.y));
    const auto& frame = run.models[m].frames[static_cast<std::size_t>(at.frame)];
    EXPECT_EQ(pixel.models[m].rgb[2], frame.at(at.x, at.y, 2));
  }
}

TEST(RunComparison, ComparesPresetsWithGoldenAndWithoutGoldenHasNone) {
  RunResult run = made_run(10, 10, 2);
  const RunComparison comparison = compare_run(run);
  ASSERT_EQ(comparison.presets.size(), 3U);
  EXPECT_EQ(comparison.presets[0].preset, "paper8");
  EXPECT_EQ(comparison.presets[1].difference.rmse, comparison.pairs[0].difference.rmse);
  EXPECT_GT(comparison.presets[0].difference.rmse, comparison.presets[2].difference.rmse);
  run.models.erase(run.models.begin());
  EXPECT_TRUE(compare_run(run).presets.empty());
}

void expect_refused(const RunResult& run, const std::string& naming) {
  try {
    (void)compare_run(run);
    ADD_FAILURE() << "accepted, expected to refuse with: " << naming;
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find(naming), std::string::npos) << error.what();
  }
}

TEST(RunComparison, RefusesARunThatDoesNotHoldTogether) {
  RunResult run = made_run(4, 4, 2);
  run.models[2].frames.pop_back();
  expect_refused(run, "pipeline has 1 frame, expected one for each of 2 lights");
  run = made_run(4, 4, 2);
  run.models[1].frames[1] = golden::ImageReal(4, 5, 3);
  expect_refused(run, "reference, frame 1: found 4 x 5 x 3 samples, expected 4 x 4 x 3");
  run = made_run(4, 4, 1);
  run.presets[2].frames.clear();
  expect_refused(run, "preset wide has 0 frames");
  run = made_run(4, 4, 1);
  run.models[1].model = "../up";
  expect_refused(run, "'../up'");
  run.models[1].model = "rtl";
  expect_refused(run, "'rtl'");
  run.models.clear();
  expect_refused(run, "no model");
}

}  // namespace
}  // namespace ptm::testbench
