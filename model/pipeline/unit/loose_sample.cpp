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

inline void LooseEye::look_at(const DrawPlan& draw, const TexturePlan& texture, int level,
                              const UnitFragment& fragment, LooseSample& sample) {
  const LevelPlan& plan = texture.level[static_cast<std::size_t>(level)];
  const int probes = 1 << fragment.probes_log2;
  for (int probe = 0; probe < probes; ++probe) {
    Value u = fragment.u, v = fragment.v;
    if (probes > 1) {
      u = reference::probe_coordinate(u, fragment.axis_u, probe, fragment.probes_log2);
      v = reference::probe_coordinate(v, fragment.axis_v, probe, fragment.probes_log2);
    }
    Part& part = parts_[count_++];
    part = {&texture, level, span_footprint(draw.draw, plan, u, v)};
    // Tiles alone: taps and seams change no look-up, but for the order.
    const std::uint64_t key = part.span.key(level) >> 6;
    sample.hash = (sample.hash ^ key) * 0x9E3779B97F4A7C15ULL;
    if (texture.texture == 0) map_taps_ = part.span.tap_count();
  }
  const FootprintSpan& span = parts_[count_ - 1].span;
  splits_ = std::max(splits_, (1 + seam_share(draw.draw.wrap_u, span.across.both, plan.width)) *
                                  (1 + seam_share(draw.draw.wrap_v, span.down.both, plan.height)));
}

LooseSample LooseEye::look(const DrawPlan& draw, const UnitFragment& fragment) {
  LooseSample sample;
  sample.hash = fragment.draw + 1U;
  count_ = 0;
  splits_ = 1;
  map_taps_ = 0;
  bool two_levels = false;
  for (unsigned n = 0; n < draw.texture_count; ++n) {
    const TexturePlan& texture = draw.texture[n];
    LevelChoice choice;
    if (draw.draw.mip != reference::Mip::none) {
      choice = reference::choose_level(draw.draw, fragment, texture.texture);
    }
    look_at(draw, texture, choice.level, fragment, sample);
    if (choice.weight == 0) continue;
    two_levels = true;
    look_at(draw, texture, choice.level + 1, fragment, sample);
  }
  const double footprints = static_cast<double>((two_levels ? 2U : 1U) << fragment.probes_log2);
  const double beats = draw.beats;
  sample.beats = beats * footprints * splits_;
  double palette = 0;
  if (draw.palette_ports != 0) {
    const unsigned look_ups = (map_taps_ + draw.palette_ports - 1) / draw.palette_ports;
    palette = (beats - 1 + std::max<double>(look_ups, splits_)) * footprints;
  }
  sample.commit = std::max({sample.beats, palette, static_cast<double>(draw.passes)});
  return sample;
}

}  // namespace ptm::pipeline
