#include "testbench/compare/ssim.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace ptm::testbench {
namespace {

constexpr int kTaps = 11;
constexpr double kSigma = 1.5;
constexpr double kC1 = (0.01 * 255) * (0.01 * 255);
constexpr double kC2 = (0.03 * 255) * (0.03 * 255);

using Kernel = std::array<double, kTaps>;
using Plane = std::vector<double>;

struct Window {
  std::size_t taps = 1;
  Kernel weight{};
};

Window window_for(int extent) {
  Window window;
  const int taps = extent >= kTaps ? kTaps : extent - (extent + 1) % 2;
  window.taps = static_cast<std::size_t>(taps);
  double sum = 0;
  for (std::size_t i = 0; i < window.taps; ++i) {
    const double r = static_cast<double>(i) - (taps - 1) / 2.0;
    window.weight[i] = std::exp(-r * r / (2 * kSigma * kSigma));
    sum += window.weight[i];
  }
  for (double& weight : window.weight) weight /= sum;
  return window;
}

/// out[x] = sum over t of weight[t] * in[x + t * stride]. For the full window the tap count is
/// known at compile time, so that the sums stay in registers, and mirrored taps share a multiply.
template <std::size_t Taps>
void weigh_fixed(const double* in, std::size_t stride, const Kernel& weight, std::size_t count,
                 double* out) {
  const Kernel w = weight;  // a copy cannot alias `out`
  constexpr std::size_t kLast = Taps - 1;
  for (std::size_t x = 0; x < count; ++x) {
    double sum = w[Taps / 2] * in[x + Taps / 2 * stride];
    for (std::size_t t = 0; t < Taps / 2; ++t) {
      sum += w[t] * (in[x + t * stride] + in[x + (kLast - t) * stride]);
    }
    out[x] = sum;
  }
}

void weigh(const double* in, std::size_t stride, const Window& window, std::size_t count,
           double* out) {
  if (window.taps == kTaps) return weigh_fixed<kTaps>(in, stride, window.weight, count, out);
  for (std::size_t x = 0; x < count; ++x) {
    out[x] = 0;
    for (std::size_t t = 0; t < window.taps; ++t) out[x] += window.weight[t] * in[x + t * stride];
  }
}

double luma(const golden::ImageReal& image, std::size_t pixel) {
  if (image.channels == 1) return image.samples[pixel];
  const double* rgb = &image.samples[pixel * 3];
  return 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2];
}

/// Planes that are filtered: the sum s = a + b, the difference d = a - b, and their squares. They
/// hold all that SSIM needs, one plane fewer than a, b, aa, bb, ab:
///     2 ma mb = (ms^2 - md^2) / 2      ma^2 + mb^2 = (ms^2 + md^2) / 2
/// and the same with variances: 2 sab = (Vs - Vd) / 2, sa^2 + sb^2 = (Vs + Vd) / 2.
std::array<Plane, 4> sum_and_difference(const golden::ImageReal& a, const golden::ImageReal& b) {
  const std::size_t pixels = static_cast<std::size_t>(a.width) * static_cast<std::size_t>(a.height);
  std::array<Plane, 4> planes;
  for (Plane& plane : planes) plane.resize(pixels);
  for (std::size_t i = 0; i < pixels; ++i) {
    const double la = luma(a, i), lb = luma(b, i);
    planes[0][i] = la + lb;
    planes[1][i] = la - lb;
    planes[2][i] = (la + lb) * (la + lb);
    planes[3][i] = (la - lb) * (la - lb);
  }
  return planes;
}

double window_similarity(double ms, double md, double ss, double dd) {
  const double vs = ss - ms * ms, vd = dd - md * md;
  const double mean = ((ms * ms - md * md) / 2 + kC1) / ((ms * ms + md * md) / 2 + kC1);
  const double structure = ((vs - vd) / 2 + kC2) / ((vs + vd) / 2 + kC2);
  return mean * structure;
}

}  // namespace

double structural_similarity(const golden::ImageReal& a, const golden::ImageReal& b) {
  const Window across = window_for(a.width), down = window_for(a.height);
  const std::size_t width = static_cast<std::size_t>(a.width);
  const std::size_t columns = width - across.taps + 1;
  const std::size_t rows = static_cast<std::size_t>(a.height) - down.taps + 1;
  const std::array<Plane, 4> planes = sum_and_difference(a, b);
  Plane column_sums(width);
  std::array<Plane, 4> filtered;
  for (Plane& row : filtered) row.resize(columns);
  double total = 0;
  for (std::size_t y = 0; y < rows; ++y) {
    for (std::size_t p = 0; p < planes.size(); ++p) {
      weigh(&planes[p][y * width], width, down, width, column_sums.data());
      weigh(column_sums.data(), 1, across, columns, filtered[p].data());
    }
    for (std::size_t x = 0; x < columns; ++x) {
      total += window_similarity(filtered[0][x], filtered[1][x], filtered[2][x], filtered[3][x]);
    }
  }
  return total / (static_cast<double>(columns) * static_cast<double>(rows));
}

}  // namespace ptm::testbench
