#include "testbench/compare/part_difference.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "testbench/compare/picture_difference.h"

namespace ptm::testbench {

std::optional<PartDifference> compare_without(std::span<const golden::ImageReal> a,
                                              std::span<const golden::ImageReal> b,
                                              const std::vector<std::uint8_t>& left_out) {
  if (a.size() != b.size()) throw std::invalid_argument("part: unequal numbers of frames");
  PartDifference part;
  double sum = 0, squares = 0;
  for (std::size_t f = 0; f < a.size(); ++f) {
    const auto channels = static_cast<std::size_t>(a[f].channels);
    const std::size_t samples = left_out.size() * channels;
    if (a[f].samples.size() != samples || b[f].samples.size() != samples) {
      throw std::invalid_argument("part: a frame of another size than the mask");
    }
    for (std::size_t i = 0; i < samples; ++i) {
      if (left_out[i / channels] != 0) continue;
      const double error = std::abs(b[f].samples[i] - a[f].samples[i]);
      ++part.samples;
      part.differing += level8(a[f].samples[i]) != level8(b[f].samples[i]) ? 1U : 0U;
      part.max = std::max(part.max, error);
      sum += error;
      squares += error * error;
    }
  }
  if (part.samples == 0) return std::nullopt;
  const auto count = static_cast<double>(part.samples);
  part.mean = sum / count;
  part.rmse = std::sqrt(squares / count);
  part.psnr_db = 20 * std::log10(255 / part.rmse);
  return part;
}

}  // namespace ptm::testbench
