#include "model/pipeline/unit/address.h"

namespace ptm::pipeline {

using reference::LevelChoice;
using reference::UnitFragment;
using reference::Value;

Address::~Address() = default;

void Address::reset() {
  registers_ = {};
  free_ = 0;
  footprints_ = 0;
  all_hit_ = false;
  counters_ = {};
  fragments_ = {};
}

inline void Address::place(const DrawPlan& draw, const TexturePlan& texture, unsigned at, int level,
                           Value u, Value v, bool second) {
  const auto t = static_cast<std::size_t>(texture.texture);
  const FootprintSpan span =
      span_footprint(draw.draw, texture.level[static_cast<std::size_t>(level)], u, v);
  FootprintTiles& tiles = tiles_[at][t];
  if (tiles.key != span.key(level)) {
    same_ = false;
    tiles = span.tiles(level);
  }
  split_ = split_ || span.split() != 0;
  counters_.words += draw.words_of[t];
  counters_.taps += draw.words_of[t] * span.tap_count();
  const unsigned lerps = (draw.draw.bilinear ? 3U : 0U) + (second ? 1U : 0U);
  counters_.multiplies_filter += draw.filter_fields[t] * lerps;
}

inline void Address::gather_texture(const DrawPlan& draw, const TexturePlan& texture,
                                    const UnitFragment& fragment, int level, bool two_levels,
                                    bool fetches_second) {
  const auto t = static_cast<std::size_t>(texture.texture);
  const int probes = 1 << fragment.probes_log2;
  unsigned at = 0;
  for (int probe = 0; probe < probes; ++probe) {
    Value u = fragment.u, v = fragment.v;
    if (probes > 1) {
      u = reference::probe_coordinate(u, fragment.axis_u, probe, fragment.probes_log2);
      v = reference::probe_coordinate(v, fragment.axis_v, probe, fragment.probes_log2);
    }
    place(draw, texture, at++, level, u, v, false);
    if (!two_levels) continue;
    if (fetches_second) {
      place(draw, texture, at++, level + 1, u, v, true);
    } else {
      same_ = same_ && tiles_[at][t].key == 0;
      tiles_[at++][t] = {};
    }
  }
}

unsigned Address::gather(const DrawPlan& draw, const UnitFragment& fragment, bool& repeats) {
  std::array<LevelChoice, 2> choice{};
  bool two_levels = false;
  if (draw.draw.mip != reference::Mip::none) {
    for (unsigned n = 0; n < draw.texture_count; ++n) {
      choice[n] = reference::choose_level(draw.draw, fragment, draw.texture[n].texture);
      two_levels = two_levels || choice[n].weight != 0;
    }
  }
  const unsigned footprints = (two_levels ? 2U : 1U) << fragment.probes_log2;
  same_ = footprints == footprints_ && fragment.draw == draw_;
  split_ = false;
  if (same_ && footprints == 1 && draw.texture_count == 1) [[likely]] {
    place(draw, draw.texture[0], 0, choice[0].level, fragment.u, fragment.v, false);
    repeats = same_ && all_hit_ && !split_;
    counters_.multiplies_address += draw.address_multiplies;
    return 1;
  }
  if (draw.texture_count < 2) {
    // What a draw before left there must not look like this one's.
    const std::size_t absent = draw.words_of[0] == 0 ? 0 : 1;
    if (!same_) {
      for (unsigned f = 0; f < footprints; ++f) tiles_[f][absent] = {};
    }
  }
  for (unsigned n = 0; n < draw.texture_count; ++n) {
    gather_texture(draw, draw.texture[n], fragment, choice[n].level, two_levels,
                   choice[n].weight != 0);
  }
  footprints_ = footprints;
  draw_ = fragment.draw;
  repeats = same_ && all_hit_ && !split_;
  counters_.multiplies_address +=
      footprints * (draw.address_multiplies + (fragment.probes_log2 != 0 ? 2 * draw.beats : 0));
  return footprints;
}

template <bool kEffects>
Cycle Address::send_split(UnitBeat& beat, unsigned split, Cycle offered) {
  static constexpr std::array<std::array<unsigned, 4>, 4> kMasks{
      {{15, 0, 0, 0}, {0b0101, 0b1010, 0, 0}, {0b0011, 0b1100, 0, 0}, {1, 2, 4, 8}}};
  const unsigned parts = split == (kSplitU | kSplitV) ? 4 : 2;
  const bool last = beat.last;
  Cycle sent = offered - 1;
  for (unsigned part = 0; part < parts; ++part) {
    beat.mask = kMasks[split][part];
    beat.completes = part + 1 == parts;
    beat.last = last && beat.completes;
    sent = out_.accept<kEffects>(beat, sent + 1);
  }
  beat.mask = 15;
  beat.completes = true;
  counters_.conflicts += parts - 1;
  return sent;
}

template Cycle Address::send_split<false>(UnitBeat&, unsigned, Cycle);
template Cycle Address::send_split<true>(UnitBeat&, unsigned, Cycle);

}  // namespace ptm::pipeline
