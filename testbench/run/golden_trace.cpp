#include "testbench/run/golden_trace.h"

#include <array>
#include <sstream>

#include "golden/render/light_map.h"
#include "testbench/run/hardware_map.h"

namespace ptm::testbench {
namespace {

using golden::Coefficients;

constexpr std::array<const char*, 3> kChannels{"r", "g", "b"};

class Printed {
 public:
  void add(const std::string& name, double value) {
    std::ostringstream text;
    text.precision(10);
    text << value;
    list_.push_back({name, text.str()});
  }
  std::vector<NamedValue> take() { return std::move(list_); }

 private:
  std::vector<NamedValue> list_;
};

/// Adds one polynomial's values and returns its luminance.
double add_polynomial(Printed& printed, const std::string& prefix, const Coefficients& a, double u,
                      double v) {
  const std::array<double, 6> factor{u * u, v * v, u * v, u, v, 1};
  for (std::size_t i = 0; i < 6; ++i) printed.add(prefix + "d" + std::to_string(i), a[i]);
  printed.add(prefix + "uu", factor[0]);
  printed.add(prefix + "vv", factor[1]);
  printed.add(prefix + "uv", factor[2]);
  for (const char* name : {"p", "t"}) {
    for (std::size_t i = 0; i < 6; ++i) {
      printed.add(prefix + name + std::to_string(i), a[i] * factor[i]);
    }
  }
  const double l = golden::luminance(a, u, v);
  printed.add(prefix + "acc", l);
  printed.add(prefix + "lum", l);
  return l;
}

}  // namespace

std::vector<NamedValue> golden_values(const golden::PtmMap& map, std::size_t texel,
                                      const golden::Light& light) {
  Printed printed;
  if (map.kind == golden::MapKind::lrgb) {
    for (std::size_t c = 0; c < 3; ++c) {
      printed.add(std::string("color_") + kChannels[c], map.color[texel * 3 + c]);
    }
  }
  printed.add("lu", light.u);
  printed.add("lv", light.v);
  if (map.kind == golden::MapKind::lrgb) {
    const double l =
        add_polynomial(printed, "", golden::real_coefficients(map, texel), light.u, light.v);
    for (std::size_t c = 0; c < 3; ++c) {
      printed.add(std::string("product_") + kChannels[c], l * map.color[texel * 3 + c]);
    }
  } else {
    const RealCoefficients real = real_polynomials(map, texel);
    for (std::size_t c = 0; c < 3; ++c) {
      Coefficients a{};
      for (std::size_t k = 0; k < 6; ++k) a[k] = real.coef[c * 6 + k];
      add_polynomial(printed, std::string(kChannels[c]) + ".", a, light.u, light.v);
    }
  }
  const golden::Rgb color = golden::light_texel(map, texel, light.u, light.v);
  for (std::size_t c = 0; c < 3; ++c) {
    printed.add(std::string("out_") + kChannels[c], color[c]);
  }
  return printed.take();
}

}  // namespace ptm::testbench
