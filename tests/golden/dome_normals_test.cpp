// Normals out of a fitted map against the true ones of a rendered capture.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "golden/effects/map_normals.h"
#include "golden/files/picture_file.h"
#include "tests/shared_data.h"

namespace ptm::golden {
namespace {

struct Angles {
  std::vector<double> degrees;
  [[nodiscard]] double mean() const {
    double sum = 0;
    for (const double d : degrees) sum += d;
    return sum / static_cast<double>(degrees.size());
  }
  [[nodiscard]] double median() {
    const auto middle = degrees.begin() + static_cast<std::ptrdiff_t>(degrees.size() / 2);
    std::nth_element(degrees.begin(), middle, degrees.end());
    return *middle;
  }
};

double angle_between(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  const double dot = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  return std::acos(std::clamp(dot, -1.0, 1.0)) * 180 / std::numbers::pi;
}

std::array<double, 3> on_the_rim(const Peak& peak) { return {peak.light[0], peak.light[1], 0}; }

TEST(DomeNormals, AreOffByLessThan21DegreesOnAverageAndBetterThanTheRim) {
  PTM_SHARED_DATA_OR_SKIP(lp, "dome/Dome/dirs.lp");
  UnitScene scene;
  TextureSpec& spec = scene.textures.emplace_back();
  spec.name = "dome";
  spec.source = TextureSource::capture;
  spec.file = lp;
  const LoadedTexture map = load_textures(scene)[0];
  const ImageReal truth = read_picture(lp.parent_path() / "normals.png");
  const ImageReal mask = read_picture(lp.parent_path() / "mask.png");
  ASSERT_EQ(truth.samples.size(), map.texels() * 3);
  const MapNormals normals = map_normals(map);
  Angles all, inside, without, rim;
  const auto channels = static_cast<std::size_t>(mask.channels);
  for (std::size_t t = 0; t < map.texels(); ++t) {
    std::array<double, 3> n{};
    for (std::size_t c = 0; c < 3; ++c) n[c] = 2 * truth.samples[t * 3 + c] / 255 - 1;
    const double length = std::hypot(n[0], n[1], n[2]);
    if (mask.samples[t * channels] < 128 || length < 0.5) continue;
    for (double& part : n) part /= length;
    const Peak peak = brightest_light(luma_polynomial(map, t));
    const double angle = angle_between(n, normals.field.normals[t]);
    all.degrees.push_back(angle);
    if (peak.kind == PeakKind::inside) {
      inside.degrees.push_back(angle);
    } else {
      without.degrees.push_back(angle);
      rim.degrees.push_back(angle_between(n, on_the_rim(peak)));
    }
  }
  std::printf(
      "dome, %zu texels of the mask: mean %.2f, median %.2f degrees\n"
      "  %zu with a maximum inside: %.2f, %.2f\n"
      "  %zu without: %.2f, %.2f by value and slope at the zenith; %.2f, %.2f by the rim\n",
      all.degrees.size(), all.mean(), all.median(), inside.degrees.size(), inside.mean(),
      inside.median(), without.degrees.size(), without.mean(), without.median(), rim.mean(),
      rim.median());
  EXPECT_GT(all.degrees.size(), 50000U);
  EXPECT_LT(all.mean(), 21);
  EXPECT_LT(without.mean(), rim.mean() / 2);
}

}  // namespace
}  // namespace ptm::golden
