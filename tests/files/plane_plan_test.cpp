#include "golden/files/plane_plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace ptm::golden {
namespace {

constexpr int side = 64;

template <class Value>
Plane plane_of(Value value) {
  Plane plane(side * side);
  for (std::size_t i = 0; i < plane.bytes().size(); ++i) {
    plane.bytes()[i] = static_cast<std::uint8_t>(value(i));
  }
  return plane;
}

std::vector<int> noise(int low, int high, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<int> values(side * side);
  for (int& value : values) value = low + static_cast<int>(random() % unsigned(high - low + 1));
  return values;
}

TEST(PlanePlan, EqualPlanesBuildOnOneAnother) {
  const std::vector<int> base = noise(60, 190, 1);
  std::vector<Plane> planes;
  for (int copy = 0; copy < 3; ++copy) planes.push_back(plane_of([&](auto i) { return base[i]; }));
  const PlanePlan plan = plan_planes(planes, side, side, Differences::clamped, true);
  EXPECT_EQ(std::count(plan.references.begin(), plan.references.end(), -1), 1);
  EXPECT_EQ(plan.transforms, (std::vector<int>{0, 0, 0}));
}

TEST(PlanePlan, OppositePlanesAreInvertedWhereThatIsAllowed) {
  const std::vector<int> base = noise(60, 190, 1);
  std::vector<Plane> planes;
  planes.push_back(plane_of([&](auto i) { return base[i]; }));
  planes.push_back(plane_of([&](auto i) { return 255 - base[i]; }));
  const PlanePlan with = plan_planes(planes, side, side, Differences::clamped, true);
  EXPECT_EQ(std::count(with.transforms.begin(), with.transforms.end(), 1), 1);
  const PlanePlan without = plan_planes(planes, side, side, Differences::clamped, false);
  EXPECT_EQ(without.references, (std::vector<int>{-1, -1}));
}

TEST(PlanePlan, UnrelatedNoiseStandsAlone) {
  std::vector<Plane> planes;
  for (unsigned seed = 0; seed < 4; ++seed) {
    const std::vector<int> values = noise(100, 115, seed);
    planes.push_back(plane_of([&](auto i) { return values[i]; }));
  }
  const PlanePlan plan = plan_planes(planes, side, side, Differences::wrapped, true);
  EXPECT_EQ(plan.references, (std::vector<int>{-1, -1, -1, -1}));
}

TEST(PlanePlan, DifferencesThatWouldNotFitAreTakenModuloOnly) {
  // Plane 1 is plane 0 plus 160 modulo 256: one byte's difference, but never within -128..127.
  const std::vector<int> base = noise(0, 95, 3);
  std::vector<Plane> planes;
  planes.push_back(plane_of([&](auto i) { return base[i]; }));
  planes.push_back(plane_of([&](auto i) { return base[i] + 160; }));
  const PlanePlan wrapped = plan_planes(planes, side, side, Differences::wrapped, false);
  EXPECT_EQ(std::count(wrapped.references.begin(), wrapped.references.end(), -1), 1);
  const PlanePlan clamped = plan_planes(planes, side, side, Differences::clamped, false);
  EXPECT_EQ(clamped.references, (std::vector<int>{-1, -1}));
}

TEST(PlanePlan, EveryReferenceComesBeforeItsPlane) {
  std::vector<Plane> planes;
  for (unsigned p = 0; p < 18; ++p) {
    const std::vector<int> base = noise(60, 190, p % 5), own = noise(0, static_cast<int>(p), p);
    planes.push_back(plane_of([&](auto i) { return base[i] + own[i]; }));
  }
  const PlanePlan plan = plan_planes(planes, side, side, Differences::wrapped, true);
  std::vector<int> sorted = plan.order;
  std::sort(sorted.begin(), sorted.end());
  for (int i = 0; i < 18; ++i) EXPECT_EQ(sorted[static_cast<std::size_t>(i)], i);
  EXPECT_LE(std::count(plan.references.begin(), plan.references.end(), -1), 5);
  for (std::size_t p = 0; p < 18; ++p) {
    if (plan.references[p] < 0) continue;
    EXPECT_LT(plan.order[static_cast<std::size_t>(plan.references[p])], plan.order[p]);
  }
}

}  // namespace
}  // namespace ptm::golden
