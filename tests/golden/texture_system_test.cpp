// Golden's filters against OpenImageIO's TextureSystem, which knows nothing of them.
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/texture.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <memory>
#include <string>

#include "golden/render/texture_filter.h"
#include "golden/scene/noise.h"

namespace ptm::golden {
namespace {

/// OpenImageIO computes in single precision. All coordinates here are multiples of 2^-12 and all
/// sides below 2^12, so positions, indices and weights are exact in it; what remains is rounding of
/// at most 24 products and sums of values up to 255, 2^-24 of each.
constexpr double kBound = 24 * 255 * 0x1p-24;  // 3.6e-4 levels

LoadedTexture noise_picture(int width, int height) {
  LoadedTexture texture;
  texture.polynomials = 0;
  texture.width = width;
  texture.height = height;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      for (int c = 0; c < 4; ++c) {
        texture.rgba.push_back(std::floor(256 * hash_noise(7, x, y, c)));
      }
    }
  }
  return texture;
}

class TextureSystem : public testing::Test {
 protected:
  void TearDown() override {
    if (system_) OIIO::TextureSystem::destroy(system_);
    std::error_code ignored;
    std::filesystem::remove(file_, ignored);
  }

  /// Writes the texture, with levels made by OpenImageIO itself, samples in single precision.
  void open(const LoadedTexture& texture) {
    const std::string name =
        testing::UnitTest::GetInstance()->current_test_info()->name() + std::to_string(getpid());
    file_ = std::filesystem::path(testing::TempDir()) / (name + ".tx");
    OIIO::ImageBuf picture(
        OIIO::ImageSpec(texture.width, texture.height, 4, OIIO::TypeDesc::FLOAT));
    ASSERT_TRUE(picture.set_pixels(OIIO::ROI::All(), OIIO::TypeDesc::DOUBLE, texture.rgba.data()));
    OIIO::ImageSpec how;
    how.set_format(OIIO::TypeDesc::FLOAT);
    how.attribute("maketx:filtername", "box");
    ASSERT_TRUE(OIIO::ImageBufAlgo::make_texture(OIIO::ImageBufAlgo::MakeTxTexture, picture,
                                                 file_.string(), how));
    system_ = OIIO::TextureSystem::create(false);
  }

  /// d: the filter's width in texels of level 0, along both sides.
  Rgba ask(double u, double v, OIIO::TextureOpt& options, double ds, double dt) {
    options.interpmode = OIIO::TextureOpt::InterpBilinear;
    std::array<float, 4> result{};
    EXPECT_TRUE(system_->texture(OIIO::ustring(file_.string()), options, static_cast<float>(u),
                                 static_cast<float>(v), static_cast<float>(ds), 0, 0,
                                 static_cast<float>(dt), 4, result.data()))
        << system_->geterror();
    return {result[0], result[1], result[2], result[3]};
  }

  OIIO::TextureSystem* system_ = nullptr;
  std::filesystem::path file_;
};

void expect_near(const Rgba& ours, const Rgba& theirs, const std::string& where) {
  for (std::size_t c = 0; c < 4; ++c) ASSERT_NEAR(ours[c], theirs[c], kBound) << where;
}

/// A multiple of 2^-12 between -2 and 3, the same for the same n.
double coordinate(int n, int which) {
  return std::floor(hash_noise(11, n, which) * 5 * 4096) / 4096 - 2;
}

constexpr std::array<std::pair<WrapMode, OIIO::TextureOpt::Wrap>, 3> kWraps{
    {{WrapMode::repeat, OIIO::TextureOpt::WrapPeriodic},
     {WrapMode::mirror, OIIO::TextureOpt::WrapMirror},
     {WrapMode::clamp, OIIO::TextureOpt::WrapClamp}}};

TEST_F(TextureSystem, AgreesWithBilinearFilteringUnderEveryPairOfWraps) {
  const LoadedTexture texture = noise_picture(48, 25);
  open(texture);
  const MipTexture mips(texture, false);
  for (const auto& [wrap_u, their_u] : kWraps) {
    for (const auto& [wrap_v, their_v] : kWraps) {
      for (int n = 0; n < 2000; ++n) {
        const double u = coordinate(n, 0), v = coordinate(n, 1);
        OIIO::TextureOpt options;
        options.mipmode = OIIO::TextureOpt::MipModeNoMIP;
        options.swrap = their_u;
        options.twrap = their_v;
        const Rgba ours =
            filter_texture(mips, {.u = u, .v = v, .wrap_u = wrap_u, .wrap_v = wrap_v});
        expect_near(ours, ask(u, v, options, 0, 0), std::to_string(u) + ", " + std::to_string(v));
        if (HasFatalFailure()) return;
      }
    }
  }
}

/// OpenImageIO mixes levels l and l + 1 linearly in the filter's width d, weight d / 2^l - 1, and
/// golden linearly in log2 d, as mip-mapping is taught and hardware does it. Both mix the same two
/// levels; so it is asked with the width d = 2^l (1 + f) at which its weight is golden's f.
TEST_F(TextureSystem, AgreesWithTrilinearFilteringAtEveryLevelAndMix) {
  const LoadedTexture texture = noise_picture(64, 64);
  open(texture);
  const MipTexture mips(texture, true);
  ASSERT_EQ(mips.levels(), 7);
  for (const auto& [wrap, theirs] : kWraps) {
    for (int n = 0; n < 4000; ++n) {
      const double u = coordinate(n, 0), v = coordinate(n, 1);
      const int level = n % 6;
      const double f = std::floor(256 * hash_noise(3, n, 5)) / 256;
      const double width = std::ldexp(1 + f, level) / 64;
      OIIO::TextureOpt options;
      options.mipmode = OIIO::TextureOpt::MipModeTrilinear;
      options.swrap = options.twrap = theirs;
      const Rgba ours = filter_texture(mips, {.u = u,
                                              .v = v,
                                              .lod = level + f,
                                              .filter = {true, MipMode::linear},
                                              .wrap_u = wrap,
                                              .wrap_v = wrap});
      expect_near(
          ours, ask(u, v, options, width, width),
          std::to_string(u) + ", " + std::to_string(v) + " lod " + std::to_string(level + f));
      if (HasFatalFailure()) return;
    }
  }
}

}  // namespace
}  // namespace ptm::golden
