#pragma once
#include <tuple>

#include "model/reference/unit/shade.h"

/// Steps U1 to U9 of a whole fragment, for shade.cpp and shade_effects.cpp alone: templates over
/// the configuration (constant_config.h) and over the fields, which are kSetField, or kFields if
/// the draw may have extra sets. Each of the two files has an instance of its own, in an unnamed
/// namespace: what is local and called from one place is inlined there.
namespace ptm::reference::shading {
namespace {

template <class Some>
inline constexpr bool kHasSets = std::tuple_size_v<Some> == kFields;

/// What one texture's part of a footprint is filtered with.
struct Weights {
  unsigned taps = 0;  ///< bit t: tap t is fetched
  Value wu = 0, wv = 0;
};

/// The four words of a plane, 0 where a tap is not fetched; of a palette's entries 64 bits each.
template <class Word>
using WordsOf = std::array<Word, kTaps>;
using Words = WordsOf<std::uint32_t>;

/// Where a footprint's taps lie: the first plane's lines, and the word in each.
struct TapPlaces {
  std::array<TexelPlace, kTaps> at{};
};

inline TapPlaces places(const TextureLevels& texture, int planes, const Footprint& footprint) {
  TapPlaces out;
  const unsigned taps = footprint.taps();
  for (unsigned t = 0; t < kTaps; ++t) {
    if ((taps >> t & 1U) == 0) continue;
    out.at[t] =
        place_of(texture, planes, footprint.level, 0, (t & 1U) != 0 ? footprint.i1 : footprint.i0,
                 (t & 2U) != 0 ? footprint.j1 : footprint.j0);
  }
  return out;
}

inline Words read_words(const std::vector<Line>& memory, const TapPlaces& places, unsigned taps,
                        int plane) {
  Words out{};
  for (unsigned t = 0; t < kTaps; ++t) {
    if ((taps >> t & 1U) == 0) continue;
    out[t] = memory[places.at[t].line + static_cast<std::uint32_t>(plane)][places.at[t].word];
  }
  return out;
}

/// Entries of a palette of a draw; an entry beyond the table is 0.
template <class Entries>
typename Entries::value_type entry_at(const Entries& entries, std::uint32_t index) {
  return index < entries.size() ? entries[index] : typename Entries::value_type{};
}

/// U7 of `count` fields of `bits` bits that lie in a word from its lowest bit on, into out.
template <class Config, class Word>
[[gnu::always_inline]] inline void filter_fields(const Config& constant, const WordsOf<Word>& words,
                                                 const Weights& weights, unsigned count, int bits,
                                                 Value* out) {
  const EvalConfig& config = constant;
  const Word mask = (Word{1} << bits) - 1U;
  for (unsigned k = 0; k < count; ++k) {
    Taps<Value> taps{};
    for (unsigned t = 0; t < kTaps; ++t) {
      const Word field = words[t] >> (k * static_cast<unsigned>(bits)) & mask;
      taps[t] = shift_left(static_cast<Value>(field), config.filter_frac);
    }
    out[k] = bilinear(config.rounding, taps, weights.wu, weights.wv);
  }
}

/// U7 of an entry's coefficients: entries are filtered, never indices.
template <class Config, class Entries>
void filter_entries(const Config& config, const Entries& entries, std::uint32_t first,
                    const Words& indices, const Weights& weights, Value* out) {
  std::array<typename Entries::value_type, kTaps> looked_up{};
  for (unsigned t = 0; t < kTaps; ++t) {
    if ((weights.taps >> t & 1U) != 0) looked_up[t] = entry_at(entries, first + indices[t]);
  }
  const int bits = field_bits(config);
  for (unsigned w = 0; w < looked_up[0].size(); ++w) {
    const WordsOf<std::uint64_t> words{looked_up[0][w], looked_up[1][w], looked_up[2][w],
                                       looked_up[3][w]};
    filter_fields(config, words, weights, 3, bits, out + 3 * w);
  }
}

/// U7 of all fields of one word.
template <class Config, class Some>
void filter_word(const Config& config, const UnitState& state, const Draw& draw, const WordUse& use,
                 const Words& words, const Weights& weights, Some& out) {
  switch (use.kind) {
    case WordKind::coefficients:
      filter_fields(config, words, weights, static_cast<unsigned>(coefficients_a_word(config)),
                    field_bits(config), &out[use.field]);
      return;
    case WordKind::color:
      filter_fields(config, words, weights, 4, 8, &out[use.field]);
      return;
    case WordKind::palette_lrgb: {
      Words index{}, color{};
      for (unsigned t = 0; t < kTaps; ++t) {
        index[t] = words[t] & 255U;
        color[t] = words[t] >> 8;
      }
      const auto first = static_cast<std::uint32_t>(draw.palette) * kLrgbEntries;
      filter_entries(config, state.palettes.lrgb, static_cast<std::uint32_t>(first), index, weights,
                     out.data());
      filter_fields(config, color, weights, 3, 8, &out[kMapColorField]);
      return;
    }
    case WordKind::palette_rgb: {
      Words index{};
      for (unsigned t = 0; t < kTaps; ++t) index[t] = words[t] & 4095U;
      filter_entries(config, state.palettes.rgb, 0, index, weights, out.data());
      return;
    }
  }
}

/// U1 to U7 of one texture in one footprint of one probe. Leaves out as it is where nothing is
/// fetched.
template <class Config, class Some>
void filter_texture(const Config& config, const UnitState& state, const Draw& draw, int texture,
                    const Footprint& footprint, Some& out) {
  const TextureLevels& levels = texture == 0 ? draw.map : draw.color_texture;
  const int planes = texture == 0 ? map_planes(draw.format, config) : 1;
  const int first_word = texture == 0 ? 0 : map_planes(draw.format, config);
  const int sets =
      kHasSets<Some> && texture == 0 ? polynomial_words(config) * draw.effects.sets : 0;
  const TapPlaces at = places(levels, planes + sets, footprint);
  const Weights weights{footprint.taps(), footprint.wu, footprint.wv};
  for (int plane = 0; plane < planes; ++plane) {
    const Words words = read_words(state.memory, at, weights.taps, plane);
    filter_word(config, state, draw, own_word_use(draw, config, first_word + plane), words, weights,
                out);
  }
  if constexpr (kHasSets<Some>) {
    for (int plane = 0; plane < sets; ++plane) {
      const Words words = read_words(state.memory, at, weights.taps, planes + plane);
      filter_word(config, state, draw, set_word_use(draw, config, plane), words, weights, out);
    }
  }
}

/// f(k) for the fields that a texture of a draw fills.
template <class Some, class F>
[[gnu::always_inline]] inline void for_fields(const Draw& draw, int texture, F&& f) {
  const unsigned first = texture == 0 ? 0 : kColorField;
  const unsigned end = texture == 0 ? kColorField : kSetField;
  for (unsigned k = first; k < end; ++k) f(k);
  if constexpr (kHasSets<Some>) {
    if (texture != 0) return;
    const auto sets = static_cast<unsigned>(draw.effects.sets);
    for (unsigned k = kSetField; k < kSetField + 6 * sets; ++k) f(k);
  }
}

/// U8 of one texture and probe, added to the sum of probes.
template <class Config, class Some>
void add_probe(const Config& constant, const UnitState& state, const Draw& draw,
               const UnitFragment& fragment, int texture, int probe, Some& sum) {
  const EvalConfig& config = constant;
  const Footprint first = make_footprint(draw, fragment, texture, probe, 0);
  if (!first.fetched) return;
  Some one{};
  filter_texture(constant, state, draw, texture, first, one);
  if (first.level_weight != 0) {
    Some two{};
    const Footprint second = make_footprint(draw, fragment, texture, probe, 1);
    filter_texture(constant, state, draw, texture, second, two);
    for_fields<Some>(draw, texture, [&](unsigned k) {
      one[k] = lerp(config.rounding, one[k], two[k], Value{first.level_weight});
    });
  }
  for_fields<Some>(draw, texture, [&](unsigned k) { sum[k] += one[k]; });
}

/// U1 to U9.
template <class Some, class Config>
Some filter_fragment(const Config& constant, const UnitState& state, const Draw& draw,
                     const UnitFragment& fragment) {
  const EvalConfig& config = constant;
  Some sum{};
  for (int probe = 0; probe < 1 << fragment.probes_log2; ++probe) {
    add_probe(constant, state, draw, fragment, 0, probe, sum);
    add_probe(constant, state, draw, fragment, 1, probe, sum);
  }
  if (fragment.probes_log2 == 0) return sum;
  for (Value& field : sum) {
    field = probe_mean(config.rounding, field, Value{fragment.probes_log2});
  }
  return sum;
}

}  // namespace
}  // namespace ptm::reference::shading
