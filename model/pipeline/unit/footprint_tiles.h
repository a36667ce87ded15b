#pragma once
#include <bit>

#include "model/pipeline/unit/draw_plan.h"
#include "model/reference/unit/beats.h"

/// Steps U1 to U6 as time needs them: tiles and taps, without the words in them.
namespace ptm::pipeline {

/// One texture's part of a footprint. A column or row that is not fetched repeats the other.
struct FootprintTiles {
  std::uint32_t tx0 = 0, tx1 = 0, ty0 = 0, ty1 = 0;
  std::uint32_t level = 0;
  unsigned taps = 0;  ///< bit t: tap t (00, 10, 01, 11) is fetched
  /// Bit 0: it collides in u, bit 1: in v (docs/spec/unit-timing.md, "Seam split").
  unsigned split = 0;
  unsigned tiles = 0;  ///< distinct ones
  unsigned tap_count = 0;
  std::uint64_t key = 0;  ///< equal keys of one draw: the same look-ups
};

inline constexpr unsigned kSplitU = 1, kSplitV = 2;

/// Whether two texels along a direction share a data bank, or their tiles a tag bank.
[[nodiscard]] constexpr bool collide(std::int32_t i0, std::int32_t i1) {
  if (i0 == i1) return false;
  const std::int32_t t0 = i0 >> 2, t1 = i1 >> 2;
  return ((i0 ^ i1) & 1) == 0 || (t0 != t1 && ((t0 ^ t1) & 1) == 0);
}

struct TileSpan {
  std::uint32_t t0 = 0, t1 = 0;
  bool both = false;  ///< both columns (rows) are fetched
  bool split = false;
};

/// U3 to U5 along one direction.
[[nodiscard]] inline TileSpan span_tiles(reference::Wrap wrap, bool bilinear, reference::Value at,
                                         int size) {
  const auto position = reference::texel_position(bilinear, reference::wrap_coordinate(wrap, at),
                                                  reference::Value{size});
  const auto index = static_cast<std::int32_t>(position.index);
  const std::int32_t i0 = reference::neighbour(wrap, index, size);
  TileSpan span;
  span.t0 = span.t1 = static_cast<std::uint32_t>(i0) >> 2;
  if (position.weight == 0) return span;
  const std::int32_t i1 = reference::neighbour(wrap, index + 1, size);
  span.t1 = static_cast<std::uint32_t>(i1) >> 2;
  span.both = true;
  span.split = collide(i0, i1);
  return span;
}

/// The part of a texture at a level; u and v from U1.
[[nodiscard]] inline FootprintTiles footprint_tiles(const reference::Draw& draw,
                                                    const TexturePlan& texture, int level,
                                                    reference::Value u, reference::Value v) {
  const LevelPlan& plan = texture.level[static_cast<std::size_t>(level)];
  const TileSpan across = span_tiles(draw.wrap_u, draw.bilinear, u, plan.width);
  const TileSpan down = span_tiles(draw.wrap_v, draw.bilinear, v, plan.height);
  FootprintTiles out{across.t0, across.t1, down.t0, down.t1, static_cast<std::uint32_t>(level)};
  out.taps =
      1U | (across.both ? 2U : 0U) | (down.both ? 4U : 0U) | (across.both && down.both ? 8U : 0U);
  out.split = (across.split ? kSplitU : 0U) | (down.split ? kSplitV : 0U);
  out.tiles = (across.t0 != across.t1 ? 2U : 1U) * (down.t0 != down.t1 ? 2U : 1U);
  out.tap_count = (across.both ? 2U : 1U) * (down.both ? 2U : 1U);
  out.key = (((std::uint64_t{out.tx0} << 30 | std::uint64_t{out.tx1} << 20 |
               std::uint64_t{out.ty0} << 10 | out.ty1)
                  << 4 |
              out.level)
                 << 4 |
             out.taps)
                << 2 |
            out.split;
  return out;
}

}  // namespace ptm::pipeline
