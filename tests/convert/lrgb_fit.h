#pragma once
#include <filesystem>
#include <limits>
#include <vector>

#include "golden/fit/capture.h"
#include "golden/fit/fit_tile.h"
#include "golden/fit/light_solver.h"
#include "golden/fit/photo_bands.h"

namespace ptm::tests {

/// A small capture fitted whole, as an LRGB map with real coefficients.
struct LrgbFit {
  int width = 0, height = 0;
  std::vector<double> coef;         ///< [height][width][6]
  std::vector<std::uint8_t> color;  ///< [height][width][3]
};

inline LrgbFit fit_lrgb(const std::filesystem::path& lp, const golden::FitOptions& options = {}) {
  golden::CaptureRequest request;
  request.source = lp;
  golden::Capture capture = golden::open_capture(request);
  golden::Capture* const only = &capture;
  golden::PhotoBands bands({&only, 1}, std::numeric_limits<std::size_t>::max());
  golden::Band band;
  bands.read(0, band);
  LrgbFit fit{capture.region.width, capture.region.height, {}, {}};
  fit.coef.resize(band.texels * 6);
  fit.color.resize(band.texels * 3);
  golden::fit_tile(band.tile(0, band.texels, 0), golden::solve_lights(capture.directions), options,
                   fit.coef, fit.color);
  return fit;
}

}  // namespace ptm::tests
