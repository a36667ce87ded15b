#pragma once
#include <algorithm>
#include <array>

#include "model/reference/evaluate.h"
#include "tests/reference/exact_rational.h"
#include "tests/reference/unit_scene.h"

/// A second way to a fragment's pixel: docs/spec/unit.md and docs/spec/effects.md read with
/// rational arithmetic, from the pictures and maps themselves; it knows no lines, words or wires.
/// D1 to D7 are the reference's, which has a second derivation of its own (luminance_test.cpp).
namespace ptm::tests {

class UnitOracle {
 public:
  explicit UnitOracle(const UnitScene& scene) : scene_(scene) {}

  reference::UnitPixel pixel(const reference::UnitFragment& f) const {
    const reference::Draw& draw = scene_.state.draws[f.draw];
    Fields fields{};
    for (int n = 0; n < 50; ++n) fields[static_cast<std::size_t>(n)] = field(f, n);
    reference::UnitPixel out;
    out.x = f.x;
    out.y = f.y;
    const std::array<reference::Value, 3> lit = evaluate(draw, f, fields, out);
    std::array<Wide, 4> color{};
    for (std::size_t c = 0; c < 4; ++c) color[c] = drop(fields[22 + c], scene_.config.filter_frac);
    for (std::size_t c = 0; c < 3; ++c) {
      out.rgb[c] = static_cast<std::uint8_t>(combine(draw, lit[c], color[c], color[3]));
    }
    const Extra extra = extra_of(f);
    for (std::size_t c = 0; c < 3; ++c) {
      const bool adds = (draw.effects.stages & 4) != 0;
      const Wide more = adds ? drop(extra.addend[c], 4) : 0;
      out.rgb[c] = static_cast<std::uint8_t>(limit(Wide{out.rgb[c]} + more, 0, 255));
    }
    out.alpha = static_cast<std::uint8_t>(draw.combine == reference::Combine::replace ? color[3]
                                          : draw.format == reference::TextureFormat::lrgb
                                              ? drop(fields[21], scene_.config.filter_frac)
                                              : 255);
    return out;
  }

  /// X1's values and the addend behind X3.
  struct Extra {
    std::array<reference::Value, 4> value{};
    std::array<Wide, 3> addend{};
  };
  Extra extra_of(const reference::UnitFragment& f) const {
    const reference::Draw& draw = scene_.state.draws[f.draw];
    Extra out;
    for (int k = 0; k < draw.effects.passes; ++k) {
      out.value[static_cast<std::size_t>(k)] =
          luminance(f, draw.effects.pass[static_cast<std::size_t>(k)]);
    }
    const Wide one = Wide{1} << scene_.config.lum_frac;
    if ((draw.effects.stages & 1) != 0) {
      const auto& table = scene_.state.tables[f.draw];
      const Wide x = std::min<Wide>(out.value[0], 255 * one);
      const auto entry = [&](Wide i) {
        return Wide{table[static_cast<std::size_t>(std::min<Wide>(i, 255))]};
      };
      const Wide low = entry(x / one), high = entry(x / one + 1);
      const Wide e = low + drop((high - low) * (x % one), scene_.config.lum_frac);
      out.addend.fill(drop(draw.ks * e, 8));
    }
    if ((draw.effects.stages & 2) != 0) {
      for (std::size_t c = 0; c < 3; ++c) {
        const Wide value = out.value[draw.effects.argument % 2 != 0 ? 1 + c : 1];
        const Wide m = std::min<Wide>(255, drop(value, scene_.config.lum_frac));
        out.addend[c] = drop(out.addend[c] * (m < 128 ? m : m + 1), 8);
      }
    }
    return out;
  }

  /// Value of field n after the mean of probes.
  reference::Value field(const reference::UnitFragment& f, int n) const {
    const reference::Draw& draw = scene_.state.draws[f.draw];
    const bool color = n >= 22 && n < 26;
    if (color ? !draw.color : draw.format == reference::TextureFormat::none) return 0;
    if (n >= 26 + 6 * draw.effects.sets) return 0;
    const Level level = choose(draw, f, color);
    const int probes = 1 << f.probes_log2;
    Wide sum = 0;
    for (int k = 0; k < probes; ++k) {
      const Wide pu = floor_divide(2 * Wide{f.u} + (2 * k + 1 - probes) * Wide{f.axis_u}, 2);
      const Wide pv = floor_divide(2 * Wide{f.v} + (2 * k + 1 - probes) * Wide{f.axis_v}, 2);
      Wide value = sample(draw, f.draw, level.index, n, pu, pv);
      if (level.weight != 0) {
        value = mix(value, sample(draw, f.draw, level.index + 1, n, pu, pv), level.weight);
      }
      sum += value;
    }
    return static_cast<reference::Value>(drop(sum, f.probes_log2));
  }

