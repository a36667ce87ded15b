#pragma once
#include "tests/rtl/drive_frame.h"
#include "tests/rtl/small_scenes.h"

namespace ptm::tests {

/// Fragments of one beat each in a unit of that variant, whatever number of TMUs it has, and a draw
/// of which every pass but the map's is lit along the half-vector.
inline SmallWorld make_half_vector_world(const testbench::RtlUnitVariant& variant,
                                         std::size_t fragments) {
  const SmallScene scene{.name = "HalfVectors",
                         .format = reference::TextureFormat::palette_lrgb,
                         .bilinear = false,
                         .width = 4,
                         .height = 4};
  testbench::RtlUnitVariant plain = variant;
  plain.unit.extra_sets = 0;
  SmallWorld world = make_small_world(scene, plain, fragments);
  // Luminances that differ from each other, and a highlight that shows each
  world.state.draws[0].bias[5] = 0;
  world.state.tables = {reference::effect_table(1)};
  for (reference::UnitFragment& f : world.fragments) {
    f.hu /= 4;
    f.hv /= 4;
  }
  for (reference::ExtraPass& pass : world.state.draws[0].effects.pass) {
    pass = {0, &pass - world.state.draws[0].effects.pass.data() < variant.unit.extra_passes};
  }
  return world;
}

/// Pixels wait until as many fragments as fit are inside; then all of them leave.
inline Drive half_vector_drive(const testbench::RtlUnitVariant& variant) {
  return {.blocked = 200 + 20 * static_cast<std::uint64_t>(variant.unit.fragment_fifo),
          .latency_max = 5};
}

}  // namespace ptm::tests
