#include "golden/fit/near_lights.h"

#include <cmath>

namespace ptm::golden {

NearLights::NearLights(std::span<const std::array<double, 3>> positions, const PictureFrame& frame)
    : positions_(positions.begin(), positions.end()), frame_(frame) {}

NearLights::Seen NearLights::at(std::size_t light, std::size_t texel) const {
  const auto width = static_cast<std::size_t>(frame_.region.width);
  const double column = frame_.region.x + static_cast<double>(texel % width) + 0.5;
  const double row = frame_.region.y + static_cast<double>(texel / width) + 0.5;
  const auto& p = positions_[light];
  const double x = p[0] - (column - frame_.width / 2.0) * frame_.pixel;
  const double y = p[1] - (frame_.height / 2.0 - row) * frame_.pixel;
  const double away = std::hypot(x, y, p[2]), centre = std::hypot(p[0], p[1], p[2]);
  return {x / away, y / away, (centre / away) * (centre / away)};
}

NearSolver::NearSolver(const LightSolver& centre, const NearLights& lights)
    : lights_(lights),
      subspace_(centre.subspace),
      design_(static_cast<Eigen::Index>(lights.size()), 6),
      falloff_(static_cast<Eigen::Index>(lights.size())) {}

void NearSolver::look(std::size_t texel) {
  for (std::size_t i = 0; i < lights_.size(); ++i) {
    const NearLights::Seen seen = lights_.at(i, texel);
    const auto row = static_cast<Eigen::Index>(i);
    design_.row(row) = light_basis(seen.u, seen.v).transpose();
    falloff_[row] = seen.falloff;
  }
  reduced_ = design_ * subspace_;
  qr_.compute(reduced_);
}

Eigen::Matrix<double, 6, 1> NearSolver::solve(const Eigen::VectorXd& samples) const {
  return subspace_ * qr_.solve(samples);
}

Eigen::VectorXd NearSolver::leverage() const {
  const Eigen::MatrixXd q =
      qr_.householderQ() * Eigen::MatrixXd::Identity(reduced_.rows(), reduced_.cols());
  return q.rowwise().squaredNorm();
}

}  // namespace ptm::golden
