#include "golden/render/texture_filter.h"

#include <algorithm>
#include <cmath>

namespace ptm::golden {
namespace {

/// Two texels along a side, and how much the second counts.
struct Neighbours {
  int first = 0, second = 0;
  double weight = 0;
};

int beyond(int index, int side, WrapMode mode) {
  if (index >= 0 && index < side) return index;
  if (mode == WrapMode::repeat) return index < 0 ? side - 1 : 0;
  return index < 0 ? 0 : side - 1;
}

Neighbours neighbours(double coordinate, int side, WrapMode mode, bool bilinear) {
  if (!bilinear) {
    const int i = point_texel(coordinate, side, mode);
    return {i, i, 0};
  }
  const double position = wrapped(coordinate, mode) * side;
  const double from = std::floor(position - 0.5);
  const int i = static_cast<int>(from);
  return {beyond(i, side, mode), beyond(i + 1, side, mode), position - 0.5 - from};
}

Rgba mix(const Rgba& a, const Rgba& b, double weight) {
  Rgba out{};
  for (std::size_t c = 0; c < 4; ++c) out[c] = (1 - weight) * a[c] + weight * b[c];
  return out;
}

/// floor(lod + 1/2); the sum itself would be rounded, and up to a level just below a half.
int nearest_level(double lod) {
  const int level = static_cast<int>(lod);
  return lod - level >= 0.5 ? level + 1 : level;
}

/// The texel of the endless row of texels at [k / side, (k + 1) / side), with each edge at the
/// double nearest to it: an edge is itself met by a coordinate that was computed as k / side, even
/// where that is no double, and the rounded product with `side` may be on either side of k.
double endless_texel(double coordinate, int side) {
  const double near = std::floor(coordinate * side);
  if ((near + 1) / side <= coordinate) return near + 1;
  return near / side > coordinate ? near - 1 : near;
}

template <class Texture>
Rgba within_level(const Texture& texture, const TextureQuery& query, int level, double u,
                  double v) {
  const Neighbours x = neighbours(u, texture.width(level), query.wrap_u, query.filter.bilinear);
  const Neighbours y = neighbours(v, texture.height(level), query.wrap_v, query.filter.bilinear);
  const auto row = [&](int j) {
    const Rgba first = texture.texel(level, x.first, j, query.light);
    if (x.weight == 0) return first;
    return mix(first, texture.texel(level, x.second, j, query.light), x.weight);
  };
  const Rgba first = row(y.first);
  return y.weight == 0 ? first : mix(first, row(y.second), y.weight);
}

template <class Texture>
Rgba one_probe(const Texture& texture, const TextureQuery& query, double u, double v) {
  const int last = texture.levels() - 1;
  const double lod = std::clamp(query.lod, 0.0, static_cast<double>(last));
  switch (query.filter.mip) {
    case MipMode::none:
      return within_level(texture, query, 0, u, v);
    case MipMode::nearest:
      return within_level(texture, query, nearest_level(lod), u, v);
    default:
      break;
  }
  const int level = static_cast<int>(lod);
  const Rgba finer = within_level(texture, query, level, u, v);
  const double f = lod - level;
  return f == 0 ? finer : mix(finer, within_level(texture, query, level + 1, u, v), f);
}

template <class Texture>
Rgba filtered(const Texture& texture, const TextureQuery& query) {
  Rgba sum{};
  for (int k = 0; k < query.probes; ++k) {
    const double along = k + 0.5 - query.probes / 2.0;
    const Rgba probe =
        one_probe(texture, query, query.u + along * query.axis_u, query.v + along * query.axis_v);
    for (std::size_t c = 0; c < 4; ++c) sum[c] += probe[c];
  }
  for (double& value : sum) value /= query.probes;
  return sum;
}

}  // namespace

double wrapped(double coordinate, WrapMode mode) {
  if (mode == WrapMode::clamp) return std::clamp(coordinate, 0.0, 1.0);
  const double period = std::floor(coordinate);
  const double fraction = coordinate - period;
  const bool odd = std::fmod(period, 2) != 0;
  return mode == WrapMode::mirror && odd ? 1 - fraction : fraction;
}

int point_texel(double coordinate, int side, WrapMode mode) {
  const double last = side - 1.0;
  if (mode == WrapMode::clamp) {
    return static_cast<int>(std::clamp(endless_texel(wrapped(coordinate, mode), side), 0.0, last));
  }
  // Far out doubles are wider apart than texels: whole pairs of periods are taken off exactly.
  constexpr double kFar = 0x1p53;
  const bool far = std::abs(coordinate) * side >= kFar;
  const double endless = endless_texel(far ? std::fmod(coordinate, 2) : coordinate, side);
  // A texel owns its lower edge, in the mirrored half of the row too: so the texel is found in the
  // endless row first and mirrored after, not the other way round.
  const double both = std::fmod(endless, 2.0 * side);
  const int i = static_cast<int>(both < 0 ? both + 2 * side : both);
  if (i < side) return i;
  return mode == WrapMode::mirror ? 2 * side - 1 - i : i - side;
}

Rgba filter_texture(const MipTexture& texture, const TextureQuery& query) {
  return filtered(texture, query);
}

Rgba filter_texture(const AddendView& texture, const TextureQuery& query) {
  return filtered(texture, query);
}

}  // namespace ptm::golden
