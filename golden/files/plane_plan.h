#pragma once
#include <cstdint>
#include <vector>

#include "golden/files/plane.h"

namespace ptm::golden {

/// Which plane is told by which: one entry a plane, as the file's lines of the same names.
struct PlanePlan {
  std::vector<int> order;       ///< position of the plane in the decoding sequence
  std::vector<int> references;  ///< the plane it is a difference from, or -1
  std::vector<int> transforms;  ///< 1 where the reference is inverted first, else 0
};

/// How the differences will be coded.
enum class Differences : std::uint8_t {
  wrapped,  ///< modulo 256, no texel lost (JPEG-LS)
  clamped,  ///< to 0..255; a texel beyond takes a record of side information (JPEG)
};

/// Chooses references greedily: of all planes not yet placed, each alone or as a difference from a
/// placed one, the cheapest comes next. A plane's cost is the entropy of the differences between
/// neighbours in a row, which is what both codecs spend bits on, and 40 bits a record of side
/// information; at most 64 Ki texels are looked at.
[[nodiscard]] PlanePlan plan_planes(const std::vector<Plane>& planes, int width, int height,
                                    Differences differences, bool allow_inversion);

}  // namespace ptm::golden
