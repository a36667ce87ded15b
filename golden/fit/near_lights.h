#pragma once
#include <Eigen/QR>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "golden/files/picture_rows.h"
#include "golden/fit/light_solver.h"

namespace ptm::golden {

/// Where the pixels of a picture lie: in a plane, z = 0, with the picture's centre as the origin, x
/// right and y up. Pixels are square.
struct PictureFrame {
  int width = 0, height = 0;  ///< of the whole picture
  Region region;              ///< the part that texels are counted in
  double pixel = 0;           ///< a pixel's side in the unit of the lights' positions; above 0
};

/// Lights at known places near the object, each a small source that shines alike in all directions.
///
///     l = (P - x) / |P - x|          toward the light P from the pixel x
///     f = |P|^2 / |P - x|^2          its strength there, in parts of that in the picture's centre
///
/// so that a pixel of luminance polynomial L shows f L(l_u, l_v), in values proportional to light.
class NearLights {
 public:
  /// Positions in the frame's unit, none of them in the picture.
  NearLights(std::span<const std::array<double, 3>> positions, const PictureFrame& frame);

  struct Seen {
    double u = 0, v = 0, falloff = 1;
  };
  /// From a texel of the region, counted in rows.
  [[nodiscard]] Seen at(std::size_t light, std::size_t texel) const;
  [[nodiscard]] std::size_t size() const { return positions_.size(); }

 private:
  std::vector<std::array<double, 3>> positions_;
  PictureFrame frame_;
};

/// Some texels of a region under near lights; without lights, all lights are far.
struct NearTexels {
  const NearLights* lights = nullptr;
  std::size_t first = 0;  ///< texel of the region
};

/// Least squares for one texel after another, each with its own light vectors.
///
/// Photographs are divided by f, and each light counts alike, as in a fit of far lights: what the
/// polynomial misses is several levels, noise is half a level, so that rows weighted for noise
/// would only draw the polynomial toward the nearest lights. Solved by Householder's QR of design *
/// subspace, with the subspace that the lights determine in the picture's centre: no square of the
/// condition number enters, and where the centre leaves a coefficient open, so does every texel.
class NearSolver {
 public:
  using Design = Eigen::Matrix<double, Eigen::Dynamic, 6>;

  NearSolver(const LightSolver& centre, const NearLights& lights);

  /// Takes a texel's light vectors; what follows is of this texel.
  void look(std::size_t texel);
  [[nodiscard]] const Design& design() const { return design_; }
  [[nodiscard]] const Eigen::VectorXd& falloff() const { return falloff_; }
  /// Of samples divided by f, one a light.
  [[nodiscard]] Eigen::Matrix<double, 6, 1> solve(const Eigen::VectorXd& samples) const;
  /// Diagonal of the hat matrix.
  [[nodiscard]] Eigen::VectorXd leverage() const;

 private:
  const NearLights& lights_;
  Eigen::MatrixXd subspace_;
  Design design_;
  Eigen::VectorXd falloff_;
  Eigen::MatrixXd reduced_;  ///< design * subspace
  Eigen::HouseholderQR<Eigen::MatrixXd> qr_;
};

}  // namespace ptm::golden
