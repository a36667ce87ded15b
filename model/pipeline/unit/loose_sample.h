#pragma once
#include <span>

#include "model/pipeline/unit/draw_plan.h"
#include "model/pipeline/unit/footprint_tiles.h"
#include "model/pipeline/unit/tag_cache.h"

namespace ptm::pipeline {

/// What a fragment like the one looked at last costs.
struct LooseCost {
  double beats = 1;   ///< expected, splits included
  double commit = 1;  ///< cycles between this fragment and the next at the commit stage
};

/// Looks at single fragments.
class LooseEye {
 public:
  /// Equal hashes: the same tiles.
  std::uint64_t look(const DrawPlan& draw, const reference::UnitFragment& fragment) {
    count_ = 0;
    two_levels_ = false;
    probes_log2_ = fragment.probes_log2;
    std::uint64_t hash = fragment.draw + 1U;
    if (draw.draw.mip != reference::Mip::none || fragment.probes_log2 != 0) {
      return look_deep(draw, fragment, hash);
    }
    for (unsigned n = 0; n < draw.texture_count; ++n) {
      hash = place(draw, draw.texture[n], 0, fragment.u, fragment.v, hash);
    }
    return hash;
  }
  [[nodiscard]] LooseCost cost(const DrawPlan& draw) const;

  /// One texture's part of a probe at a level, of the fragment looked at last.
  struct Part {
    const TexturePlan* texture = nullptr;
    int level = 0;
    FootprintSpan span;
  };
  [[nodiscard]] std::span<const Part> parts() const { return {parts_.data(), count_}; }

 private:
  std::uint64_t place(const DrawPlan& draw, const TexturePlan& texture, int level,
                      reference::Value u, reference::Value v, std::uint64_t hash) {
    Part& part = parts_[count_++];
    part.texture = &texture;
    part.level = level;
    part.span = span_footprint(draw.draw, texture.level[static_cast<std::size_t>(level)], u, v);
    // Tiles alone: taps and seams change no look-up, but for the order.
    return (hash ^ part.span.key(level) >> 6) * 0x9E3779B97F4A7C15ULL;
  }
  std::uint64_t look_deep(const DrawPlan& draw, const reference::UnitFragment& fragment,
                          std::uint64_t hash);

  std::array<Part, 64> parts_{};
  std::size_t count_ = 0;
  bool two_levels_ = false;
  int probes_log2_ = 0;
};

}  // namespace ptm::pipeline
