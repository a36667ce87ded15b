#pragma once
#include <bit>

#include "model/pipeline/unit/draw_plan.h"
#include "model/reference/unit/beats.h"

/// Steps U1 to U6 as time needs them: tiles and taps, without the words in them.
namespace ptm::pipeline {

/// One texture's part of a footprint. A column or row that is not fetched repeats the other.
struct FootprintTiles {
  std::uint64_t key = 0;  ///< all the others; equal keys of one draw are the same look-ups
  std::uint32_t tx0 = 0, tx1 = 0, ty0 = 0, ty1 = 0;
  std::uint32_t level = 0;
  unsigned taps = 0;  ///< bit t: tap t (00, 10, 01, 11) is fetched
  /// Bit 0: it collides in u, bit 1: in v (docs/spec/unit-timing.md, "Seam split").
  unsigned split = 0;
  unsigned tiles = 0;  ///< distinct ones
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
[[nodiscard, gnu::always_inline]] inline TileSpan span_tiles(reference::Wrap wrap, bool bilinear,
                                                             reference::Value at, int size) {
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

/// Both directions of a texture's part, from which all else follows.
struct FootprintSpan {
  TileSpan across, down;

  [[nodiscard]] unsigned split() const {
    return (across.split ? kSplitU : 0U) | (down.split ? kSplitV : 0U);
  }
  [[nodiscard]] unsigned taps() const {
    const unsigned row = across.both ? 0b11U : 0b01U;
    return down.both ? row << 2 | row : row;
  }
  [[nodiscard]] unsigned tap_count() const {
    return (across.both ? 2U : 1U) << (down.both ? 1U : 0U);
  }
  [[nodiscard]] std::uint64_t key(int level) const {
    const std::uint64_t tiles = std::uint64_t{across.t0} << 30 | std::uint64_t{across.t1} << 20 |
                                std::uint64_t{down.t0} << 10 | down.t1;
    return ((tiles << 4 | static_cast<unsigned>(level)) << 4 | taps()) << 2 | split();
  }
  [[nodiscard]] FootprintTiles tiles(int level) const {
    return {.key = key(level),
            .tx0 = across.t0,
            .tx1 = across.t1,
            .ty0 = down.t0,
            .ty1 = down.t1,
            .level = static_cast<std::uint32_t>(level),
            .taps = taps(),
            .split = split(),
            .tiles = (across.t0 != across.t1 ? 2U : 1U) * (down.t0 != down.t1 ? 2U : 1U)};
  }
};

/// The part of a texture at a level; u and v from U1.
[[nodiscard, gnu::always_inline]] inline FootprintSpan span_footprint(const reference::Draw& draw,
                                                                      const LevelPlan& level,
                                                                      reference::Value u,
                                                                      reference::Value v) {
  return {span_tiles(draw.wrap_u, draw.bilinear, u, level.width),
          span_tiles(draw.wrap_v, draw.bilinear, v, level.height)};
}

}  // namespace ptm::pipeline
