// What a fragment's beats read and where their lines stand: the page's first two sections.
#include <algorithm>
#include <set>

#include "tests/pipeline/stepped_unit.h"

namespace ptm::tests {

using reference::Draw;
using reference::Footprint;
using reference::TextureFormat;
using reference::UnitCounter;
using reference::UnitFragment;

namespace {

const reference::TextureLevels& levels_of(const Draw& draw, int texture) {
  return texture == 0 ? draw.map : draw.color_texture;
}

bool collides(bool fetched, std::int32_t a, std::int32_t b) {
  if (!fetched || a == b) return false;
  const bool same_texel_bank = a % 2 == b % 2;
  const bool same_tag_bank = a / 4 != b / 4 && (a / 4) % 2 == (b / 4) % 2;
  return same_texel_bank || same_tag_bank;
}

}  // namespace

/// Words of the map itself, and of a draw's sets: docs/spec/unit.md, "Words".
int SteppedUnit::own_words(const Draw& draw) const {
  switch (draw.format) {
    case TextureFormat::none:
      return 0;
    case TextureFormat::lrgb:
      return eval_.coef_bits > 10 ? 4 : 3;
    case TextureFormat::rgb:
      return eval_.coef_bits > 10 ? 9 : 6;
    default:
      return 1;
  }
}
int SteppedUnit::set_words(const Draw& draw) const {
  return (eval_.coef_bits > 10 ? 3 : 2) * draw.effects.sets;
}

SteppedUnit::Tap SteppedUnit::make_tap(const Draw& draw, const Word& word, const Footprint& at,
                                       unsigned number) const {
  const std::int32_t i = number % 2 == 1 ? at.i1 : at.i0;
  const std::int32_t j = number / 2 == 1 ? at.j1 : at.j0;
  const int planes = word.texture == 0 ? own_words(draw) + set_words(draw) : 1;
  Tap tap;
  tap.number = number;
  tap.line =
      reference::place_of(levels_of(draw, word.texture), planes, at.level, word.plane, i, j).line;
  const int tx = i / 4, ty = j / 4;
  tap.bank = static_cast<std::size_t>(ty % 2 * 2 + tx % 2);
  int k = 0;
  while ((1 << k) < reference::cache_sets(unit_)) ++k;
  const int kx = (k + 1) / 2, ky = k - kx;
  const int x = tx / 2, y = ty / 2;
  const int place = (y % (1 << ky)) * (1 << kx) + x % (1 << kx);
  const int other = word.plane + 3 * at.level + 5 * word.texture + x / (1 << kx) + y / (1 << ky);
  tap.set = static_cast<std::size_t>((place ^ other) % reference::cache_sets(unit_));
  return tap;
}

SteppedUnit::Word SteppedUnit::make_word(const Draw& draw, int word,
                                         const std::array<Footprint, 2>& footprints) const {
  const int map_words = own_words(draw);
  Word out;
  out.tmu = static_cast<std::size_t>(word % unit_.tmus);
  out.plane = word;
  if (draw.color && word == map_words) {
    out.texture = 1;
    out.plane = 0;
  } else if (word >= map_words) {
    out.set = true;
    if (draw.color) --out.plane;
  }
  out.palette = word == 0 && (draw.format == TextureFormat::palette_lrgb ||
                              draw.format == TextureFormat::palette_rgb);
  const Footprint& at = footprints[static_cast<std::size_t>(out.texture)];
  for (unsigned tap = 0; tap < reference::kTaps; ++tap) {
    if ((at.taps() >> tap & 1) != 0) out.taps.push_back(make_tap(draw, out, at, tap));
  }
  return out;
}

/// Counters of a beat before it is split.
void SteppedUnit::book_beat(const Beat& beat, const UnitFragment& fragment, int footprint) {
  auto& c = result_.counters;
  std::set<int> textures;
  for (const Word& word : beat.words) {
    textures.insert(word.texture);
    if (word.taps.empty()) continue;
    ++c[UnitCounter::words];
    std::uint64_t fields = eval_.coef_bits > 10 ? 2 : 3;
    if (word.texture == 1) fields = 4;
    if (word.texture == 0 && beat.draw->format == TextureFormat::lrgb &&
        word.plane + 1 == own_words(*beat.draw)) {
      fields = 4;
    }
    if (word.palette) fields = beat.draw->format == TextureFormat::palette_lrgb ? 9 : 18;
    if (beat.draw->bilinear) c[UnitCounter::multiplies_filter] += 3 * fields;
    if (footprint == 1) c[UnitCounter::multiplies_filter] += fields;
  }
  c[UnitCounter::multiplies_address] += 4 * textures.size();
  if (fragment.probes_log2 > 0) c[UnitCounter::multiplies_address] += 2;
}

/// Counters of a fragment's extra passes and of the stages that act on it.
void SteppedUnit::book_effects(const Draw& draw) {
  auto& c = result_.counters;
  const reference::DrawEffects& e = draw.effects;
  for (int pass = 0; pass < e.passes; ++pass) c[UnitCounter::multiplies_eval] += 8;
  if ((e.stages & 1) != 0) c[UnitCounter::multiplies_effects] += eval_.lum_frac == 0 ? 1 : 2;
  if ((e.stages & 2) != 0) c[UnitCounter::multiplies_effects] += e.argument % 2 == 1 ? 3 : 1;
}

std::vector<SteppedUnit::Beat> SteppedUnit::make_beats(std::size_t number) {
  const UnitFragment& fragment = fragments_[number];
  const Draw& draw = draws_[fragment.draw];
  const int words = own_words(draw) + (draw.color ? 1 : 0) + set_words(draw);
  std::vector<Beat> beats;
  for (int probe = 0; probe < 1 << fragment.probes_log2; ++probe) {
    for (int m = 0; m < reference::footprint_count(draw, fragment); ++m) {
      const std::array<Footprint, 2> at{reference::make_footprint(draw, fragment, 0, probe, m),
                                        reference::make_footprint(draw, fragment, 1, probe, m)};
      for (int first = 0; first < words; first += unit_.tmus) {
        Beat beat;
        beat.fragment = number;
        beat.draw = &draw;
        for (int w = first; w < std::min(first + unit_.tmus, words); ++w) {
          beat.words.push_back(make_word(draw, w, at));
          const Footprint& f = at[static_cast<std::size_t>(beat.words.back().texture)];
          if (!f.fetched) continue;
          beat.split_u = beat.split_u || collides(f.columns(), f.i0, f.i1);
          beat.split_v = beat.split_v || collides(f.rows(), f.j0, f.j1);
        }
        book_beat(beat, fragment, m);
        beats.push_back(std::move(beat));
      }
    }
  }
  beats.back().last = true;
  auto& c = result_.counters;
  const bool rgb = reference::draw_passes(draw) == 3;
  if (draw.format != TextureFormat::none) c[UnitCounter::multiplies_eval] += rgb ? 24 : 11;
  using reference::Combine;
  if (draw.combine == Combine::modulate) c[UnitCounter::multiplies_combine] += 3;
  if (draw.combine == Combine::decal || draw.combine == Combine::blend) {
    c[UnitCounter::multiplies_combine] += 6;
  }
  book_effects(draw);
  return beats;
}

std::vector<SteppedUnit::Beat> SteppedUnit::split(const Beat& beat) {
  std::vector<std::set<unsigned>> parts{{0, 1, 2, 3}};
  if (beat.split_u && beat.split_v) {
    parts = {{0}, {1}, {2}, {3}};
  } else if (beat.split_u) {
    parts = {{0, 2}, {1, 3}};
  } else if (beat.split_v) {
    parts = {{0, 1}, {2, 3}};
  }
  std::vector<Beat> out;
  for (const auto& part : parts) {
    Beat sub = beat;
    for (Word& word : sub.words) {
      std::erase_if(word.taps, [&](const Tap& tap) { return !part.contains(tap.number); });
    }
    sub.completes = out.size() + 1 == parts.size();
    sub.last = beat.last && sub.completes;
    out.push_back(std::move(sub));
  }
  return out;
}

SteppedUnit::Way* SteppedUnit::find(std::size_t tmu, const Tap& tap) {
  for (Way& way : cache_[tmu][tap.bank][tap.set]) {
    if (way.valid && way.line == tap.line) return &way;
  }
  return nullptr;
}

void SteppedUnit::allocate(std::size_t tmu, const Tap& tap) {
  auto& set = cache_[tmu][tap.bank][tap.set];
  const auto older = [](const Way& a, const Way& b) {
    return (a.valid ? a.used + 1 : 0) < (b.valid ? b.used + 1 : 0);
  };
  *std::ranges::min_element(set, older) = {true, tap.line, uses_};
}

/// All TMUs look at the same state; what they find changes it afterwards.
void SteppedUnit::look_up(Beat& beat) {
  beat.looked_up = true;
  ++uses_;
  std::vector<std::pair<std::size_t, Tap>> hits;
  std::vector<std::vector<Tap>> misses(static_cast<std::size_t>(unit_.tmus));
  auto& c = result_.counters;
  for (const Word& word : beat.words) {
    std::set<std::uint32_t> lines;
    const auto draw = static_cast<int>(beat.draw - draws_.data());
    for (const Tap& tap : word.taps) {
      if (!lines.insert(tap.line).second) continue;
      const bool hit = find(word.tmu, tap) != nullptr;
      ++c[hit ? UnitCounter::tag_hits : UnitCounter::tag_misses];
      ++(hit ? c.hits(draw, word.texture) : c.misses(draw, word.texture));
      if (hit) {
        hits.emplace_back(word.tmu, tap);
        continue;
      }
      misses[word.tmu].push_back(tap);
      bool elsewhere = false;
      for (std::size_t other = 0; other < misses.size(); ++other) {
        elsewhere = elsewhere || (other != word.tmu && find(other, tap) != nullptr);
      }
      if (elsewhere) ++c[UnitCounter::duplicate_lines];
    }
  }
  for (const auto& [tmu, tap] : hits) find(tmu, tap)->used = uses_;
  for (std::size_t tmu = 0; tmu < misses.size(); ++tmu) {
    for (std::size_t r = 0; r < misses[tmu].size(); ++r) {
      allocate(tmu, misses[tmu][r]);
      if (beat.ranks.size() <= r) beat.ranks.emplace_back();
      beat.ranks[r].push_back(misses[tmu][r].line);
    }
  }
}

}  // namespace ptm::tests
