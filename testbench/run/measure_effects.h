#pragma once
#include <functional>
#include <string>
#include <vector>

#include "golden/scene/unit_scene.h"
#include "testbench/run/run_scene.h"

/// What each of a scene's effects costs: the scene is drawn with each of them switched off in turn.
namespace ptm::testbench {

/// The scene without an effect, in every object, and without those that mean nothing without
/// it. Draws that then agree become one.
struct ReducedScene {
  golden::UnitScene scene;
  std::vector<std::string> together;
};
[[nodiscard]] ReducedScene without_effect(const golden::UnitScene& scene,
                                          const std::string& effect);

/// Draws the scene once more for each of its effects, without it, with the scene's models; `whole`
/// is what the scene itself gave. `say` is told what is done before it is done. An
/// effect without which the scene is no legal one is left out, with a note.
[[nodiscard]] EffectCosts measure_effects(const golden::UnitScene& scene, const SceneRun& whole,
                                          const std::function<void(const std::string&)>& say);

}  // namespace ptm::testbench
