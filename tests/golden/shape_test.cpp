#include "golden/scene/shape.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "golden/scene/noise.h"

namespace ptm::golden {
namespace {

constexpr double kPi = std::numbers::pi;

std::vector<Shape> shapes() {
  Shape plane = whole_shape(ShapeKind::plane);
  plane.origin = Vec3(1, 2, 3);
  plane.axis_i = Vec3(2, 0.5, 0);
  plane.axis_j = Vec3(0.3, 1, -1);
  plane.p_range = {-1, 3};
  Shape cylinder = whole_shape(ShapeKind::cylinder, 3);
  cylinder.radius = 2;
  cylinder.a = 1.5;
  cylinder.p0 = 0.4;
  cylinder.q_range = {0.5, 2.5};
  Shape sphere = whole_shape(ShapeKind::sphere);
  sphere.origin = Vec3(-1, 0.5, 2);
  sphere.radius = 1.5;
  sphere.a = -2;
  sphere.b = 3;
  sphere.q0 = 0.2;
  sphere.p_range = {-1, 4};
  sphere.q_range = {0.3, 2.8};
  return {plane, cylinder, sphere};
}

/// A place in the part that the ranges leave, the same for the same n.
std::array<double, 2> place(const Shape& shape, int n) {
  const auto within = [&](const std::array<double, 2>& range, int which) {
    return range[0] + (range[1] - range[0]) * hash_noise(5, n, which);
  };
  return {within(shape.p_range, 0), within(shape.q_range, 1)};
}

TEST(Shape, FollowsTheSlidesFormulas) {
  const double theta = 1.1, phi = 0.7, z = 0.4;
  Shape sphere = whole_shape(ShapeKind::sphere);
  SurfacePoint point = point_at(sphere, theta, phi);
  EXPECT_TRUE(point.position.isApprox(
      Vec3(std::cos(theta) * std::sin(phi), std::sin(theta) * std::sin(phi), std::cos(phi))));
  EXPECT_DOUBLE_EQ(point.u, theta / (2 * kPi));
  EXPECT_DOUBLE_EQ(point.v, phi / kPi);
  Shape cylinder = whole_shape(ShapeKind::cylinder, 2);
  cylinder.origin = Vec3(0, 0, 0);
  cylinder.b = 1;
  cylinder.q0 = 0;
  point = point_at(cylinder, theta, z);
  EXPECT_TRUE(point.position.isApprox(Vec3(std::cos(theta), std::sin(theta), z)));
  EXPECT_DOUBLE_EQ(point.v, z / 2);
  cylinder.a = 3;
  cylinder.b = -2;
  cylinder.p0 = 0.5;
  cylinder.q0 = 0.25;
  point = point_at(cylinder, theta, z);
  EXPECT_DOUBLE_EQ(point.u, 3 * (theta - 0.5) / (2 * kPi));
  EXPECT_DOUBLE_EQ(point.v, -2 * (z - 0.25) / 2);
  Shape plane = whole_shape(ShapeKind::plane);
  point = point_at(plane, 0.25, 0.75);
  EXPECT_TRUE(point.position.isApprox(plane.origin + 0.25 * plane.axis_i + 0.75 * plane.axis_j));
  EXPECT_EQ(point.u, 0.25);
  EXPECT_EQ(point.v, 0.75);
}

TEST(Shape, IsHitWhereItsParametersSay) {
  for (const Shape& shape : shapes()) {
    for (int n = 0; n < 2000; ++n) {
      const auto [p, q] = place(shape, n);
      const SurfacePoint point = point_at(shape, p, q);
      // From just outside, so that nothing else of the surface lies between.
      const Vec3 slant(hash_noise(5, n, 2) - 0.5, hash_noise(5, n, 3) - 0.5, 0);
      const Vec3 from = point.position + 0.01 * (point.normal + 0.5 * slant);
      const auto hit = intersect(shape, {from, point.position - from});
      ASSERT_TRUE(hit) << p << " " << q;
      EXPECT_NEAR(hit->t, 1, 1e-10);
      EXPECT_NEAR(hit->p, p, 1e-10);
      EXPECT_NEAR(hit->q, q, 1e-10);
    }
  }
}

TEST(Shape, HasTheGradientsAndDirectionsOfFiniteDifferences) {
  constexpr double step = 1e-6;
  for (const Shape& shape : shapes()) {
    for (int n = 0; n < 200; ++n) {
      const auto [p, q] = place(shape, n);
      const SurfacePoint here = point_at(shape, p, q);
      for (const auto& [dp, dq] : {std::pair{step, 0.0}, {0.0, step}}) {
        const SurfacePoint a = point_at(shape, p - dp, q - dq), b = point_at(shape, p + dp, q + dq);
        const Vec3 moved = b.position - a.position;
        EXPECT_NEAR(here.gradient_u.dot(moved), b.u - a.u, 1e-10);
        EXPECT_NEAR(here.gradient_v.dot(moved), b.v - a.v, 1e-10);
        EXPECT_NEAR(here.normal.dot(moved), 0, 1e-10);
        const bool u_moves = b.u != a.u;
        const Vec3 along = (u_moves ? here.along_u : here.along_v).normalized();
        const double sign = (u_moves ? b.u - a.u : b.v - a.v) > 0 ? 1 : -1;
        EXPECT_NEAR((sign * moved.normalized() - along).norm(), 0, 1e-8);
      }
    }
  }
}

TEST(Shape, OfASphereHasAFrameAndFiniteGradientsAtItsPoles) {
  const Shape sphere = whole_shape(ShapeKind::sphere);
  for (const double phi : {0.0, kPi}) {
    const SurfacePoint pole = point_at(sphere, 1, phi);
    EXPECT_NEAR(pole.along_u.norm(), 1, 1e-12);
    EXPECT_NEAR(pole.along_u.dot(pole.normal), 0, 1e-12);
    EXPECT_LE(pole.gradient_u.norm(), 1 / (2 * kPi * kPoleSine) * (1 + 1e-9));
    const Vec3 from = pole.position * 3;
    const auto hit = intersect(sphere, {from, -from});
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->q, phi, 1e-9);
  }
}

TEST(Shape, OfPartsIsSeenFromInsideThroughWhatIsMissing) {
  Shape half = whole_shape(ShapeKind::cylinder, 2);
  half.p_range = {0, kPi};  // y >= 0
  const auto hit = intersect(half, {Vec3(0.1, -5, 0), Vec3(0, 1, 0)});
  ASSERT_TRUE(hit) << "the near half is cut away, the far one is not";
  EXPECT_NEAR(hit->t, 5 + std::sqrt(1 - 0.01), 1e-12);
  EXPECT_FALSE(intersect(half, {Vec3(0.1, -5, 1.01), Vec3(0, 1, 0)})) << "above its height";
  EXPECT_FALSE(intersect(half, {Vec3(0.1, 5, 0), Vec3(0, 1, 0)})) << "behind the ray";
}

TEST(Shape, TurnsAnglesIntoATurnThatBeginsAnywhere) {
  for (const double from : {-7.0, -kPi, 0.0, 1.0, 100.0}) {
    for (int n = -50; n <= 50; ++n) {
      const double angle = 0.37 * n, turned = turned_to(angle, from);
      EXPECT_GE(turned, from);
      EXPECT_LT(turned, from + 2 * kPi);
      EXPECT_NEAR(std::remainder(turned - angle, 2 * kPi), 0, 1e-12);
    }
  }
}

}  // namespace
}  // namespace ptm::golden
