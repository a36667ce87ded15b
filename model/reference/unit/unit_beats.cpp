#include "model/reference/unit/unit_beats.h"

#include "model/reference/effects/stages.h"
#include "model/reference/unit/texel_fields.h"

namespace ptm::reference {
namespace {

BeatWord beat_word(const Draw& draw, const EvalConfig& eval, const UnitFragment& fragment,
                   const Beat& beat, int word) {
  BeatWord out;
  if (word >= draw_words(draw, eval)) return out;
  const WordUse use = word_use(draw, eval, word);
  const TextureLevels& texture = use.texture == 0 ? draw.map : draw.color_texture;
  const int planes = use.texture == 0 ? array_planes(draw, eval) : 1;
  const Footprint footprint =
      make_footprint(draw, fragment, use.texture, beat.probe, beat.footprint);
  out.present = true;
  out.word = word;
  out.texture = use.texture;
  out.plane = use.plane;
  out.level = footprint.level;
  out.taps = footprint.taps();
  for (unsigned t = 0; t < kTaps; ++t) {
    if ((out.taps >> t & 1U) == 0) continue;
    TapRead& tap = out.tap[t];
    tap.i = t == 1 || t == 3 ? footprint.i1 : footprint.i0;
    tap.j = t >= 2 ? footprint.j1 : footprint.j0;
    tap.tile_x = tap.i / 4;
    tap.tile_y = tap.j / 4;
    tap.place = place_of(texture, planes, out.level, out.plane, tap.i, tap.j);
  }
  return out;
}

/// Of two texels' columns, or rows.
bool collide(std::int32_t a, std::int32_t b) {
  const bool one_data_bank = a != b && a % 2 == b % 2;
  const bool one_tag_bank = a / 4 != b / 4 && a / 4 % 2 == b / 4 % 2;
  return one_data_bank || one_tag_bank;
}

Beat with_taps(const Beat& beat, unsigned taps) {
  Beat out = beat;
  for (BeatWord& word : out.tmu) {
    word.taps &= taps;
    for (unsigned t = 0; t < kTaps; ++t) {
      if ((word.taps >> t & 1U) == 0) word.tap[t] = {};
    }
  }
  return out;
}

unsigned tap_count(unsigned taps) {
  unsigned count = 0;
  for (unsigned t = 0; t < kTaps; ++t) count += taps >> t & 1U;
  return count;
}

/// multiplies_address, of a beat before it is split.
unsigned address_multiplies(const UnitFragment& fragment, const Beat& beat) {
  bool map = false, color = false;
  for (const BeatWord& word : beat.tmu) {
    map = map || (word.present && word.texture == 0);
    color = color || (word.present && word.texture == 1);
  }
  return (fragment.probes_log2 > 0 ? 2U : 0U) + (map ? 4U : 0U) + (color ? 4U : 0U);
}

/// multiplies_filter, of one word of a beat before it is split.
unsigned filter_multiplies(const Draw& draw, const EvalConfig& eval, const Beat& beat,
                           const BeatWord& word) {
  if (word.taps == 0) return 0;
  const unsigned a_field = (draw.bilinear ? 3U : 0U) + (beat.footprint == 1 ? 1U : 0U);
  return a_field * word_use(draw, eval, word.word).fields;
}

unsigned combine_multiplies(Combine combine) {
  switch (combine) {
    case Combine::modulate:
      return 3;
    case Combine::decal:
    case Combine::blend:
      return 6;
    default:
      return 0;
  }
}

bool is_palette(const Draw& draw, const BeatWord& word) {
  return word.word == 0 && format_row(draw.format).palette != contract::PaletteKind::none;
}

void count_beat(const Draw& draw, const EvalConfig& eval, const UnitFragment& fragment,
                const Beat& beat, UnitCounters& counters) {
  const std::size_t parts = split_beat(beat).size();
  counters[UnitCounter::beats] += parts;
  counters[UnitCounter::bank_conflicts] += parts - 1;
  counters[UnitCounter::multiplies_address] += address_multiplies(fragment, beat);
  for (const BeatWord& word : beat.tmu) {
    if (word.taps == 0) continue;
    counters[UnitCounter::words] += 1;
    counters[UnitCounter::taps] += tap_count(word.taps);
    counters[UnitCounter::multiplies_filter] += filter_multiplies(draw, eval, beat, word);
    if (is_palette(draw, word)) counters[UnitCounter::palette_lookups] += tap_count(word.taps);
  }
}

}  // namespace

std::vector<Beat> fragment_beats(const Draw& draw, const UnitFragment& fragment,
                                 const UnitConfig& config, const EvalConfig& eval) {
  std::vector<Beat> out;
  const int groups = (draw_words(draw, eval) + config.tmus - 1) / config.tmus;
  for (int probe = 0; probe < 1 << fragment.probes_log2; ++probe) {
    for (int footprint = 0; footprint < footprint_count(draw, fragment); ++footprint) {
      for (int group = 0; group < groups; ++group) {
        Beat beat;
        beat.probe = probe;
        beat.footprint = footprint;
        beat.group = group;
        for (int t = 0; t < config.tmus; ++t) {
          beat.tmu[static_cast<std::size_t>(t)] =
              beat_word(draw, eval, fragment, beat, group * config.tmus + t);
        }
        out.push_back(beat);
      }
    }
  }
  out.back().last = true;
  return out;
}

SeamCollision seam_collision(const Beat& beat) {
  SeamCollision out;
  for (const BeatWord& word : beat.tmu) {
    const bool columns = (word.taps & 2U) != 0, rows = (word.taps & 4U) != 0;
    out.in_u = out.in_u || (columns && collide(word.tap[0].i, word.tap[1].i));
    out.in_v = out.in_v || (rows && collide(word.tap[0].j, word.tap[2].j));
  }
  return out;
}

std::vector<Beat> split_beat(const Beat& beat) {
  const SeamCollision collision = seam_collision(beat);
  std::vector<unsigned> masks{0b1111};
  if (collision.in_u && collision.in_v) {
    masks = {0b0001, 0b0010, 0b0100, 0b1000};
  } else if (collision.in_u) {
    masks = {0b0101, 0b1010};
  } else if (collision.in_v) {
    masks = {0b0011, 0b1100};
  }
  std::vector<Beat> out;
  for (const unsigned mask : masks) {
    out.push_back(with_taps(beat, mask));
    out.back().sub_last = false;
  }
  out.back().sub_last = true;
  return out;
}

void count_fragment(const Draw& draw, const UnitFragment& fragment, const UnitConfig& config,
                    UnitCounters& counters, const EvalConfig& eval) {
  counters[UnitCounter::fragments] += 1;
  counters[UnitCounter::pixels] += 1;
  for (const Beat& beat : fragment_beats(draw, fragment, config, eval)) {
    count_beat(draw, eval, fragment, beat, counters);
  }
  counters[UnitCounter::multiplies_eval] += format_row(draw.format).multiplies;
  counters[UnitCounter::multiplies_eval] += 8 * static_cast<unsigned>(draw.effects.passes);
  counters[UnitCounter::multiplies_combine] += combine_multiplies(draw.combine);
  counters[UnitCounter::multiplies_effects] += effects::stage_multiplies(eval, draw);
}

}  // namespace ptm::reference
