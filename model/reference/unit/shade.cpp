#include "model/reference/unit/shade.h"

#include "model/reference/constant_config.h"
#include "model/reference/evaluate.h"

namespace ptm::reference {
namespace {

/// What one texture's part of a footprint is filtered with.
struct Weights {
  unsigned taps = 0;  ///< bit t: tap t is fetched
  Value wu = 0, wv = 0;
};

/// The four words of a plane, 0 where a tap is not fetched.
using Words = std::array<std::uint32_t, kTaps>;

/// Where a footprint's taps lie: the first plane's lines, and the word in each.
struct TapPlaces {
  std::array<TexelPlace, kTaps> at{};
};

TapPlaces places(const TextureLevels& texture, int planes, const Footprint& footprint) {
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

Words read_words(const std::vector<Line>& memory, const TapPlaces& places, unsigned taps,
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
template <class Config>
[[gnu::always_inline]] inline void filter_fields(const Config& constant, const Words& words,
                                                 const Weights& weights, unsigned count, int bits,
                                                 Value* out) {
  const EvalConfig& config = constant;
  const std::uint32_t mask = (1U << bits) - 1U;
  for (unsigned k = 0; k < count; ++k) {
    Taps<Value> taps{};
    for (unsigned t = 0; t < kTaps; ++t) {
      taps[t] = shift_left(Value{words[t] >> (k * static_cast<unsigned>(bits)) & mask},
                           config.filter_frac);
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
    const Words words{looked_up[0][w], looked_up[1][w], looked_up[2][w], looked_up[3][w]};
    filter_fields(config, words, weights, 3, bits, out + 3 * w);
  }
}

/// U7 of all fields of one word.
template <class Config>
void filter_word(const Config& config, const UnitState& state, const Draw& draw, const WordUse& use,
                 const Words& words, const Weights& weights, Fields& out) {
  switch (use.kind) {
    case WordKind::coefficients:
      filter_fields(config, words, weights, 3, field_bits(config), &out[use.field]);
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
template <class Config>
void filter_texture(const Config& config, const UnitState& state, const Draw& draw, int texture,
                    const Footprint& footprint, Fields& out) {
  const TextureLevels& levels = texture == 0 ? draw.map : draw.color_texture;
  const int planes = texture == 0 ? map_planes(draw.format) : 1;
  const int first_word = texture == 0 ? 0 : map_planes(draw.format);
  const TapPlaces at = places(levels, planes, footprint);
  const Weights weights{footprint.taps(), footprint.wu, footprint.wv};
  for (int plane = 0; plane < planes; ++plane) {
    const Words words = read_words(state.memory, at, weights.taps, plane);
    filter_word(config, state, draw, word_use(draw, first_word + plane), words, weights, out);
  }
}

/// The fields that a texture of a draw fills.
struct FieldRange {
  unsigned first = 0, end = 0;
};
constexpr FieldRange fields_of(int texture) {
  return texture == 0 ? FieldRange{0, kColorField} : FieldRange{kColorField, kFields};
}

/// U8 of one texture and probe, added to the sum of probes.
template <class Config>
void add_probe(const Config& constant, const UnitState& state, const Draw& draw,
               const UnitFragment& fragment, int texture, int probe, Fields& sum) {
  const EvalConfig& config = constant;
  const FieldRange range = fields_of(texture);
  const Footprint first = make_footprint(draw, fragment, texture, probe, 0);
  if (!first.fetched) return;
  Fields one{};
  filter_texture(constant, state, draw, texture, first, one);
  if (first.level_weight != 0) {
    Fields two{};
    const Footprint second = make_footprint(draw, fragment, texture, probe, 1);
    filter_texture(constant, state, draw, texture, second, two);
    for (unsigned k = range.first; k < range.end; ++k) {
      one[k] = lerp(config.rounding, one[k], two[k], Value{first.level_weight});
    }
  }
  for (unsigned k = range.first; k < range.end; ++k) sum[k] += one[k];
}

/// U1 to U9.
template <class Config>
Fields filter_fragment(const Config& constant, const UnitState& state, const Draw& draw,
                       const UnitFragment& fragment) {
  const EvalConfig& config = constant;
  Fields sum{};
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

/// U10: operands of the passes, C and its alpha.
template <class Config>
void make_operands(const Config& constant, const Draw& draw, bool lit, ShadeTrace& trace) {
  const EvalConfig& config = constant;
  const bool map = draw.format != TextureFormat::none;
  const auto passes = static_cast<unsigned>(draw_passes(draw));
  for (unsigned p = 0; p < passes; ++p) {
    for (unsigned i = 0; i < 6; ++i) {
      const Value dark = map ? shift_left(draw.bias[i], config.filter_frac) : 0;
      trace.coef[p][i] = lit ? trace.filtered[6 * p + i] : dark;
    }
  }
  for (unsigned c = 0; c < 4; ++c) {
    trace.color[c] =
        narrow_constant(config.rounding, trace.filtered[kColorField + c], config.filter_frac);
  }
}

/// D1 to D7: P and the flags.
template <class Config>
void evaluate(const Config& config, const Draw& draw, const UnitFragment& fragment,
              ShadeTrace& trace) {
  const bool map = draw.format != TextureFormat::none;
  const Six<Value> bias = map ? draw.bias : Six<Value>{};
  const Six<Value> shift = map ? draw.shift : Six<Value>{};
  const Value lu = fragment.lu, lv = fragment.lv;
  if (draw_passes(draw) == 3) {
    const RgbTrace<> out =
        evaluate_rgb<Value>(config, RgbOperands<>{trace.coef, bias, shift, lu, lv});
    trace.lit = out.color.out;
    trace.pixel.lum_saturated = out.lum_saturated != 0;
    trace.pixel.color_saturated = out.color.saturated != 0;
    return;
  }
  const Three<Value> rgb{trace.filtered[18], trace.filtered[19], trace.filtered[20]};
  const LrgbTrace<> out =
      evaluate_lrgb<Value>(config, LrgbOperands<>{trace.coef[0], bias, shift, rgb, lu, lv});
  trace.lit = out.color.out;
  trace.pixel.lum_saturated = out.luminance.lum.saturated != 0;
  trace.pixel.color_saturated = out.color.saturated != 0;
}

/// U11 and the alpha of U10.
template <class Config>
void combine(const Config& constant, const Draw& draw, ShadeTrace& trace) {
  const EvalConfig& config = constant;
  for (unsigned c = 0; c < 3; ++c) {
    const CombineOperands<> in{trace.lit[c], trace.color[c], trace.color[3], draw.ka, draw.kd};
    trace.pixel.rgb[c] =
        static_cast<std::uint8_t>(combine_channel(config.rounding, draw.combine, in));
  }
  Value alpha = 255;
  if (draw.format == TextureFormat::lrgb) {
    alpha = narrow_constant(config.rounding, trace.filtered[kMapAlphaField], config.filter_frac);
  }
  if (draw.combine == Combine::replace) alpha = trace.color[3];
  trace.pixel.alpha = static_cast<std::uint8_t>(alpha);
}

template <class Config>
ShadeTrace shade_with(const Config& config, const UnitState& state, const UnitFragment& fragment) {
  const Draw& draw = state.draws[fragment.draw];
  ShadeTrace trace;
  trace.pixel.x = fragment.x;
  trace.pixel.y = fragment.y;
  trace.filtered = filter_fragment(config, state, draw, fragment);
  make_operands(config, draw, fragment.lit, trace);
  evaluate(config, draw, fragment, trace);
  combine(config, draw, trace);
  return trace;
}

}  // namespace

UnitPixel shade(const EvalConfig& config, const UnitState& state, const UnitFragment& fragment) {
  return shade_trace(config, state, fragment).pixel;
}

ShadeTrace shade_trace(const EvalConfig& config, const UnitState& state,
                       const UnitFragment& fragment) {
  return with_constant_config(
      config, [&](const auto& constant) { return shade_with(constant, state, fragment); });
}

void shade_all(const EvalConfig& config, const UnitState& state,
               std::span<const UnitFragment> fragments, std::span<UnitPixel> pixels) {
  with_constant_config(config, [&](const auto& constant) {
    for (std::size_t i = 0; i < fragments.size(); ++i) {
      pixels[i] = shade_with(constant, state, fragments[i]).pixel;
    }
  });
}

}  // namespace ptm::reference
