#include "testbench/run/measure_effects.h"

#include <gtest/gtest.h>

#include "golden/scene/unit_scene.h"

namespace ptm::testbench {
namespace {

golden::DrawSpec draw_with(std::initializer_list<const char*> effects) {
  golden::DrawSpec draw;
  draw.map = 0;
  for (const char* name : effects) draw.effects.push_back({name, "", {}});
  return draw;
}

golden::UnitScene scene_with(const std::vector<golden::DrawSpec>& draws) {
  golden::UnitScene scene;
  for (std::size_t d = 0; d < draws.size(); ++d) {
    scene.objects.emplace_back().draw = static_cast<int>(d);
  }
  scene.draws = draws;
  return scene;
}

std::vector<std::string> names(const golden::DrawSpec& draw) {
  std::vector<std::string> list;
  for (const golden::EffectSpec& spec : draw.effects) list.push_back(spec.effect);
  return list;
}

using Names = std::vector<std::string>;

TEST(WithoutEffect, TakesItFromEveryObjectAndLeavesTheOthers) {
  const auto reduced = without_effect(
      scene_with({draw_with({"half-vector", "fresnel"}), draw_with({"fresnel", "diffuse-gain"})}),
      "fresnel");
  ASSERT_EQ(reduced.scene.draws.size(), 2U);
  EXPECT_EQ(names(reduced.scene.draws[0]), Names{"half-vector"});
  EXPECT_EQ(names(reduced.scene.draws[1]), Names{"diffuse-gain"});
  EXPECT_EQ(reduced.together, Names{});
}

TEST(WithoutEffect, TakesWhatOnlyChangesTheEffectWithIt) {
  const auto reduced = without_effect(
      scene_with({draw_with({"half-vector", "off-specular", "fresnel", "light-extrapolation"})}),
      "half-vector");
  EXPECT_EQ(names(reduced.scene.draws[0]), Names{"light-extrapolation"});
  EXPECT_EQ(reduced.together, (Names{"off-specular", "fresnel"}));
}

TEST(WithoutEffect, MakesOneOfDrawsThatThenAgree) {
  const auto reduced =
      without_effect(scene_with({draw_with({"diffuse-gain"}), draw_with({})}), "diffuse-gain");
  EXPECT_EQ(reduced.scene.draws.size(), 1U);
  EXPECT_EQ(reduced.scene.objects[0].draw, 0);
  EXPECT_EQ(reduced.scene.objects[1].draw, 0);
}

TEST(WithoutEffect, CombinesNothingWhereTheEffectBroughtTheColour) {
  golden::DrawSpec normals = draw_with({"diffuse-gain", "normals"});
  normals.combine = golden::CombineMode::blend;
  const golden::UnitScene scene = scene_with({normals});
  EXPECT_EQ(without_effect(scene, "normals").scene.draws[0].combine, golden::CombineMode::none);
  EXPECT_EQ(without_effect(scene, "diffuse-gain").scene.draws[0].combine,
            golden::CombineMode::blend);
}

}  // namespace
}  // namespace ptm::testbench
