#pragma once
#include <span>

#include "model/pipeline/unit/draw_plan.h"
#include "model/pipeline/unit/footprint_tiles.h"
#include "model/pipeline/unit/tag_cache.h"

namespace ptm::pipeline {

/// What timing `loose` sees of one fragment.
struct LooseSample {
  std::uint64_t hash = 0;  ///< equal: the same look-ups
  double beats = 1;        ///< expected, splits included
  double commit = 1;       ///< cycles between this fragment and the next at the commit stage
};

/// Looks at single fragments.
class LooseEye {
 public:
  LooseSample look(const DrawPlan& draw, const reference::UnitFragment& fragment);

  /// Tiles of the fragment looked at last.
  struct Part {
    const TexturePlan* texture = nullptr;
    int level = 0;
    FootprintSpan span;
  };
  [[nodiscard]] std::span<const Part> parts() const { return {parts_.data(), count_}; }

 private:
  void look_at(const DrawPlan& draw, const TexturePlan& texture, int level,
               const reference::UnitFragment& fragment, LooseSample& sample);

  std::array<Part, 64> parts_{};
  std::size_t count_ = 0;
  double splits_ = 1;  ///< sub-beats to be expected of a beat
  unsigned map_taps_ = 0;
};

}  // namespace ptm::pipeline
