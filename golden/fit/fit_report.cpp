#include "golden/fit/fit_report.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace ptm::golden {
namespace {

using Sums = std::array<double, 3>;  ///< squared differences, a channel each

Sums squared_differences(std::span<const float> photograph, const std::array<double, 3>& light,
                         std::span<const double> coef, std::span<const std::uint8_t> color) {
  const Eigen::Matrix<double, 6, 1> basis = light_basis(light[0], light[1]);
  Sums sums{};
  for (std::size_t t = 0; t * 6 < coef.size(); ++t) {
    const double* a = coef.data() + t * 6;
    double luminance = 0;
    for (std::size_t i = 0; i < 6; ++i) luminance += a[i] * basis[static_cast<Eigen::Index>(i)];
    for (std::size_t c = 0; c < 3; ++c) {
      const double level = std::clamp(color[t * 3 + c] * luminance / 255, 0.0, 255.0);
      const double difference = level - double{photograph[t * 3 + c]};
      sums[c] += difference * difference;
    }
  }
  return sums;
}

Residual residual(const Sums& sums, double samples_per_channel) {
  Residual r;
  double all = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    r.channel_rmse[c] = std::sqrt(sums[c] / samples_per_channel);
    all += sums[c];
  }
  r.rmse = std::sqrt(all / (3 * samples_per_channel));
  r.psnr_db = r.rmse > 0 ? 20 * std::log10(255 / r.rmse) : std::numeric_limits<double>::infinity();
  return r;
}

}  // namespace

FitReport compare_lrgb(const Capture& capture, std::span<const double> coef,
                       std::span<const std::uint8_t> color) {
  const std::size_t texels =
      static_cast<std::size_t>(capture.width) * static_cast<std::size_t>(capture.height);
  if (texels == 0 || coef.size() != texels * 6 || color.size() != texels * 3) {
    throw std::invalid_argument("a map of another size than its photographs");
  }
  const std::size_t lights = capture.photographs.size();
  std::vector<Sums> sums(lights);
  tbb::parallel_for(std::size_t{0}, lights, [&](std::size_t i) {
    sums[i] =
        squared_differences(capture.photographs[i].samples, capture.directions[i], coef, color);
  });
  FitReport report;
  Sums total{};
  for (const Sums& one : sums) {
    report.lights.push_back(residual(one, static_cast<double>(texels)));
    for (std::size_t c = 0; c < 3; ++c) total[c] += one[c];
  }
  report.all = residual(total, static_cast<double>(texels * lights));
  return report;
}

}  // namespace ptm::golden
