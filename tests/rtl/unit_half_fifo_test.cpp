// Half-vectors wait beside the pipeline for their fragments: docs/spec/effects.md, Fragment.
#include "tests/rtl/half_vector_world.h"
#include "tests/rtl/unit_runs.h"

namespace ptm::tests {
namespace {

std::vector<testbench::RtlUnitVariant> half_vector_variants() {
  std::vector<testbench::RtlUnitVariant> out;
  for (const auto& variant : unit_variants()) {
    if (variant.unit.half_vector) out.push_back(variant);
  }
  return out;
}

class RtlUnitHalfVectors : public testing::TestWithParam<testbench::RtlUnitVariant> {};

/// Blocked, the unit fills to the last place, half-vectors too: the fragment FIFO and a fragment in
/// every register from A0 to O hold one each. Every pixel then has its own.
TEST_P(RtlUnitHalfVectors, StayWithTheirFragmentsWhenTheBlockedUnitIsFull) {
  const auto fifo = static_cast<std::size_t>(GetParam().unit.fragment_fifo);
  const SmallWorld world = make_half_vector_world(GetParam(), 2 * fifo + 100);
  const auto unit = GetParam().make();
  unit->load(world.state);
  unit->write(0x1000, 3);
  const Drive drive = half_vector_drive(GetParam());
  const DrivenFrame frame = drive_frame(*unit, world.state, world.fragments, 64, drive);
  UnitScene scene;
  scene.config = GetParam().config;
  scene.unit = GetParam().unit;
  scene.state = world.state;
  expect_pixels(scene, world.fragments, frame.pixels);
  const auto blocked = static_cast<std::size_t>(std::ranges::count_if(
      frame.accepted, [&](std::uint64_t cycle) { return cycle < drive.blocked; }));
  EXPECT_LT(blocked, world.fragments.size());
  EXPECT_GT(blocked, fifo + 14);  // A0 to A3, T, K, F, D, Q, P, L1, L2, L3, O, and more behind them
  EXPECT_EQ(unit->counters()[UnitCounter::beats], world.fragments.size());
  // With the half-vector of the one behind it a pixel is another, more often than not.
  auto shifted = world.fragments;
  for (std::size_t n = 0; n + 1 < shifted.size(); ++n) {
    shifted[n].hu = world.fragments[n + 1].hu;
    shifted[n].hv = world.fragments[n + 1].hv;
  }
  std::vector<reference::UnitPixel> others(shifted.size());
  shade_all(scene.config, scene.state, shifted, others);
  std::size_t differ = 0;
  for (std::size_t n = 0; n < others.size(); ++n) differ += others[n] != frame.pixels[n];
  EXPECT_GT(differ, others.size() / 2);
}

INSTANTIATE_TEST_SUITE_P(Units, RtlUnitHalfVectors, testing::ValuesIn(half_vector_variants()),
                         [](const auto& tested) { return std::string(tested.param.name); });

}  // namespace
}  // namespace ptm::tests
