#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "golden/files/image.h"

namespace ptm::golden {

struct ReliefOptions {
  int size = 384;          ///< pixels along each side; 16..4096
  std::uint64_t seed = 1;  ///< of weathering, stone and sensor noise
};

/// A carved and painted slab of stone, made up: a rosette in a medallion with a ring of beads, a
/// spiral, letters, a frame, weathered by noise. It stands in for a museum piece where no capture
/// is at hand.
///
/// Lengths are in half widths of the picture: x in [-1, 1] to the right, y in [-1, 1] up, z to the
/// camera, which is far away. The same seed and size give the same photographs.
class Relief {
 public:
  /// Throws std::invalid_argument for a size out of range.
  explicit Relief(const ReliefOptions& options);

  /// The slab lit from one direction (unit vector, z > 0): Lambert times albedo, a little gloss,
  /// some stray light from the room, cast shadows with the soft edge of a lamp two degrees wide,
  /// sensor noise of about half a level. 8-bit levels proportional to light. Rows run on all cores.
  [[nodiscard]] Image8 photograph(const std::array<double, 3>& light) const;

  /// Height of the surface, [size][size], row 0 at the top.
  [[nodiscard]] const ImageReal& height() const { return height_; }

 private:
  [[nodiscard]] double lit_share(int x, int y, const std::array<double, 3>& light) const;
  [[nodiscard]] double height_at(double column, double row) const;

  ReliefOptions options_;
  ImageReal height_;  ///< one channel, half widths
  ImageReal normal_;  ///< three channels, unit length
  ImageReal albedo_;  ///< four channels: red, green, blue in 0..1, gloss in 0..1
  double highest_ = 0;
};

/// Directions spread evenly over the hemisphere down to 10 degrees above the horizon, in a spiral
/// from the zenith outwards. At least one light (std::invalid_argument).
[[nodiscard]] std::vector<std::array<double, 3>> spread_lights(int count);

}  // namespace ptm::golden
