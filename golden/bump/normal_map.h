#pragma once
#include <string>

#include "golden/bump/bump_map.h"

namespace ptm::golden {

struct NormalMapOptions {
  double strength = 1;      ///< a factor on slopes; finite
  bool green_down = false;  ///< green runs down the picture, as DirectX has it
};

/// Normals of a normal map: (2 level / 255 - 1) for each channel, then to unit length; red to the
/// right, green up (or down), blue to the viewer.
///
/// **Background.** Texels that no rounded unit vector gives are taken for masked and become the
/// flat normal (0, 0, 1), with a note that counts them: all channels at most 53 (black: the vector
/// is longer than 1 + sqrt(3) / 255, the most that rounding to eight bits can add), all at least
/// 247 (white), or a vector shorter than twice that rounding (mid grey). Texels on or below the
/// horizon that hang together with such ones are their blurred edge and are taken likewise.
///
/// **Green.** The normals (u, v, w) of a surface obey d(u/w)/dy = d(v/w)/dx, y upwards; of the
/// other sign of green they obey the opposite. Both sums of squares of what is missing are formed
/// over all neighbourhoods of 3 x 3 texels at most 70 degrees steep; if the other sign's is less
/// than a quarter, and their difference is beyond five standard deviations of chance, a note says
/// that the map looks so. It is still read as asked.
///
/// Throws InputError naming `file`: other than 3 channels, a picture of background only, and the
/// pixel for a normal on or below the horizon anywhere else.
[[nodiscard]] NormalField read_normal_map(const ImageReal& picture, const NormalMapOptions& options,
                                          const std::string& file);

}  // namespace ptm::golden
