// What rounding six coefficients together gains over rounding each on its own, on real captures.
// The measure is in docs/design/nearest-plane.md.
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

#include "golden/scene/relief.h"
#include "model/quantize/choose_grid.h"
#include "model/quantize/quantize.h"
#include "tests/convert/lrgb_fit.h"
#include "tests/shared_data.h"

namespace ptm::quantize {
namespace {

/// Stored less real, as the picture shows it: RMS of colour * dL / 255 over texels, channels and
/// lights all round the hemisphere, evenly by solid angle (so the mean over lights is e^T G e).
double picture_psnr(const tests::LrgbFit& fit, const StoredMap& stored) {
  const Gram g = hemisphere_gram();
  const std::vector<double> held = dequantize(stored);
  double squares = 0;
  for (std::size_t t = 0; t * 3 < fit.color.size(); ++t) {
    Eigen::Matrix<double, 6, 1> e;
    for (std::size_t i = 0; i < kSix; ++i) {
      e[static_cast<Eigen::Index>(i)] = held[t * kSix + i] - fit.coef[t * kSix + i];
    }
    const double luminance = e.dot(g * e);
    for (std::size_t c = 0; c < 3; ++c) {
      squares += std::pow(fit.color[t * 3 + c] / 255.0, 2) * luminance;
    }
  }
  return 10 * std::log10(255 * 255 / (squares / static_cast<double>(fit.color.size())));
}

struct Gain {
  double plain, on_same_grid, nearest_plane;
};

Gain measure(const std::filesystem::path& lp, const char* preset,
             golden::FullRange full_range = golden::FullRange::color) {
  const tests::LrgbFit fit = tests::fit_lrgb(lp, {.full_range = full_range});
  const RealMap real{fit.width, fit.height, 1, fit.coef};
  const Gram g = hemisphere_gram();
  const auto& config = reference::find_preset(preset).config;
  const Grid grid = range_grid(real, config);
  const Gain gain{picture_psnr(fit, quantize_on_grid(real, grid, config, Method::plain, g)),
                  picture_psnr(fit, quantize_on_grid(real, grid, config, Method::nearest_plane, g)),
                  picture_psnr(fit, quantize(real, config, Method::nearest_plane, g))};
  std::cout << lp.parent_path().filename().string() << ", " << preset
            << ": plain on the grid by range " << gain.plain << " dB, nearest plane on that grid "
            << gain.on_same_grid << " dB, nearest plane on the grid by error " << gain.nearest_plane
            << " dB, gain " << gain.nearest_plane - gain.plain << " dB\n";
  return gain;
}

struct Asked {
  const char* capture;
  double gain;
};
constexpr Asked kAsked[] = {
    {"icon/dirs.lp", 5}, {"dome/Dome/dirs.lp", 3}, {"reference_8x5/reference_8x5.lp", 5}};

TEST(NearestPlaneGain, IsWhatWasAskedForOnThreeCaptures) {
  for (const Asked& asked : kAsked) {
    PTM_SHARED_DATA_OR_SKIP(lp, asked.capture);
    for (const char* preset : {"base", "paper8"}) {
      const Gain gain = measure(lp, preset);
      EXPECT_GT(gain.on_same_grid, gain.plain + asked.gain) << asked.capture << ' ' << preset;
      EXPECT_GT(gain.nearest_plane, gain.plain + asked.gain) << asked.capture << ' ' << preset;
    }
  }
}

TEST(NearestPlaneGain, IsFourAndAHalfDecibelsAtLeastWhereLuminanceFillsItsRange) {
  // Polynomials scaled as HP's fitter scales them. Of 40 texels the two grids are one, and the
  // exact nearest point of the lattice gains 0.02 dB more, no more.
  for (const Asked& asked : kAsked) {
    PTM_SHARED_DATA_OR_SKIP(lp, asked.capture);
    const Gain gain = measure(lp, "base", golden::FullRange::luminance);
    EXPECT_GT(gain.nearest_plane, gain.plain + std::min(asked.gain, 4.5)) << asked.capture;
  }
}

}  // namespace
}  // namespace ptm::quantize
