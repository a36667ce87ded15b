#include "golden/geometry/direction.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>

#include "golden/files/light_directions.h"
#include "golden/scene/camera.h"
#include "golden/scene/obj_file.h"
#include "golden/scene/placed_object.h"
#include "golden/scene/surface_samples.h"
#include "golden/scene/textures.h"
#include "golden/scene/unit_scene.h"
#include "tests/scratch_folder.h"

namespace ptm::golden {
namespace {

constexpr std::array kSizes{1e-310, 1e-300, 1e-200, 1e-160, 1e-30, 1.0, 1e30, 1e160, 1e200, 1e307};

TEST(Directions, AreOfLengthOneWhateverTheVectorsSize) {
  const Vec3 shape(0.48, -0.6, 0.64);
  for (const double size : kSizes) {
    const Vec3 v = size * shape;
    // Parts below 2^-1022 have fewer digits themselves.
    const double digits = size < 1e-300 ? 1e-12 : 4 * std::numeric_limits<double>::epsilon();
    EXPECT_NEAR(unit(v).norm(), 1, 4 * std::numeric_limits<double>::epsilon()) << size;
    EXPECT_NEAR((unit(v) - shape).norm(), 0, digits) << size;
    EXPECT_NEAR(length(v) / size, 1, digits) << size;
  }
  EXPECT_TRUE(unit(Vec3(0, 0, 0)).isZero(0));
  EXPECT_EQ(length(Vec3(0, 0, 0)), 0);
}

TEST(Directions, SpanAPlaneByTheirAngleAlone) {
  for (const double a : kSizes) {
    for (const double b : kSizes) {
      EXPECT_TRUE(span_a_plane(a * Vec3(1, 0, 0), b * Vec3(1, 1, 0), 1e-9)) << a << ", " << b;
      EXPECT_FALSE(span_a_plane(a * Vec3(1, 1, 0), b * Vec3(-1, -1, 0), 1e-9)) << a << ", " << b;
    }
  }
  EXPECT_FALSE(span_a_plane(Vec3(1, 0, 0), Vec3(0, 0, 0), 0));
}

TEST(Directions, OfLightsAreTakenFromVectorsOfEverySize) {
  for (const double size : kSizes) {
    LightDirections directions;
    std::vector<std::string> notes;
    std::array<double, 3> d{0.6 * size, 0, 0.8 * size};
    EXPECT_TRUE(directions.take(d, "file", "line 1", notes)) << size;
    EXPECT_NEAR(d[0], 0.6, 1e-12) << size;
    EXPECT_NEAR(d[2], 0.8, 1e-12) << size;
  }
}

class SizedScene : public testing::Test {
 protected:
  /// A plane of side `size`, seen square-on from `size` away.
  UnitScene scene(const std::string& size, const std::string& light) {
    const auto path = folder_ / "s.toml";
    std::ofstream(path) << "[image]\nsize = [4, 4]\n[camera]\nposition = [0, -" << size
                        << ", 0]\ntarget = [0, 0, 0]\nup = [0, 0, " << size
                        << "]\nfov_degrees = 50\n[[texture]]\nname = \"m\"\ngenerate = \"noise\"\n"
                        << "size = [8, 8]\n[[object]]\nkind = \"plane\"\ntexture = \"m\"\n"
                        << "origin = [0, 0, 0]\ns = [-0.5, 0.5]\nt = [-0.5, 0.5]\ni = [" << size
                        << ", 0, 0]\nj = [0, 0, -" << size << "]\n[[light]]\n"
                        << light << "\n";
    return read_unit_scene(path);
  }

  static std::vector<SurfaceSample> samples(const UnitScene& scene) {
    return make_samples(scene, load_textures(scene), 0);
  }

