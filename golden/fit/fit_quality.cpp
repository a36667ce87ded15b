#include "golden/fit/fit_quality.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "golden/files/lum_matrix.h"

namespace ptm::golden {
namespace {

constexpr double kAlone = 1e-9;  ///< 1 - h of a light that no other light speaks for

double psnr(double rmse) {
  return rmse > 0 ? 20 * std::log10(255 / rmse) : std::numeric_limits<double>::infinity();
}

/// A map's texels as straight lines of the polynomials: channel = gain * L_p + offset.
class Renderer {
 public:
  Renderer(MapKind kind, std::span<const double> coef, std::span<const std::uint8_t> color,
           std::size_t texels)
      : kind_(kind), texels_(texels), color_(color), luminance_(texels) {
    PtmMap shape;
    shape.kind = kind;
    polynomials_ = shape.polynomials();
    if (coef.size() != texels * 6 * polynomials_ || color.size() != texels * shape.color_bytes()) {
      throw std::invalid_argument("a map of another size than its photographs");
    }
    planes_.resize(coef.size());
    for (std::size_t n = 0; n < coef.size(); ++n) {
      planes_[n % (6 * polynomials_) * texels + n / (6 * polynomials_)] = coef[n];
    }
  }

  /// The channel's levels under a light, clamped; valid until the next call.
  const std::vector<double>& render(const Eigen::Matrix<double, 6, 1>& basis, std::size_t channel) {
    if (polynomials_ == 3 || channel == 0) evaluate(basis, polynomials_ == 3 ? channel : 0);
    mix(channel);
    return clamp();
  }

  /// The same under a near light, as each texel sees it.
  const std::vector<double>& render(std::span<const NearLights::Seen> seen, std::size_t channel) {
    if (polynomials_ == 3 || channel == 0) evaluate(seen, polynomials_ == 3 ? channel : 0);
    mix(channel);
    for (std::size_t t = 0; t < texels_; ++t) levels_[t] *= seen[t].falloff;
    return clamp();
  }

 private:
  void mix(std::size_t channel) {
    levels_ = luminance_;
    if (kind_ == MapKind::rgb) return;
    constexpr auto matrix = jfif_lum_matrix();
    const double* row = matrix.data() + channel * 4;
    for (std::size_t t = 0; t < texels_; ++t) {
      levels_[t] = kind_ == MapKind::lrgb ? color_[t * 3 + channel] * luminance_[t] / 255
                                          : row[0] * color_[t * 2] + row[1] * luminance_[t] +
                                                row[2] * color_[t * 2 + 1] + row[3];
    }
  }

  void evaluate(std::span<const NearLights::Seen> seen, std::size_t polynomial) {
    const double* plane = planes_.data() + polynomial * 6 * texels_;
    for (std::size_t t = 0; t < texels_; ++t) {
      const auto basis = light_basis(seen[t].u, seen[t].v);
      luminance_[t] = 0;
      for (std::size_t k = 0; k < 6; ++k) {
        luminance_[t] += basis[static_cast<Eigen::Index>(k)] * plane[k * texels_ + t];
      }
    }
  }
  void evaluate(const Eigen::Matrix<double, 6, 1>& basis, std::size_t polynomial) {
    std::fill(luminance_.begin(), luminance_.end(), 0.0);
    for (std::size_t k = 0; k < 6; ++k) {
      const double b = basis[static_cast<Eigen::Index>(k)];
      const double* plane = planes_.data() + (polynomial * 6 + k) * texels_;
      for (std::size_t t = 0; t < texels_; ++t) luminance_[t] += b * plane[t];
    }
  }
  const std::vector<double>& clamp() {
    for (double& level : levels_) level = std::clamp(level, 0.0, 255.0);
    return levels_;
  }

  MapKind kind_;
  std::size_t texels_, polynomials_ = 1;
  std::span<const std::uint8_t> color_;
  std::vector<double> planes_;  ///< [polynomial][coefficient][texel]
  std::vector<double> luminance_, levels_;
};

}  // namespace

Residual to_residual(const Squares& squares, double samples_per_channel) {
  Residual r;
  double all = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    r.channel_rmse[c] = std::sqrt(squares[c] / samples_per_channel);
    r.channel_psnr_db[c] = psnr(r.channel_rmse[c]);
    all += squares[c];
  }
  r.rmse = std::sqrt(all / (3 * samples_per_channel));
  r.psnr_db = psnr(r.rmse);
  return r;
}

