#pragma once
#include <cstdint>

#include "model/reference/unit/draw.h"

/// Point samples that lie so near an edge between two texels that the hardware's coordinate may
/// fall into the other one. Their error is that of the coordinate, not of the number format.
namespace ptm::testbench {

/// Whether rounding a texture coordinate to 2^-20 can carry a point sample over an edge between
/// two texels of a side of `size`: the coordinate is not a multiple of 2^-20, and
///
///     |coordinate * size - n| <= size * 2^-21      for a whole n that parts two texels.
///
/// Every whole n does under repeat; under clamp those from 1 to size - 1; under mirror those that
/// are no multiple of size, since on both sides of such a one lies the same texel.
[[nodiscard]] bool on_texel_edge(double coordinate, int size, reference::Wrap wrap);

/// The same for a draw's point samples at (u, v), of its map and of its colour texture; with mip
/// levels, in either of the two levels around `lod`, log2 of texels of level 0.
[[nodiscard]] bool on_texel_edge(double u, double v, double lod, const reference::Draw& draw);

}  // namespace ptm::testbench
