#include "testbench/run/hardware_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <sstream>
#include <stdexcept>

#include "golden/files/figure_text.h"
#include "golden/files/input_error.h"
#include "golden/render/light_map.h"

namespace ptm::testbench {
namespace {

using golden::MapKind;
using golden::PtmMap;
using reference::StoredTexture;

void take_integers(StoredTexture& texture, quantize::StoredMap&& stored) {
  texture.coef = std::move(stored.coef);
  std::copy(stored.bias.begin(), stored.bias.end(), texture.bias.begin());
  std::copy(stored.shift.begin(), stored.shift.end(), texture.shift.begin());
}

std::string describe(const quantize::StoredMap& stored, const quantize::Balance& balance,
                     const std::string& why_not) {
  std::ostringstream text;
  const auto saturated =
      std::accumulate(stored.saturated.begin(), stored.saturated.end(), std::uint64_t{0});
  text << "quantised (" << quantize::to_string(stored.origin) << ") because " << why_not
       << "; rms change of the luminance "
       << golden::count_of(golden::four_digits(stored.rms_error), "level") << ", "
       << golden::count_of(saturated, "coefficient") << " saturated";
  if (balance.exceeding > 0) {
    text << "; luminance of " << golden::count_of(balance.exceeding, "texel")
         << " exceeded the hardware's, " << balance.remaining
         << " of them also after scaling colours up";
  }
  return text.str();
}

/// The three channels' polynomials of one texel of a lum map.
void append_lum(const PtmMap& map, std::size_t texel, std::vector<double>& coef) {
  const golden::Coefficients y = golden::real_coefficients(map, texel);
  const double cr = map.color[texel * 2], cb = map.color[texel * 2 + 1];
  for (std::size_t c = 0; c < 3; ++c) {
    const double* row = &map.lum_matrix[c * 4];
    for (std::size_t k = 0; k < 6; ++k) coef.push_back(row[1] * y[k]);
    coef.back() += row[0] * cr + row[2] * cb + row[3];
  }
}

void append_texel(const PtmMap& map, std::size_t texel, std::vector<double>& coef) {
  if (map.kind == MapKind::lum) return append_lum(map, texel, coef);
  for (std::size_t p = 0; p < map.polynomials(); ++p) {
    const golden::Coefficients a = golden::real_coefficients(map, texel, p);
    coef.insert(coef.end(), a.begin(), a.end());
  }
}

}  // namespace

RealCoefficients real_polynomials(const PtmMap& map, std::size_t texel) {
  RealCoefficients real;
  real.polynomials = map.kind == MapKind::lrgb ? 1 : 3;
  append_texel(map, texel, real.coef);
  return real;
}

RealCoefficients real_polynomials(const PtmMap& map) {
  RealCoefficients real;
  real.polynomials = map.kind == MapKind::lrgb ? 1 : 3;
  real.coef.reserve(map.texels() * real.polynomials * 6);
  for (std::size_t texel = 0; texel < map.texels(); ++texel) append_texel(map, texel, real.coef);
  // A file's scale may take a coefficient past the largest double; no shift comes near either.
  for (double& a : real.coef) a = std::clamp(a, -1e300, 1e300);
  return real;
}

RealCoefficients rgb_polynomials(const PtmMap& map) {
  RealCoefficients real = real_polynomials(map);
  if (map.kind != MapKind::lrgb) return real;
  RealCoefficients rgb{3, {}};
  rgb.coef.reserve(map.texels() * 18);
  for (std::size_t texel = 0; texel < map.texels(); ++texel) {
    for (std::size_t c = 0; c < 3; ++c) {
      const double color = map.color[texel * 3 + c] / 255.0;
      for (std::size_t k = 0; k < 6; ++k) rgb.coef.push_back(real.coef[texel * 6 + k] * color);
    }
  }
  return rgb;
}

quantize::Import import_map(const PtmMap& map, const reference::EvalConfig& config) {
  if (map.kind == MapKind::lum) {
    return {std::nullopt, "a LUM map runs as an RGB map, whose coefficients are sums"};
  }
  return quantize::import_verbatim(
      {map.width, map.height, static_cast<int>(map.polynomials()), map.coef, map.scale, map.bias},
      config);
}

std::vector<std::array<double, 2>> hemisphere_lights() {
  constexpr int count = 256;
  std::vector<std::array<double, 2>> lights;
  for (int n = 0; n < count; ++n) {
    const double w = static_cast<double>(n) / (count - 1), r = std::sqrt(1 - w * w);
    const double angle = n * std::numbers::pi * (3 - std::sqrt(5.0));
    lights.push_back({r * std::cos(angle), r * std::sin(angle)});
  }
  return lights;
}

QuantizerInput quantizer_input(const PtmMap& map, const reference::EvalConfig& config) {
  QuantizerInput input{real_polynomials(map), {}, {}};
  if (map.kind != MapKind::lrgb) return input;
  input.color = map.color;
  input.balance =
      quantize::balance_luminance(input.real.coef, input.color, hemisphere_lights(), config);
  return input;
}

std::string beyond_hardware(double rms_error) {
  constexpr double levels = 255;
  if (rms_error <= levels) return {};
  return "coefficients that are not in the hardware's range: the nearest that it holds change the "
         "luminance by " +
         golden::count_of(golden::four_digits(rms_error), "level") + " RMS";
}

void require_held(double rms_error, const std::string& file) {
  const std::string change = beyond_hardware(rms_error);
  if (change.empty()) return;
  throw golden::InputError(file, "scales", change, "a change of at most 255, a picture's range");
}

HardwareMap store_map(const PtmMap& map, const reference::EvalConfig& config,
                      quantize::Method method, const std::string& file) {
  HardwareMap hardware;
  StoredTexture& texture = hardware.texture;
  texture.width = map.width;
  texture.height = map.height;
  texture.rgb = map.kind != MapKind::lrgb;
  quantize::Import import = import_map(map, config);
  if (import.map) {
    if (!texture.rgb) texture.color = map.color;
    take_integers(texture, std::move(*import.map));
    hardware.how = "imported verbatim: the file's integers are the hardware's";
    return hardware;
  }
  QuantizerInput input = quantizer_input(map, config);
  quantize::StoredMap stored = quantize::quantize(
      {map.width, map.height, static_cast<int>(input.real.polynomials), input.real.coef}, config,
      method, quantize::hemisphere_gram());
  require_held(stored.rms_error, file);
  hardware.origin = stored.origin;
  hardware.how = describe(stored, input.balance, import.why_not);
  texture.color = std::move(input.color);
  take_integers(texture, std::move(stored));
  return hardware;
}

golden::PtmMap to_ptm(const quantize::StoredMap& stored, golden::MapKind kind,
                      std::vector<std::uint8_t> color) {
  golden::PtmMap map;
  map.kind = kind;
  map.width = stored.width;
  map.height = stored.height;
  for (std::size_t i = 0; i < quantize::kSix; ++i) {
    map.scale[i] = std::ldexp(1.0, -stored.shift[i]);
    map.bias[i] = stored.bias[i];
  }
  map.coef.resize(stored.coef.size());
  std::transform(stored.coef.begin(), stored.coef.end(), map.coef.begin(), [](std::uint16_t c) {
    if (c > 255) throw std::invalid_argument("a .ptm holds coefficients of 8 bits");
    return static_cast<std::uint8_t>(c);
  });
  map.color = std::move(color);
  return map;
}

}  // namespace ptm::testbench
