#pragma once
#include <array>

#include "golden/render/addend_texture.h"
#include "golden/render/mip_levels.h"

/// Filters lit texels in real arithmetic: docs/spec/unit.md, U1 to U9, without their rounding.
namespace ptm::golden {

/// How and where a texture is asked.
struct TextureQuery {
  double u = 0, v = 0;            ///< 1.0 is the width or height
  double axis_u = 0, axis_v = 0;  ///< from one probe to the next
  int probes = 1;
  double lod = 0;  ///< of this texture; negative where magnified
  FilterMode filter{};
  WrapMode wrap_u = WrapMode::repeat, wrap_v = WrapMode::repeat;
  std::array<double, 2> light{};
};

/// The mean over the probes k = 0..N-1 at (u, v) + (k + 1/2 - N/2) axis of the levels' mix:
///
///     none     level 0        nearest  level min(floor(lod + 1/2), last)
///     linear   lerp(l, l + 1, f) with l + f = min(lod, last)         lod below 0 counts as 0
///
/// Within a level: the texel that holds the point, or the four whose centres surround it, weighed
/// linearly. Coordinates wrap first; a neighbour beyond the edge is then the one at the other side
/// (repeat) or the edge's own (mirror, clamp).
[[nodiscard]] Rgba filter_texture(const MipTexture& texture, const TextureQuery& query);

/// The same of what effects add: "lights texels first, then filters" holds for it too.
[[nodiscard]] Rgba filter_texture(const AddendView& texture, const TextureQuery& query);

/// A coordinate within one period: repeat and mirror give [0, 1], clamp limits to that.
[[nodiscard]] double wrapped(double coordinate, WrapMode mode);

/// The texel along a side of `side` texels that point sampling takes: texel k of the endless row
/// holds [k / side, (k + 1) / side), each edge counted as the double nearest to it; then it is
/// wrapped. A sample on an edge takes the texel above it in the endless row, whatever the wrap.
/// `coordinate` is finite.
[[nodiscard]] int point_texel(double coordinate, int side, WrapMode mode);

}  // namespace ptm::golden
