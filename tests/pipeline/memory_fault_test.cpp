// Memories that never answer, or answer with a wrong tag: a result with cycle and fragment.
#include <gtest/gtest.h>

#include <optional>
#include <sstream>
#include <string>

#include "model/pipeline/simulate_texture_unit.h"
#include "tests/pipeline/unit_plane.h"

namespace ptm::pipeline {
namespace {

using Plane = tests::UnitPlane;

UnitFrameResult simulate(const Plane& plane, const MemoryFault& fault) {
  reference::UnitState state;
  state.draws = plane.draws;
  std::optional<UnitFrameResult> out;
  UnitSimulation simulation;
  simulation.state = &state;
  simulation.fault = fault;
  simulation.frames = {1, [&](std::size_t) { return UnitFrame{plane.fragments}; },
                       [&](std::size_t, UnitFrameResult&& result) { out = std::move(result); }};
  simulate_texture_unit(simulation);
  return std::move(out.value());
}

TEST(MemoryFaults, NameCycleFragmentAndLineWhenALineNeverComes) {
  const Plane plane(16);
  const auto result = simulate(plane, {MemoryFault::Kind::never, 3});
  ASSERT_TRUE(result.fault);
  EXPECT_LT(result.taken.size(), plane.fragments.size());
  const std::size_t waiting = result.taken.size();
  const auto& f = plane.fragments[waiting];
  std::ostringstream place;
  place << '(' << f.x << ", " << f.y << ')';
  EXPECT_NE(result.fault->what.find(place.str()), std::string::npos) << result.fault->what;
  EXPECT_NE(result.fault->what.find("request 3"), std::string::npos);
  EXPECT_NE(result.fault->what.find(std::to_string(result.fault->cycle)), std::string::npos);
  EXPECT_GE(result.fault->cycle, kPatience);
  EXPECT_LT(result.fault->cycle, kPatience + 1000);
  EXPECT_EQ(result.answered[3], kNever);
}

TEST(MemoryFaults, EndTheRunInTheCycleOfAResponseWithAWrongTag) {
  const Plane plane(16);
  const auto result = simulate(plane, {MemoryFault::Kind::wrong_tag, 2});
  ASSERT_TRUE(result.fault);
  EXPECT_EQ(result.fault->cycle, result.answered[2]);
  EXPECT_NE(result.fault->what.find("tag that is not outstanding"), std::string::npos);
  EXPECT_TRUE(result.taken.empty()) << "the first fragment waits for that line";
}

TEST(MemoryFaults, ThatNeverHappenChangeNothing) {
  const auto result = simulate(Plane(8), {MemoryFault::Kind::never, 100000});
  EXPECT_FALSE(result.fault);
  EXPECT_EQ(result.taken.size(), 64U);
}

}  // namespace
}  // namespace ptm::pipeline
