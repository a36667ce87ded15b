#pragma once
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "model/reference/unit/unit_counters.h"
#include "testbench/rtl/unit_cells.h"

/// What each of a scene's effects costs, as measure_effects() finds it.
namespace ptm::testbench {

/// One drawing of the scene, with or without an effect.
struct EffectRun {
  reference::UnitConfig unit;
  std::optional<reference::UnitCounters> counters;  ///< rtl's, else pipeline's
  std::optional<UnitCells> cells;                   ///< nothing without yosys
  std::vector<std::pair<std::string, double>> seconds;  ///< by model, all frames
};

/// The effect, and the scene without it. `with` less `without` is what it costs.
struct EffectCost {
  std::string effect;                 ///< its name
  std::vector<std::string> together;  ///< effects that mean nothing without it and went with it
  EffectRun without;
  /// Of golden's pictures (reference's, if golden did not run) with and without.
  double rmse = 0, largest = 0, psnr_db = 0;
  double changed = 0;  ///< share of samples
};

struct EffectCosts {
  EffectRun with;
  std::vector<EffectCost> costs;   ///< in the order of the rows of effects.def
  std::vector<std::string> notes;  ///< said to the user as they are
};

}  // namespace ptm::testbench
