#include "model/pipeline/unit/loose_sample.h"

#include <algorithm>

namespace ptm::pipeline {
namespace {

using reference::LevelChoice;
using reference::UnitFragment;
using reference::Value;
using reference::Wrap;

/// Share of the fragments that meet a seam which splits their beats.
double seam_share(Wrap wrap, bool both, int size) {
  if (!both || wrap != Wrap::repeat || !collide(size - 1, 0)) return 0;
  return 1.0 / size;
}

}  // namespace

std::uint64_t LooseEye::look_deep(const DrawPlan& draw, const UnitFragment& fragment,
                                  std::uint64_t hash) {
  for (unsigned n = 0; n < draw.texture_count; ++n) {
    const TexturePlan& texture = draw.texture[n];
    const LevelChoice choice = reference::choose_level(draw.draw, fragment, texture.texture);
    two_levels_ = two_levels_ || choice.weight != 0;
    for (int probe = 0; probe < 1 << fragment.probes_log2; ++probe) {
      const Value u =
          reference::probe_coordinate(fragment.u, fragment.axis_u, probe, fragment.probes_log2);
      const Value v =
          reference::probe_coordinate(fragment.v, fragment.axis_v, probe, fragment.probes_log2);
      hash = place(draw, texture, choice.level, u, v, hash);
      if (choice.weight != 0) hash = place(draw, texture, choice.level + 1, u, v, hash);
    }
  }
  return hash;
}

LooseCost LooseEye::cost(const DrawPlan& draw) const {
  double splits = 1;
  unsigned map_taps = 0;
  for (const Part& part : parts()) {
    const LevelPlan& level = part.texture->level[static_cast<std::size_t>(part.level)];
    splits =
        std::max(splits, (1 + seam_share(draw.draw.wrap_u, part.span.across.both, level.width)) *
                             (1 + seam_share(draw.draw.wrap_v, part.span.down.both, level.height)));
    if (part.texture->texture == 0) map_taps = std::max(map_taps, part.span.tap_count());
  }
  const double footprints = static_cast<double>((two_levels_ ? 2U : 1U) << probes_log2_);
  const double beats = draw.beats;
  LooseCost cost{beats * footprints * splits, 0};
  double palette = 0;
  if (draw.palette_ports != 0) {
    const unsigned look_ups = (map_taps + draw.palette_ports - 1) / draw.palette_ports;
    palette = (beats - 1 + std::max<double>(look_ups, splits)) * footprints;
  }
  cost.commit =
      std::max({cost.beats, palette, static_cast<double>(draw.passes + draw.extra_passes)});
  return cost;
}

}  // namespace ptm::pipeline
