// Every effect's scene, texels sampled alone: the reference's pixels lie within the bound that is
// derived from the bits around golden's.
#include <iostream>

#include "tests/effects/derived_bound.h"
#include "tests/unit/unit_agreement.h"

namespace ptm::testbench {
namespace {

std::vector<std::string> effect_scene_names() {
  std::vector<std::string> names = unit_scene_names();
  std::erase_if(names, [](const std::string& name) { return !name.starts_with("effect_"); });
  return names;
}

struct Case {
  std::string scene, preset;
};
void PrintTo(const Case& which, std::ostream* out) { *out << which.scene << ", " << which.preset; }

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const std::string& scene : effect_scene_names()) {
    for (const char* preset : {"base", "wide"}) all.push_back({scene, preset});
    // paper8 has no code for these scenes' lights, and moves luminance into colour elsewhere.
    if (scene == "effect_half_vector") all.push_back({scene, "paper8"});
  }
  return all;
}

UnitJob point_sampled(const Case& which) {
  golden::UnitScene scene = golden::read_unit_scene(std::filesystem::path(PTM_SOURCE_DIR) /
                                                    "scenes" / (which.scene + ".toml"));
  scene.hardware.list.push_back({.name = "preset", .text = which.preset});
  for (golden::DrawSpec& draw : scene.draws) {
    draw.filter = {.bilinear = false, .mip = golden::MipMode::none};
    draw.probes = 1;
  }
  return make_unit_job(scene);
}

/// The sample at the coordinates that the fragment holds, within 2^-21 of its own: so that both
/// take the same texel where a pixel's centre lies on the edge of two.
golden::SurfaceSample at_fragment(golden::SurfaceSample sample,
                                  const reference::UnitFragment& fragment) {
  sample.u = std::ldexp(fragment.u, -20);
  sample.v = std::ldexp(fragment.v, -20);
  return sample;
}

class EffectAccuracy : public testing::TestWithParam<Case> {};

TEST_P(EffectAccuracy, LiesWithinTheBoundDerivedFromTheBits) {
  const UnitJob job = point_sampled(GetParam());
  const golden::UnitRenderer renderer(job.scene, job.textures, job.extras);
  std::size_t compared = 0;
  double worst = 0, widest = 0, mean = 0;
  for (const UnitFrameInput& frame : job.frames) {
    for (std::size_t i = 0; i < frame.samples.size(); ++i) {
      const reference::UnitFragment& fragment = frame.fragments[i];
      const golden::SurfaceSample sample = at_fragment(frame.samples[i], fragment);
      const DerivedBound bound(job, sample, fragment);
      ASSERT_EQ(bound.wrong_input(), "") << "(" << sample.x << ", " << sample.y << ")";
      const golden::Rgb right = renderer.shade(sample, sample.light_vertex, sample.half_vertex);
      const reference::UnitPixel pixel = reference::shade(job.config, job.state, fragment);
      for (std::size_t c = 0; c < 3; ++c) {
        const Interval range = bound.channel(c);
        ASSERT_TRUE(range.holds(right[c])) << "the bound is not around golden's";
        ASSERT_TRUE(range.holds(pixel.rgb[c]))
            << "(" << sample.x << ", " << sample.y << "), channel " << c << ": golden " << right[c]
            << ", reference " << int{pixel.rgb[c]} << ", bound " << range.lo << " to " << range.hi;
        worst = std::max(worst, std::abs(pixel.rgb[c] - right[c]));
        widest = std::max(widest, range.hi - range.lo);
        mean += range.hi - range.lo;
        ++compared;
      }
    }
  }
  std::cout << GetParam().scene << ", " << GetParam().preset << ": largest difference " << worst
            << " levels; bounds are " << mean / static_cast<double>(compared)
            << " levels wide on average, " << widest << " at most\n";
  EXPECT_GT(compared, 0U);
}

INSTANTIATE_TEST_SUITE_P(Scenes, EffectAccuracy, testing::ValuesIn(cases()), [](const auto& which) {
  return which.param.scene + "_" + which.param.preset;
});

}  // namespace
}  // namespace ptm::testbench
