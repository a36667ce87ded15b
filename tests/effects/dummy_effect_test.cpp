// An effect of a row and a file a model, tests/effects/dummy, that no other file knows of.
#include "testbench/plan/effect_rows.h"
#include "testbench/run/unit_job.h"
#include "tests/run_program.h"
#include "tests/unit/unit_agreement.h"

namespace ptm::testbench {
namespace {

class DummyEffect : public tests::Program {
 protected:
  UnitJob job(const std::string& effects) const {
    return make_unit_job(golden::read_unit_scene(write(
        "scene.toml",
        "[image]\nsize = [40, 30]\n"
        "[[texture]]\nname = \"m\"\ngenerate = \"relief\"\nsize = [32, 32]\nfilter = \"point\"\n"
        "[[object]]\nkind = \"sphere\"\ntexture = \"m\"\n" +
            effects + "[[light]]\ndirection = [-1, -2, 1]\n")));
  }
};

const std::string kNegative = "[[object.effect]]\nkind = \"negative\"\n";

TEST_F(DummyEffect, IsARowAmongTheOthers) {
  EXPECT_EQ(effect_row("negative").stages, 8U);
  EXPECT_STREQ(effect_rows().back().id, "negative");
  EXPECT_STREQ(stage_rows().back().id, "negative");
}

TEST_F(DummyEffect, IsPlannedAndBuiltInForSceneThatNamesItOnly) {
  const UnitJob with = job(kNegative), without = job("");
  ASSERT_EQ(with.plan.blocks.size(), 1U);
  EXPECT_EQ(with.plan.blocks[0].name, "negative");
  EXPECT_EQ(with.unit.stages, 8U);
  EXPECT_EQ(without.unit, reference::UnitConfig{});
}

TEST_F(DummyEffect, IsShadedByGoldenAndByTheReferenceAlike) {
  const UnitJob with = job(kNegative), without = job("");
  const auto negative = unit_pixels(with), plain = unit_pixels(without);
  ASSERT_EQ(negative[0].size(), plain[0].size());
  for (std::size_t i = 0; i < plain[0].size(); ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_EQ(negative[0][i].rgb[c], 255 - plain[0][i].rgb[c]) << "pixel " << i;
    }
  }
  const golden::ImageReal right = render_unit_golden(with).frames[0],
                          usual = render_unit_golden(without).frames[0];
  for (const reference::UnitPixel& pixel : plain[0]) {
    for (int c = 0; c < 3; ++c) {
      EXPECT_DOUBLE_EQ((&right.at(pixel.x, pixel.y))[c], 255 - (&usual.at(pixel.x, pixel.y))[c]);
    }
  }
}

TEST_F(DummyEffect, AgreesInEveryPixelCycleAndCounterAndCostsARegister) {
  const UnitJob with = job(kNegative), without = job("");
  const TimedPair pair = run_pair(with);
  expect_agreement(with, pair);
  const TimedPair usual = run_pair(without);
  EXPECT_EQ(pair.exact.frames[0].taken.front(), usual.exact.frames[0].taken.front() + 1);
}

}  // namespace
}  // namespace ptm::testbench
