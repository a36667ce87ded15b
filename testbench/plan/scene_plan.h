#pragma once
#include <string>
#include <vector>

#include "golden/effects/effect.h"
#include "golden/scene/textures.h"
#include "golden/scene/unit_scene.h"
#include "model/reference/unit/draw.h"
#include "model/reference/unit/unit_config.h"
#include "model/reference/unit/unit_counters.h"
#include "model/reference/unit/unit_fragment.h"

/// What a scene calls for, and what it will cost: known before anything is drawn.
namespace ptm::testbench {

/// A pixel whose lines are all hits, of the least footprint that the draw's filter can ask for, or
/// of the largest; docs/spec/unit-timing.md and effects.md, counted by the reference.
struct PixelCost {
  int footprints = 1, probes = 1;
  std::uint64_t words = 0, taps = 0;
  std::uint64_t address = 0, filter = 0, eval = 0, combine = 0, effects = 0;  ///< multiplies
  int cycles = 1;
  [[nodiscard]] std::uint64_t multiplies() const {
    return address + filter + eval + combine + effects;
  }
};

struct PlannedDraw {
  std::string map, color;            ///< textures' names; empty: none
  std::vector<std::string> effects;  ///< names
  int words = 0;                     ///< a texel, over all planes
  int passes = 1, extra_passes = 0;  ///< the map's own, and effects'
  std::vector<std::string> stages;   ///< that act on its pixels
  PixelCost least, most;
};

/// A part of the unit that not every scene needs.
struct PlannedBlock {
  std::string name;                  ///< "extra_sets", "power", ...
  std::string what;                  ///< "4 coefficient sets", ...
  std::vector<std::string> effects;  ///< that ask for it
};

struct ScenePlan {
  std::vector<PlannedDraw> draws;
  std::vector<PlannedBlock> blocks;  ///< of effects; empty if no draw has one that needs hardware
  reference::UnitConfig unit;        ///< the scene's hardware with what its effects need built in
};

/// Cycles of one fragment whose lines are all hits and that no seam splits:
/// docs/spec/unit-timing.md, "Cycles per pixel"; docs/spec/effects.md, "Time".
[[nodiscard]] int warm_cycles(const reference::Draw& draw, const reference::UnitConfig& unit,
                              const reference::UnitFragment& fragment,
                              const reference::EvalConfig& config);

/// What effects add to a draw's descriptor, but for bias and shift of its sets.
[[nodiscard]] reference::DrawEffects planned_effects(const golden::DrawSpec& spec,
                                                     const golden::DrawExtras& extras);

/// The plan of a scene whose effects have prepared its draws (golden::prepare_effects). `unit` is
/// the scene's hardware without effects.
[[nodiscard]] ScenePlan plan_scene(const golden::UnitScene& scene,
                                   const golden::LoadedTextures& textures,
                                   const std::vector<golden::DrawExtras>& extras,
                                   const reference::EvalConfig& config,
                                   const reference::UnitConfig& unit);

}  // namespace ptm::testbench
