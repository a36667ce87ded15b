#pragma once
#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "golden/bump/normal_table.h"
#include "golden/files/image.h"

namespace ptm::golden {

/// Unit normals, [height][width]: u to the right, v up, w to the viewer.
struct NormalField {
  int width = 0;
  int height = 0;
  std::vector<std::array<double, 3>> normals;
  std::vector<std::string> notes = {};  ///< what was odd about the picture, said to the user
};

/// Normals of a height field (Blinn 1978), the picture's mean channel in levels.
///
///     N = (-s dh/dx, s dh/dy, 1) / |.|,   h = level / 255,   s = strength in pixels of height
///
/// where y counts rows downwards. Differences are central, one-sided at the edges.
/// An empty picture, or a strength that is not finite, throws std::invalid_argument.
[[nodiscard]] NormalField normals_from_heights(const ImageReal& picture, double strength);

/// Six coefficients a texel by the table, in levels (255 for full light): [height][width][6].
[[nodiscard]] std::vector<double> bump_coefficients(const NormalField& field,
                                                    const NormalTable& table);

/// How far polynomials are from max(0, N.L) over the hemisphere of lights, evenly by solid angle;
/// a polynomial below 0 counts as 0, as D6 of docs/spec/datapath.md has it. In levels.
struct BumpError {
  double rmse = 0;
  double max = 0;
  std::array<double, 9> by_elevation{};  ///< RMSE of lights 0-10, 10-20, ... 80-90 degrees high
};

/// Lights on a spiral of `lights` directions; at most 4096 texels, evenly picked, are looked at.
[[nodiscard]] BumpError measure_bump(const NormalField& field, const std::vector<double>& coef,
                                     std::size_t lights = 1024);

}  // namespace ptm::golden
