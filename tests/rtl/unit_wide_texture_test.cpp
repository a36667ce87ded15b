// Textures of 2,048 and 4,096 texels a side: the highest bits of coordinates, of texels' and of
// lines' numbers, in every wrap and filter.
#include "tests/rtl/drive_frame.h"
#include "tests/rtl/pin_frame.h"
#include "tests/rtl/unit_runs.h"
#include "tests/rtl/wide_texture.h"

namespace ptm::tests {
namespace {

std::vector<WideTexture> wide_textures() {
  std::vector<WideTexture> all;
  for (const auto& [width, height] : {std::pair{4096, 4096}, {2048, 4096}, {4096, 2048}}) {
    for (const auto wrap :
         {reference::Wrap::repeat, reference::Wrap::mirror, reference::Wrap::clamp}) {
      for (const bool bilinear : {true, false}) all.push_back({width, height, wrap, bilinear});
    }
  }
  return all;
}

class RtlUnitWideTexture : public testing::TestWithParam<WideTexture> {};

/// Pixels are the reference's, and lie within their two roundings (by half a level each, across and
/// down) of the mixture of the texels between which the endless row has them. A mirrored coordinate
/// is inverted, which moves it by a part in 2^20, a 256th of a texel of 4,096: by 255/256 of a
/// level.
TEST_P(RtlUnitWideTexture, HasTheTexelsOfTheEndlessRow) {
  const WideTexture& texture = GetParam();
  const testbench::RtlUnitVariant variant = unit_variants().back();
  const auto unit = variant.make();
  UnitScene scene;
  scene.config = variant.config;
  scene.state = wide_state(texture);
  const auto fragments = wide_fragments(texture, 150);
  unit->reset(true);
  (void)unit->cycle({});
  write_registers(*unit, scene.state);
  unit->write(0x1000, 3);
  const unsigned slots = static_cast<unsigned>(variant.unit.miss_fifo);
  const DrivenFrame frame = drive_frame(*unit, scene.state, fragments, slots, {.latency_max = 4});
  expect_pixels(scene, fragments, frame.pixels);
  const bool mirrored = texture.wrap == reference::Wrap::mirror && texture.bilinear;
  const double bound = texture.bilinear ? (mirrored ? 1 + 2 * 255.0 / 256 : 1) : 0;
  std::size_t last = 0;
  for (std::size_t n = 0; n < frame.pixels.size(); ++n) {
    EXPECT_LE(wide_error(texture, fragments[n], frame.pixels[n]), bound) << describe(fragments[n]);
    last += endless_place(texture, fragments[n].u, texture.width).second == texture.width - 1;
  }
  EXPECT_GT(last, 10U) << "fragments at the last column";
}

INSTANTIATE_TEST_SUITE_P(Textures, RtlUnitWideTexture, testing::ValuesIn(wide_textures()),
                         [](const auto& tested) { return name_of(tested.param); });

}  // namespace
}  // namespace ptm::tests
