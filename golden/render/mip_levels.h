#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "golden/render/light_map.h"
#include "golden/scene/textures.h"

namespace ptm::golden {

/// Red, green, blue and alpha in levels.
using Rgba = std::array<double, 4>;

/// A level below the texture itself.
struct MipLevel {
  int width = 0, height = 0;
  std::vector<double> values;  ///< [height][width][18] maps, three polynomials; [4] pictures
};

/// A texture and its mip levels, each half the size of the one above, down to 1 x 1.
///
/// A map's levels average what its texels radiate (Polynomial Texture Maps, Eq. 14): three
/// polynomials a texel, color_c a_k / 255 for LRGB. Hardware averages coefficients and colours of
/// LRGB apart; the difference is one of its errors. A picture's levels average R, G, B and A.
class MipTexture {
 public:
  /// With `levels` false there is level 0 only. The texture must stay where it is.
  MipTexture(const LoadedTexture& texture, bool levels);

  [[nodiscard]] int levels() const { return 1 + static_cast<int>(below_.size()); }
  [[nodiscard]] int width(int level) const;
  [[nodiscard]] int height(int level) const;
  /// A texel, lit if it is a map's (alpha 255) and clamped to [0, 255]; indices within the level.
  /// On level 0 the same as light_texel() gives, to the bit (LUM files: nearly).
  [[nodiscard]] Rgba texel(int level, int i, int j, const std::array<double, 2>& light) const;

 private:
  const LoadedTexture* texture_;
  std::vector<MipLevel> below_;  ///< level 1 first
};

/// Half the size, at least 1: every texel averages the area that it covers, which for odd sides
/// includes parts of texels, so that the mean is kept. [height][width][channels].
[[nodiscard]] MipLevel halve(const MipLevel& level, std::size_t channels);

}  // namespace ptm::golden
