#include "testbench/compare/picture_difference.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "testbench/compare/ssim.h"

namespace ptm::testbench {
namespace {

using golden::ImageReal;
using Frames = std::span<const ImageReal>;

constexpr std::size_t kWorst = 10;
constexpr int kMostHalfBins = 32;
constexpr double kFinestBin = 1.0 / 32;

/// x * 0 is zero for finite x and not a number otherwise. Four sums keep the adder busy.
bool all_finite(const ImageReal& image) {
  double sums[4] = {};
  const std::size_t fours = image.samples.size() / 4 * 4;
  for (std::size_t i = 0; i < fours; i += 4) {
    for (std::size_t k = 0; k < 4; ++k) sums[k] += image.samples[i + k] * 0;
  }
  for (std::size_t i = fours; i < image.samples.size(); ++i) sums[0] += image.samples[i] * 0;
  return sums[0] + sums[1] + sums[2] + sums[3] == 0;
}

std::string size_text(const ImageReal& image) {
  return std::to_string(image.width) + " x " + std::to_string(image.height) + " x " +
         std::to_string(image.channels);
}

[[noreturn]] void refuse(const std::string& what) {
  throw std::invalid_argument("compare_frames: " + what);
}

/// Names the first sample that is not finite.
[[noreturn]] void refuse_sample(const ImageReal& image, const char* side, std::size_t frame) {
  const auto bad = std::find_if(image.samples.begin(), image.samples.end(),
                                [](double x) { return !std::isfinite(x); });
  const std::size_t i = static_cast<std::size_t>(bad - image.samples.begin());
  const std::size_t channels = static_cast<std::size_t>(image.channels);
  const std::size_t width = static_cast<std::size_t>(image.width);
  refuse("frame " + std::to_string(frame) + ", picture " + side + ", x " +
         std::to_string(i / channels % width) + ", y " + std::to_string(i / channels / width) +
         ", channel " + std::to_string(i % channels) + ": found " + std::to_string(*bad) +
         ", expected a finite number");
}

void check(Frames a, Frames b) {
  if (a.empty() || a.size() != b.size()) {
    refuse("found " + std::to_string(a.size()) + " and " + std::to_string(b.size()) +
           " frames, expected equal numbers, at least one");
  }
  for (std::size_t f = 0; f < a.size(); ++f) {
    const ImageReal &p = a[f], &q = b[f];
    const bool same = p.width == q.width && p.height == q.height && p.channels == q.channels &&
                      p.width == a[0].width && p.height == a[0].height &&
                      p.channels == a[0].channels;
    const bool sound = p.width > 0 && p.height > 0 && (p.channels == 1 || p.channels == 3) &&
                       p.samples.size() == p.index(0, p.height) &&
                       q.samples.size() == p.samples.size();
    if (!same || !sound) {
      refuse("frame " + std::to_string(f) + ": found " + size_text(p) + " and " + size_text(q) +
             " samples, expected equal sizes in all frames, 1 or 3 channels");
    }
    if (!all_finite(p)) refuse_sample(p, "a", f);
    if (!all_finite(q)) refuse_sample(q, "b", f);
  }
}

bool all_integers(Frames frames) {
  return std::all_of(frames.begin(), frames.end(), [](const ImageReal& image) {
    return std::all_of(image.samples.begin(), image.samples.end(), [](double x) {
      // The cast is quick where std::trunc is a call; a level beyond its range needs no answer.
      return std::abs(x) < 1e9 && static_cast<double>(static_cast<int>(x)) == x;
    });
  });
}

struct Sums {
  double absolute = 0, square = 0;
};

void add_samples(const ImageReal& a, const ImageReal& b, PictureDifference& difference,
                 Sums& sums) {
  double absolute = 0, square = 0, largest = difference.max;
  std::uint64_t differing = 0;
  for (std::size_t i = 0; i < a.samples.size(); ++i) {
    const double error = std::abs(b.samples[i] - a.samples[i]);
    absolute += error;
    square += error * error;
    largest = std::max(largest, error);
    differing += level8(a.samples[i]) != level8(b.samples[i]) ? 1U : 0U;
  }
  difference.differing += differing;
  difference.max = largest;
  sums.absolute += absolute;
  sums.square += square;
}

/// `largest` must be the greatest |error| that will be counted.
ErrorHistogram empty_histogram(double largest, bool integers) {
  ErrorHistogram histogram;
  double width = integers ? 1.0 : kFinestBin;
  while (largest / width >= kMostHalfBins + 0.5) width *= 2;
  histogram.bin_width = width;
  histogram.half_bins = static_cast<int>(largest / width + 0.5);
  histogram.counts.assign(2 * static_cast<std::size_t>(histogram.half_bins) + 1, 0);
  return histogram;
}

void count_errors(const ImageReal& a, const ImageReal& b, ErrorHistogram& histogram) {
  const double scale = 1 / histogram.bin_width;  // exact: a power of two
  const double middle = histogram.half_bins + 0.5;
  for (std::size_t i = 0; i < a.samples.size(); ++i) {
    const double bin = (b.samples[i] - a.samples[i]) * scale + middle;  // never below 0
    ++histogram.counts[std::min(histogram.counts.size() - 1, static_cast<std::size_t>(bin))];
  }
}

/// Scanned in order of frame, y, x, with a strict comparison: of equal errors the first stays.
void keep_worst(const ImageReal& a, const ImageReal& b, int frame, std::vector<WorstPixel>& worst) {
  const std::size_t channels = static_cast<std::size_t>(a.channels);
  const double *pa = a.samples.data(), *pb = b.samples.data();
  double bar = worst.size() < kWorst ? 0 : worst.back().error;
  for (int y = 0; y < a.height; ++y) {
    for (int x = 0; x < a.width; ++x, pa += channels, pb += channels) {
      double error = 0;
      for (std::size_t c = 0; c < channels; ++c) error = std::max(error, std::abs(pb[c] - pa[c]));
      if (error <= bar) continue;
      const auto after = std::find_if(worst.begin(), worst.end(),
                                      [&](const WorstPixel& w) { return w.error < error; });
      worst.insert(after, {frame, x, y, error});
      if (worst.size() > kWorst) worst.pop_back();
      if (worst.size() == kWorst) bar = worst.back().error;
    }
  }
}

}  // namespace

PictureDifference compare_frames(Frames a, Frames b) {
  check(a, b);
  PictureDifference difference;
  Sums sums;
  // Models that must agree do as a rule: equal frames are known by one quick look, and only
  // counted.
  std::vector<bool> equal(a.size());
  for (std::size_t f = 0; f < a.size(); ++f) {
    equal[f] = a[f].samples == b[f].samples;
    difference.samples += a[f].samples.size();
    if (!equal[f]) add_samples(a[f], b[f], difference, sums);
  }
  const double samples = static_cast<double>(difference.samples);
  difference.share = static_cast<double>(difference.differing) / samples;
  difference.mean = sums.absolute / samples;
  difference.rmse = std::sqrt(sums.square / samples);
  difference.psnr_db = difference.rmse > 0 ? 20 * std::log10(255 / difference.rmse)
                                           : std::numeric_limits<double>::infinity();
  ErrorHistogram& histogram = difference.histogram;
  histogram = empty_histogram(difference.max, all_integers(a) && all_integers(b));
  for (std::size_t f = 0; f < a.size(); ++f) {
    if (equal[f]) {
      histogram.counts[static_cast<std::size_t>(histogram.half_bins)] += a[f].samples.size();
      difference.ssim += 1;
      continue;
    }
    count_errors(a[f], b[f], histogram);
    keep_worst(a[f], b[f], static_cast<int>(f), difference.worst);
    difference.ssim += structural_similarity(a[f], b[f]);
  }
  difference.ssim /= static_cast<double>(a.size());
  return difference;
}

PictureDifference compare_pictures(const ImageReal& a, const ImageReal& b) {
  return compare_frames({&a, 1}, {&b, 1});
}

}  // namespace ptm::testbench
