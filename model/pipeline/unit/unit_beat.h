#pragma once
#include <array>

#include "model/pipeline/stream_timing.h"
#include "model/pipeline/unit/draw_plan.h"
#include "model/pipeline/unit/footprint_tiles.h"
#include "model/reference/unit/unit_fragment.h"

namespace ptm::pipeline {

/// Later than any cycle of a run: what waits for a line that never comes happens then.
inline constexpr Cycle kStuck = Cycle{1} << 62;

/// A beat behind the address stage, sub-beats of a split one included; the blocks hand it on.
struct UnitBeat {
  const DrawPlan* draw = nullptr;
  const BeatPlan* plan = nullptr;
  const std::array<FootprintTiles, 2>* tiles = nullptr;  ///< of map and colour
  const reference::UnitFragment* fragment = nullptr;
  unsigned mask = 15;     ///< taps of a sub-beat
  bool completes = true;  ///< the beat's last sub-beat
  bool last = true;       ///< it completes its fragment
  /// The fragment's look-ups are those of the one before, which all hit: they change nothing.
  bool repeats = false;
  unsigned ranks = 0;
  std::array<Cycle, 4> usable{};  ///< from when on a rank's lines may be committed
};

}  // namespace ptm::pipeline