  struct Level {
    int index = 0;
    Wide weight = 0;  ///< of the next, in 256ths
  };
  static Level choose(const reference::Draw& draw, const reference::UnitFragment& f, bool color) {
    const Wide levels = color ? draw.color_texture.levels : draw.map.levels;
    const Wide lod = color ? limit(Wide{f.lod} + draw.color_lod, 0, 4095) : Wide{f.lod};
    if (draw.mip == reference::Mip::none) return {};
    if (draw.mip == reference::Mip::nearest) {
      return {static_cast<int>(limit(floor_divide(2 * lod + 256, 512), 0, levels - 1)), 0};
    }
    const Wide limited = limit(lod, 0, 256 * (levels - 1));
    return {static_cast<int>(limited / 256), limited % 256};
  }

  /// A direction's texel, its neighbour and the neighbour's weight.
  struct Column {
    Wide texel = 0, next = 0, weight = 0;
  };
  static Column column(reference::Wrap wrap, bool bilinear, Wide u, Wide size) {
    constexpr Wide kOne = 1 << 20;
    const Wide period = floor_divide(u, kOne);
    Wide inside = u - period * kOne;
    if (wrap == reference::Wrap::mirror && floor_divide(period, 2) * 2 != period) {
      inside = kOne - 1 - inside;
    }
    if (wrap == reference::Wrap::clamp) inside = limit(u, 0, kOne - 1);
    if (!bilinear) return {floor_divide(inside * size, kOne), 0, 0};
    const Wide s = floor_divide(512 * inside * size - 255 * kOne, 2 * kOne);  // 256 (x - 1/2) + 1/2
    const Wide texel = floor_divide(s, 256);
    const auto bring = [&](Wide i) {
      return wrap == reference::Wrap::repeat ? (i + size) % size : limit(i, 0, size - 1);
    };
    return {bring(texel), bring(texel + 1), s - 256 * texel};
  }

  /// A stored field of a texel.
  reference::Value stored(const reference::Draw& draw, std::size_t d, int level, int n, Wide i,
                          Wide j) const {
    const DrawSource& source = scene_.sources[d];
    const auto l = static_cast<std::size_t>(level), field = static_cast<std::size_t>(n);
    const auto at = [&](const auto& picture) {
      return static_cast<std::size_t>(j * picture.width + i);
    };
    using reference::TextureFormat;
    if (n >= 26) {
      const auto& set = source.sets[(field - 26) / 6][l];
      return set.coef[at(set) * 6 + (field - 26) % 6];
    }
    if (n >= 22) return source.color[l].rgba[at(source.color[l]) * 4 + field - 22];
    if (draw.format == TextureFormat::lrgb) {
      const std::size_t k = at(source.map[l]);
      if (n == 21) return source.map_alpha[l][k];
      if (n >= 18) return source.map[l].color[k * 3 + field - 18];
      return n < 6 ? source.map[l].coef[k * 6 + field] : 0;
    }
    if (draw.format == TextureFormat::rgb) {
      return n < 18 ? source.map[l].coef[at(source.map[l]) * 18 + field] : 0;
    }
    const std::size_t k = at(source.palette_map[l]);
    const std::size_t entry = source.palette_map[l].index[k];
    if (draw.format == TextureFormat::palette_rgb) {
      return n < 18 ? scene_.rgb_palette[entry * 18 + field] : 0;
    }
    const auto& palette = scene_.lrgb_palettes[static_cast<std::size_t>(draw.palette)];
    if (n < 6) return palette[entry * 6 + field];
    return n >= 18 && n < 21 ? source.palette_map[l].color[k * 3 + field - 18] : 0;
  }

 private:
  using Fields = std::array<reference::Value, 50>;

