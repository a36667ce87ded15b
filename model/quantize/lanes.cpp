#include "model/quantize/lanes.h"

#include <algorithm>
#include <cmath>

#include "model/quantize/wide.h"

namespace ptm::quantize {
namespace {

constexpr double kFarthest = 1e100;  ///< an error whose square is still finite

PTM_QUANTIZE_WIDE void split_six(const double* coef, std::size_t count, const Six<double*>& real) {
  double *a0 = real[0], *a1 = real[1], *a2 = real[2], *a3 = real[3], *a4 = real[4], *a5 = real[5];
  for (std::size_t t = 0; t < count; ++t) {
    const double* a = coef + t * kSix;
    a0[t] = a[0];
    a1[t] = a[1];
    a2[t] = a[2];
    a3[t] = a[3];
    a4[t] = a[4];
    a5[t] = a[5];
  }
}

PTM_QUANTIZE_WIDE void subtract(double share, const double* error, std::size_t count,
                                double* values) {
  for (std::size_t t = 0; t < count; ++t) values[t] -= share * error[t];
}

/// The numbers of a Step as the loop wants them.
struct RealStep {
  double up, down, low, high, bias;
};

PTM_QUANTIZE_WIDE std::uint64_t round_values(const double* __restrict targets,
                                             const double* __restrict real, std::size_t count,
                                             RealStep step, double* __restrict error,
                                             std::int32_t* __restrict stored) {
  std::uint64_t saturated = 0;
  for (std::size_t t = 0; t < count; ++t) {
    const double rounded = std::floor(targets[t] * step.up + 0.5);
    const double raised = rounded > step.low ? rounded : step.low;
    const double delta = raised < step.high ? raised : step.high;
    const double off = delta * step.down - real[t];
    const double limited = off > -kFarthest ? off : -kFarthest;
    stored[t] = static_cast<std::int32_t>(delta + step.bias);
    error[t] = limited < kFarthest ? limited : kFarthest;
    saturated += delta != rounded ? 1U : 0U;
  }
  return saturated;
}

PTM_QUANTIZE_WIDE void add_square(double weight, const double* error, const double* others,
                                  std::size_t count, double* sum) {
  for (std::size_t t = 0; t < count; ++t) {
    const double part = weight * error[t] + others[t];
    sum[t] += part * part;
  }
}

PTM_QUANTIZE_WIDE void merge_six(const Six<const std::int32_t*>& lanes, std::size_t count,
                                 std::uint16_t* stored) {
  const std::int32_t *a0 = lanes[0], *a1 = lanes[1], *a2 = lanes[2];
  const std::int32_t *a3 = lanes[3], *a4 = lanes[4], *a5 = lanes[5];
  for (std::size_t t = 0; t < count; ++t) {
    std::uint16_t* a = stored + t * kSix;
    a[0] = static_cast<std::uint16_t>(a0[t]);
    a[1] = static_cast<std::uint16_t>(a1[t]);
    a[2] = static_cast<std::uint16_t>(a2[t]);
    a[3] = static_cast<std::uint16_t>(a3[t]);
    a[4] = static_cast<std::uint16_t>(a4[t]);
    a[5] = static_cast<std::uint16_t>(a5[t]);
  }
}

}  // namespace

Lanes::Lanes(std::size_t polynomials) : luminance(polynomials), others(polynomials) {
  for (std::size_t i = 0; i < kSix; ++i) {
    real[i].resize(polynomials);
    error[i].resize(polynomials);
    stored[i].resize(polynomials);
  }
}

void split(std::span<const double> coef, Lanes& lanes) {
  Six<double*> real{};
  for (std::size_t i = 0; i < kSix; ++i) real[i] = lanes.real[i].data();
  split_six(coef.data(), lanes.size(), real);
  std::fill(lanes.luminance.begin(), lanes.luminance.end(), 0.0);
}

void subtract_share(double share, std::span<const double> error, std::span<double> values) {
  subtract(share, error.data(), values.size(), values.data());
}

std::uint64_t round_lane(std::span<const double> targets, const Step& step, std::size_t i,
                         Lanes& lanes) {
  const RealStep numbers{std::ldexp(1.0, step.shift), std::ldexp(1.0, -step.shift),
                         static_cast<double>(step.window.low),
                         static_cast<double>(step.window.high), static_cast<double>(step.bias)};
  return round_values(targets.data(), lanes.real[i].data(), lanes.size(), numbers,
                      lanes.error[i].data(), lanes.stored[i].data());
}

void add_luminance(const Six<double>& row, std::size_t i, Lanes& lanes) {
  std::fill(lanes.others.begin(), lanes.others.end(), 0.0);
  for (std::size_t j = i + 1; j < kSix; ++j) {
    if (row[j] != 0) subtract_share(-row[j], lanes.error[j], lanes.others);
  }
  add_square(row[i], lanes.error[i].data(), lanes.others.data(), lanes.size(),
             lanes.luminance.data());
}

void merge(const Lanes& lanes, std::span<std::uint16_t> stored) {
  Six<const std::int32_t*> from{};
  for (std::size_t i = 0; i < kSix; ++i) from[i] = lanes.stored[i].data();
  merge_six(from, lanes.size(), stored.data());
}

}  // namespace ptm::quantize