void add_squares(const PhotoTile& tile, std::span<const std::array<double, 3>> directions,
                 MapKind kind, std::span<const double> coef, std::span<const std::uint8_t> color,
                 std::span<Squares> squares, std::span<double> texel_squares, NearTexels near) {
  if (squares.size() != directions.size() ||
      (!texel_squares.empty() && texel_squares.size() != tile.texels)) {
    throw std::invalid_argument("squares of another size than the photographs");
  }
  Renderer renderer(kind, coef, color, tile.texels);
  std::vector<NearLights::Seen> seen(near.lights == nullptr ? 0 : tile.texels);
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const auto basis = light_basis(directions[i][0], directions[i][1]);
    for (std::size_t t = 0; t < seen.size(); ++t) seen[t] = near.lights->at(i, near.first + t);
    for (std::size_t c = 0; c < 3; ++c) {
      const std::vector<double>& levels =
          near.lights == nullptr ? renderer.render(basis, c) : renderer.render(seen, c);
      const float* photograph = tile.plane(i, c);
      double sum = 0;
      for (std::size_t t = 0; t < tile.texels; ++t) {
        const double difference = levels[t] - double{photograph[t]};
        sum += difference * difference;
        if (!texel_squares.empty()) texel_squares[t] += difference * difference;
      }
      squares[i][c] += sum;
    }
  }
}

bool has_leave_one_out(const LightSolver& solver, std::size_t light) {
  return 1 - solver.leverage[static_cast<Eigen::Index>(light)] > kAlone;
}

namespace {

/// Leave-one-out residuals texel by texel, each with its own lights.
void add_near_leave_one_out(const PhotoTile& tile, const LightSolver& solver, MapKind kind,
                            std::span<double> squares, const NearTexels& near) {
  NearSolver texel(solver, *near.lights);
  Eigen::VectorXd y(solver.inverse.cols());
  const auto signals = fitted_signals(kind);
  for (std::size_t t = 0; t < tile.texels; ++t) {
    texel.look(near.first + t);
    const Eigen::ArrayXd away = (1 - texel.leverage().array()).max(kAlone);
    for (const auto& weights : signals) {
      for (Eigen::Index i = 0; i < y.size(); ++i) {
        y[i] = 0;
        for (std::size_t c = 0; c < 3; ++c) {
          y[i] += weights[c] * double{tile.plane(static_cast<std::size_t>(i), c)[t]};
        }
      }
      y = y.cwiseQuotient(texel.falloff());
      const Eigen::ArrayXd missed =
          (y - texel.design() * texel.solve(y)).array() / away * texel.falloff().array();
      for (std::size_t i = 0; i < squares.size(); ++i) {
        if (!has_leave_one_out(solver, i)) continue;
        const double one = missed[static_cast<Eigen::Index>(i)];
        squares[i] += one * one;
      }
    }
  }
}

}  // namespace

void add_leave_one_out(const PhotoTile& tile, const LightSolver& solver, MapKind kind,
                       std::span<double> squares, NearTexels near) {
  const std::size_t lights = squares.size();
  if (static_cast<Eigen::Index>(lights) != solver.inverse.cols()) {
    throw std::invalid_argument("leave-one-out sums of another number of lights");
  }
  if (near.lights != nullptr) return add_near_leave_one_out(tile, solver, kind, squares, near);
  Eigen::MatrixXd y(static_cast<Eigen::Index>(tile.texels), solver.inverse.cols());
  for (const auto& weights : fitted_signals(kind)) {
    for (std::size_t i = 0; i < lights; ++i) {
      double* column = y.data() + i * tile.texels;
      const float *r = tile.plane(i, 0), *g = tile.plane(i, 1), *b = tile.plane(i, 2);
      for (std::size_t t = 0; t < tile.texels; ++t) {
        column[t] =
            weights[0] * double{r[t]} + weights[1] * double{g[t]} + weights[2] * double{b[t]};
      }
    }
    const Eigen::MatrixXd a = y * solver.inverse.transpose();
    for (std::size_t i = 0; i < lights; ++i) {
      if (!has_leave_one_out(solver, i)) continue;
      const auto n = static_cast<Eigen::Index>(i);
      const double away = 1 - solver.leverage[n];
      squares[i] += (y.col(n) - a * solver.design.row(n).transpose()).squaredNorm() / (away * away);
    }
  }
}

}  // namespace ptm::golden