  reference::Value luminance(const reference::UnitFragment& f,
                             const reference::ExtraPass& pass) const {
    const reference::Draw& draw = scene_.state.draws[f.draw];
    const int s = pass.set - 1;
    reference::LrgbOperands<> in;
    in.bias = s < 0 ? draw.bias : draw.effects.bias[static_cast<std::size_t>(s)];
    in.shift = s < 0 ? draw.shift : draw.effects.shift[static_cast<std::size_t>(s)];
    for (int i = 0; i < 6; ++i) {
      const auto at = static_cast<std::size_t>(i);
      in.coef[at] =
          f.lit ? field(f, s < 0 ? i : 26 + 6 * s + i) : in.bias[at] << scene_.config.filter_frac;
    }
    in.lu = pass.half ? f.hu : f.lu;
    in.lv = pass.half ? f.hv : f.lv;
    return reference::evaluate_lrgb<reference::Value>(scene_.config, in).luminance.lum.lum;
  }

  [[nodiscard]] bool nearest() const {
    return scene_.config.rounding == reference::Rounding::nearest;
  }
  [[nodiscard]] Wide drop(Wide x, int k) const { return round_scaled(x, k, nearest()); }
  [[nodiscard]] Wide mix(Wide a, Wide b, Wide f) const { return a + drop((b - a) * f, 8); }
  [[nodiscard]] Wide over_255(Wide x) const {
    return nearest() ? floor_divide(2 * x + 255, 510) : floor_divide(x, 255);
  }

  Wide sample(const reference::Draw& draw, std::size_t d, int level, int n, Wide u, Wide v) const {
    const reference::TextureLevels& t = n >= 22 && n < 26 ? draw.color_texture : draw.map;
    const Column c = column(draw.wrap_u, draw.bilinear, u, std::max(1, t.width >> level));
    const Column r = column(draw.wrap_v, draw.bilinear, v, std::max(1, t.height >> level));
    const auto at = [&](Wide i, Wide j) -> Wide {
      return Wide{stored(draw, d, level, n, i, j)} << scene_.config.filter_frac;
    };
    // Contract: a texel of weight 0 is not read, and is not missed.
    const Wide top = c.weight == 0 ? at(c.texel, r.texel)
                                   : mix(at(c.texel, r.texel), at(c.next, r.texel), c.weight);
    if (r.weight == 0) return top;
    const Wide bottom = c.weight == 0 ? at(c.texel, r.next)
                                      : mix(at(c.texel, r.next), at(c.next, r.next), c.weight);
    return mix(top, bottom, r.weight);
  }

  std::array<reference::Value, 3> evaluate(const reference::Draw& draw,
                                           const reference::UnitFragment& f, const Fields& fields,
                                           reference::UnitPixel& out) const {
    using reference::TextureFormat;
    if (draw.format == TextureFormat::none) return {0, 0, 0};
    const auto coefficient = [&](std::size_t n) {
      return f.lit ? fields[n] : draw.bias[n % 6] << scene_.config.filter_frac;
    };
    if (draw.format == TextureFormat::rgb || draw.format == TextureFormat::palette_rgb) {
      reference::RgbOperands<> in{{}, draw.bias, draw.shift, f.lu, f.lv};
      for (std::size_t n = 0; n < 18; ++n) in.coef[n / 6][n % 6] = coefficient(n);
      const auto trace = reference::evaluate_rgb<reference::Value>(scene_.config, in);
      out.lum_saturated = trace.lum_saturated != 0;
      out.color_saturated = trace.color.saturated != 0;
      return trace.color.out;
    }
    reference::LrgbOperands<> in{{},   draw.bias, draw.shift, {fields[18], fields[19], fields[20]},
                                 f.lu, f.lv};
    for (std::size_t n = 0; n < 6; ++n) in.coef[n] = coefficient(n);
    const auto trace = reference::evaluate_lrgb<reference::Value>(scene_.config, in);
    out.lum_saturated = trace.luminance.lum.saturated != 0;
    out.color_saturated = trace.color.saturated != 0;
    return trace.color.out;
  }

  [[nodiscard]] Wide combine(const reference::Draw& draw, Wide p, Wide c, Wide alpha) const {
    switch (draw.combine) {
      case reference::Combine::modulate:
        return over_255(p * c);
      case reference::Combine::decal:
        return over_255(c * alpha + p * (255 - alpha));
      case reference::Combine::blend:
        return std::min<Wide>(255, drop(draw.kd * p + draw.ka * c, 8));
      case reference::Combine::add:
        return std::min<Wide>(255, p + c);
      case reference::Combine::replace:
        return c;
      default:
        return p;
    }
  }

  const UnitScene& scene_;
};

}  // namespace ptm::tests
