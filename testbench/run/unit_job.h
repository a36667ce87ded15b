#pragma once
#include <string>
#include <vector>

#include "golden/scene/surface_samples.h"
#include "golden/scene/textures.h"
#include "golden/scene/unit_scene.h"
#include "model/pipeline/memory_timing.h"
#include "model/reference/unit/unit_config.h"
#include "model/reference/unit/unit_fragment.h"
#include "model/reference/unit/unit_memory.h"
#include "testbench/plan/scene_plan.h"

namespace ptm::testbench {

[[nodiscard]] std::string describe(const pipeline::MemoryModel& memory);

/// One light's samples and the fragments made from them, in order.
struct UnitFrameInput {
  std::vector<golden::SurfaceSample> samples;
  std::vector<reference::UnitFragment> fragments;
};

/// Everything that the models need to draw a scene through the whole unit.
struct UnitJob {
  golden::UnitScene scene;
  golden::LoadedTextures textures;
  reference::EvalConfig config;
  std::vector<golden::DrawExtras> extras;  ///< what effects add, one a draw
  ScenePlan plan;
  reference::UnitConfig unit;  ///< the plan's
  reference::UnitState state;
  pipeline::MemoryModel memory;
  pipeline::StreamTiming timing;  ///< gaps and stalls
  std::vector<UnitFrameInput> frames;
  std::vector<std::string> notes;  ///< how each map is stored
};

/// Loads, quantises and lays out a scene's textures, and makes its fragments. Throws
/// golden::InputError: what reading throws, a light that the configuration cannot express, more
/// palettes than the unit has, a draw that the unit would refuse.
[[nodiscard]] UnitJob make_unit_job(const golden::UnitScene& scene);

/// What a scene calls for; its textures are loaded, since effects ask them. Throws as above.
[[nodiscard]] ScenePlan make_scene_plan(const golden::UnitScene& scene);

/// The state of a scene's textures for another configuration: the table of presets.
[[nodiscard]] reference::UnitState make_unit_state(const golden::UnitScene& scene,
                                                   const golden::LoadedTextures& textures,
                                                   const std::vector<golden::DrawExtras>& extras,
                                                   const reference::EvalConfig& config,
                                                   std::vector<std::string>& notes);

/// The evaluator's configuration that a scene's [hardware] says. Throws InputError.
[[nodiscard]] reference::EvalConfig scene_eval_config(const golden::UnitScene& scene);

/// A frame's fragments for a configuration and its draws.
[[nodiscard]] std::vector<reference::UnitFragment> make_unit_fragments(
    const golden::UnitScene& scene, const reference::EvalConfig& config,
    const reference::UnitState& state, const std::vector<golden::SurfaceSample>& samples,
    std::size_t frame);

}  // namespace ptm::testbench