  tests::ScratchFolder folder_;
};

TEST(Directions, OfLightsLongerThanAnyDoubleAreTakenToo) {
  LightDirections directions;
  std::vector<std::string> notes;
  std::array<double, 3> d{1.7e308, 1.7e308, 1.7e308};
  EXPECT_TRUE(directions.take(d, "file", "line 1", notes));
  for (const double part : d) EXPECT_NEAR(part, 1 / std::sqrt(3.0), 1e-15);
}

TEST_F(SizedScene, IsSeenAlikeWhateverItsSize) {
  const auto usual = samples(scene("1", "direction = [0.3, -0.5, 0.2]"));
  ASSERT_EQ(usual.size(), 16U);
  for (const char* size : {"1e-199", "1e-160", "1e-155", "1e-80", "1e8"}) {
    const auto found = samples(scene(size, "direction = [0.3e-200, -0.5e-200, 0.2e-200]"));
    ASSERT_EQ(found.size(), usual.size()) << size;
    for (std::size_t n = 0; n < found.size(); ++n) {
      // A few roundings of numbers near 1 apart.
      constexpr double few = 64 * std::numeric_limits<double>::epsilon();
      EXPECT_NEAR(found[n].u, usual[n].u, few) << size;
      EXPECT_NEAR(found[n].v, usual[n].v, few) << size;
      EXPECT_NEAR(found[n].dudx, usual[n].dudx, few) << size;
      EXPECT_NEAR(found[n].dvdy, usual[n].dvdy, few) << size;
      EXPECT_NEAR(found[n].lod, usual[n].lod, 8 * few) << size;
      EXPECT_NEAR(found[n].light[0], usual[n].light[0], few) << size;
      EXPECT_NEAR(found[n].light[1], usual[n].light[1], few) << size;
      EXPECT_EQ(found[n].lit, usual[n].lit) << size;
    }
  }
}

TEST_F(SizedScene, FindsLampsThatAreNear) {
  const auto usual = samples(scene("1", "position = [0.25, -0.5, 0.125]"));
  const auto found = samples(scene("1e-180", "position = [0.25e-180, -0.5e-180, 0.125e-180]"));
  ASSERT_EQ(found.size(), usual.size());
  for (std::size_t n = 0; n < found.size(); ++n) {
    EXPECT_NEAR(found[n].light[0], usual[n].light[0], 1e-13);
    EXPECT_NEAR(found[n].light[1], usual[n].light[1], 1e-13);
    EXPECT_TRUE(found[n].lit);
  }
}

TEST_F(SizedScene, SaysWhichAxisIsTooShortAndWhichAreOnALine) {
  try {
    (void)scene("1e-300", "direction = [0, 0]");
    FAIL() << "1e-300 was taken";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("object[0].i"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("too short"), std::string::npos) << error.what();
  }
}

/// A mesh of one bent quad, all coordinates times `size`, its normals times `normal`.
std::filesystem::path write_obj(const tests::ScratchFolder& folder, double size, double normal) {
  auto path = folder / "m.obj";
  std::ofstream out(path);
  out.precision(17);
  for (const auto& [x, y, z] :
       {std::array{-1.0, 0.0, -1.0}, {1.0, 0.25, -1.0}, {1.0, 0.0, 2.0}, {-1.0, 0.25, 1.0}}) {
    out << "v " << x * size << ' ' << y * size << ' ' << z * size << "\nvt " << (x + 1) / 2 << ' '
        << (z + 1) / 2 << "\nvn " << x * normal << ' ' << -2 * normal << ' ' << z * normal << '\n';
  }
  out << "f 1/1/1 2/2/2 3/3/3 4/4/4\n";
  return path;
}

TEST(SizedMesh, IsHitAndShadedAlikeWhateverItsSize) {
  const tests::ScratchFolder folder;
  for (const MeshMapping mapping : {MeshMapping::own, MeshMapping::centroid}) {
    ObjectSpec spec;
    spec.mesh = true;
    spec.mapping = mapping;
    spec.shape = whole_shape(ShapeKind::sphere);
    spec.shape.radius = 1e9;  // beside which no mesh below has a size
    spec.file = write_obj(folder, 1, 1);
    const PlacedObject usual(spec);
    for (const double size : {1e-199, 1e-160, 1e-100, 0.01}) {
      spec.file = write_obj(folder, size, size < 1e-150 ? 1e-200 : 1e29);
      const PlacedObject sized(spec);
      for (const double x : {-0.7, -0.1, 0.3, 0.9}) {
        const Ray ray{{x, -3, 0.45}, {0, 1, 0}};
        const auto at_one = usual.intersect(ray);
        const auto hit = sized.intersect({size * ray.origin, ray.direction});
        ASSERT_TRUE(at_one && hit) << size;
        EXPECT_NEAR(hit->t / size, at_one->t, 1e-13) << size;
        const SurfacePoint p = usual.at(at_one->place), q = sized.at(hit->place);
        EXPECT_NEAR((p.normal - q.normal).norm(), 0, 1e-13) << size;
        EXPECT_NEAR((p.shading - q.shading).norm(), 0, 1e-13) << size;
        // The centroid's direction is the sphere's, but for the mesh's size beside its radius.
        EXPECT_NEAR(p.u, q.u, mapping == MeshMapping::own ? 1e-13 : 4e-9) << size;
        if (mapping != MeshMapping::own) continue;  // gradients are by differences
        EXPECT_NEAR((p.gradient_u - size * q.gradient_u).norm(), 0, 1e-13) << size;
        EXPECT_NEAR((unit(p.along_u) - unit(q.along_u)).norm(), 0, 1e-13) << size;
      }
    }
  }
}

TEST(SizedMesh, OfOneConcaveFaceCoversTheSameWhateverItsSize) {
  const tests::ScratchFolder folder;
  // A dart, its notch at (0, 0): (0.5, -0.5) is inside, (-0.5, 0) is in the notch.
  const auto covers = [&](double size, double x, double z) {
    ObjectSpec spec;
    spec.mesh = true;
    spec.mapping = MeshMapping::surface_normal;
    spec.shape = whole_shape(ShapeKind::plane);
    spec.file = folder / "dart.obj";
    std::ofstream out(spec.file);
    for (const auto& [a, b] : {std::array{-1.0, -1.0}, {2.0, 0.0}, {-1.0, 1.0}, {0.0, 0.0}}) {
      out << "v " << a * size << " 0 " << b * size << '\n';
    }
    out << "f 1 2 3 4\n";
    out.close();
    return PlacedObject(spec).intersect({size * Vec3(x, -3, z), {0, 1, 0}}).has_value();
  };
  for (const double size : {1e-199, 1e-160, 1.0, 1e29}) {
    EXPECT_TRUE(covers(size, 0.5, -0.25)) << size;
    EXPECT_TRUE(covers(size, 0.5, 0.25)) << size;
    EXPECT_TRUE(covers(size, -0.5, 0.6)) << size;
    EXPECT_FALSE(covers(size, -0.5, 0)) << size;
  }
}

}  // namespace
}  // namespace ptm::golden
