#include "golden/scene/mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "golden/scene/noise.h"
#include "golden/scene/two_stage.h"
#include "tests/golden/made_scene.h"

namespace ptm::golden {
namespace {

constexpr double kPi = std::numbers::pi;

class Obj : public MadeScene {
 protected:
  [[nodiscard]] ObjMesh obj(const std::string& text) const {
    return read_obj(write("mesh.obj", text));
  }
  [[nodiscard]] std::string obj_complaint(const std::string& text) const {
    return complaint_of([&] { (void)obj(text); });
  }
  [[nodiscard]] Mesh mesh(const std::string& text, ObjectSpec spec) const {
    spec.mesh = true;
    spec.file = write("mesh.obj", text);
    return Mesh(spec);
  }
};

const std::string kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST_F(Obj, ReadsCornersOfEveryForm) {
  const ObjMesh mesh = obj("# a comment\no thing\n" + kSquare +
                           "vt 0.5\nvt 0.25 0.75 0\nvn 0 0 2\ns off\r\n"
                           "f 1/2/1 2//1 \\\n  3/1\nf -4 -3/-1 -1//-1 # last\n");
  ASSERT_EQ(mesh.triangles.size(), 2U);
  const auto corner = [&](std::size_t t, std::size_t k) {
    const ObjCorner& c = mesh.triangles[t].corners[k];
    return std::array<int, 3>{c.position, c.texture, c.normal};
  };
  EXPECT_EQ(corner(0, 0), (std::array<int, 3>{0, 1, 0}));
  EXPECT_EQ(corner(0, 1), (std::array<int, 3>{1, -1, 0}));
  EXPECT_EQ(corner(0, 2), (std::array<int, 3>{2, 0, -1}));
  EXPECT_EQ(corner(1, 0), (std::array<int, 3>{0, -1, -1}));
  EXPECT_EQ(corner(1, 1), (std::array<int, 3>{1, 1, -1}));
  EXPECT_EQ(corner(1, 2), (std::array<int, 3>{3, -1, 0}));
  EXPECT_EQ(mesh.texcoords[0], (std::array<double, 2>{0.5, 0}));
}

double area_of(const ObjMesh& mesh) {
  double sum = 0;
  for (const ObjTriangle& t : mesh.triangles) {
    const auto at = [&](std::size_t k) {
      return mesh.positions[static_cast<std::size_t>(t.corners[k].position)];
    };
    sum += (at(1) - at(0)).cross(at(2) - at(0)).z() / 2;
  }
  return sum;
}

TEST_F(Obj, CutsAPolygonWithACornerOnASideAndDropsWhatHasNoArea) {
  const ObjMesh mesh = obj(kSquare + "v 0 0.5 0\nf 1 2 3 4 5\nf 1 1 2\nf 1 2 2\n");
  EXPECT_EQ(mesh.triangles.size(), 3U);
  EXPECT_DOUBLE_EQ(area_of(mesh), 1);
}

TEST_F(Obj, CutsAConcaveFaceInTheSameWayFromEveryCorner) {
  // A dart of area 3, whose corner at (1, 1) is reflex; below, a comb of three teeth.
  const std::string dart = "v 0 0 0\nv 3 0 0\nv 1 1 0\nv 0 0 0\nv 0 3 0\n";
  const std::array<std::string, 4> turns{"1 2 3 5", "2 3 5 1", "3 5 1 2", "5 1 2 3"};
  std::vector<std::array<int, 3>> first;
  for (const std::string& turn : turns) {
    const ObjMesh mesh = obj(dart + "f " + turn + "\n");
    EXPECT_DOUBLE_EQ(area_of(mesh), 3) << turn;
    std::vector<std::array<int, 3>> cut;
    for (const ObjTriangle& t : mesh.triangles) {
      // Nothing turns the other way, so nothing is covered twice.
      const auto at = [&](std::size_t k) {
        return mesh.positions[static_cast<std::size_t>(t.corners[k].position)];
      };
      EXPECT_GT((at(1) - at(0)).cross(at(2) - at(0)).z(), 0) << turn;
      cut.push_back({t.corners[0].position, t.corners[1].position, t.corners[2].position});
    }
    if (first.empty()) first = cut;
    EXPECT_EQ(cut, first) << turn;
  }
  const ObjMesh comb =
      obj("v 0 0 0\nv 5 0 0\nv 5 2 0\nv 4 0.5 0\nv 3 2 0\nv 2 0.5 0\nv 1 2 0\n"
          "f 3 4 5 6 7 1 2\n");
  EXPECT_EQ(comb.triangles.size(), 5U);
  double shoelace = 0;
  for (std::size_t i = 0; i < 7; ++i) {
    const Vec3 &p = comb.positions[i], &q = comb.positions[(i + 1) % 7];
    shoelace += (p.x() * q.y() - p.y() * q.x()) / 2;
  }
  EXPECT_NEAR(area_of(comb), shoelace, 1e-12);
  for (const ObjTriangle& t : comb.triangles) {
    const auto at = [&](std::size_t k) {
      return comb.positions[static_cast<std::size_t>(t.corners[k].position)];
    };
    EXPECT_GT((at(1) - at(0)).cross(at(2) - at(0)).z(), 0);
  }
}

TEST_F(Obj, ReadsWhatExportersWriteBesideTheMesh) {
  const ObjMesh mesh = obj("\xEF\xBB\xBF# a comment that ends in a backslash \\\n" + kSquare +
                           "bevel on\nc_interp off\nd_interp off\nlod 3\nvn 0 0 0\nvn 0 0 1\n"
                           "# another \\\nf 1//1 2//2 3//1\n");
  ASSERT_EQ(mesh.triangles.size(), 1U);
  EXPECT_EQ(mesh.positions.size(), 4U);
  EXPECT_EQ(mesh.triangles[0].corners[0].normal, -1);
  EXPECT_EQ(mesh.triangles[0].corners[1].normal, 1);
}

TEST_F(Obj, LeavesOutFacesOfOneOrTwoCornersWithOneNote) {
  const ObjMesh mesh = obj(kSquare + "f 1 2\nf 1 2 3\nf 3\nf 4 1\nf 1 3 4\n");
  EXPECT_EQ(mesh.triangles.size(), 2U);
  ASSERT_EQ(mesh.notes.size(), 1U);
  EXPECT_EQ(mesh.notes[0],
            "mesh.obj: 3 faces of fewer than three corners left out, the first in line 5");
  EXPECT_EQ(obj_complaint(kSquare + "f 1 2\n"), "the file|no triangle that has an area|faces (f)");
  EXPECT_EQ(obj_complaint(kSquare + "f 1 9\n"), "line 5|\"9\"|an index of one of the 4 v so far");
}

TEST_F(Obj, ReadsLinesOfOldMacintoshPrograms) {
  std::string text = kSquare + "# a comment\nf 1 2 \\\n3\n";
  std::replace(text.begin(), text.end(), '\n', '\r');
  EXPECT_EQ(obj(text).triangles.size(), 1U);
}

TEST_F(Obj, RefusesWhatItCannotUseWithTheLine) {
  EXPECT_EQ(obj_complaint("v 1 2\n"), "line 1|2 numbers|3");
  EXPECT_EQ(obj_complaint("v 1 2 x\n"), "line 1|\"x\"|a finite number");
  EXPECT_EQ(obj_complaint("v 1 2 1e300\n"), "line 1|\"1e300\"|a finite number");
  EXPECT_EQ(obj_complaint("\nv 1 2 nan\n"), "line 2|\"nan\"|a finite number");
  EXPECT_EQ(obj_complaint(kSquare + "f 1 2 5\n"), "line 5|\"5\"|an index of one of the 4 v so far");
  EXPECT_EQ(obj_complaint(kSquare + "f 1 2 0\n"), "line 5|\"0\"|an index of one of the 4 v so far");
  EXPECT_EQ(obj_complaint(kSquare + "f 1 2 -5\n"),
            "line 5|\"-5\"|an index of one of the 4 v so far");
  EXPECT_EQ(obj_complaint(kSquare + "f 1/1 2 3\n"),
            "line 5|\"1\"|an index of one of the 0 vt so far");
  EXPECT_EQ(obj_complaint(kSquare + "f 1/1/1/1 2 3\n"), "line 5|\"1/1/1/1\"|at most v/vt/vn");
  EXPECT_EQ(obj_complaint("curv 0 1\n"), "line 1|\"curv\"|v, vt, vn or f");
  EXPECT_EQ(obj_complaint(kSquare), "the file|no triangle that has an area|faces (f)");
  EXPECT_EQ(complaint_of([&] { (void)read_obj(folder_ / "none.obj"); }),
            "file|No such file or directory|a Wavefront OBJ");
  EXPECT_EQ(complaint_of([&] { (void)mesh(kSquare + "f 1 2 3\n", {}); }),
            "line 5|a face without texture coordinates|vt at every corner, or a mapping over a "
            "surface in the scene");
}

TEST_F(Obj, GivesItsOwnCoordinatesWithVRunningDown) {
  const Mesh m = mesh(kSquare + "vt 0 0\nvt 2 0\nvt 2 1\nf 1/1 2/2 3/3\n", {});
  const auto hit = m.intersect({Vec3(0.75, 0.25, 5), Vec3(0, 0, -1)});
  ASSERT_TRUE(hit);
  const SurfacePoint point = m.at(hit->triangle, hit->b1, hit->b2);
  EXPECT_TRUE(point.position.isApprox(Vec3(0.75, 0.25, 0)));
  EXPECT_DOUBLE_EQ(point.u, 1.5);
  EXPECT_DOUBLE_EQ(point.v, 0.75);
  EXPECT_TRUE(point.gradient_u.isApprox(Vec3(2, 0, 0)));
  EXPECT_TRUE(point.gradient_v.isApprox(Vec3(0, -1, 0)));
  EXPECT_TRUE(point.along_u.normalized().isApprox(Vec3(1, 0, 0)));
  EXPECT_TRUE(point.along_v.normalized().isApprox(Vec3(0, -1, 0)));
}

TEST_F(Obj, FindsAFrameWhereCoordinatesDoNotDiffer) {
  const Mesh m = mesh(kSquare + "vt 0.5 0.5\nf 1/1 2/1 3/1\n", {});
  const SurfacePoint point = m.at(0, 0.2, 0.2);
  EXPECT_EQ(point.gradient_u.norm(), 0);
  EXPECT_GT(point.along_u.norm(), 0);
  EXPECT_NEAR(point.along_u.dot(point.along_v), 0, 1e-12);
}

/// The soup of triangles that a tree is compared with, a loop over all.
TEST(TriangleTree, FindsWhatALoopOverAllTrianglesFinds) {
  std::vector<TriangleTree::Corners> soup;
  for (int n = 0; n < 300; ++n) {
    TriangleTree::Corners c;
    const Vec3 middle(hash_noise(1, n, 0), hash_noise(1, n, 1), hash_noise(1, n, 2));
    for (int k = 0; k < 3; ++k) {
      c[static_cast<std::size_t>(k)] =
          middle + 0.2 * Vec3(hash_noise(2, n, k, 0), hash_noise(2, n, k, 1),
                              n % 10 == 0 ? 0.0 : hash_noise(2, n, k, 2));
    }
    soup.push_back(c);
  }
  const TriangleTree tree(soup);
  int hits = 0;
  for (int n = 0; n < 3000; ++n) {
    const Vec3 from(3 * hash_noise(3, n, 0) - 1, 3 * hash_noise(3, n, 1) - 1, -2);
    const Vec3 to(hash_noise(3, n, 2), hash_noise(3, n, 3), hash_noise(3, n, 4));
    const Ray ray{from, n % 3 == 0 ? Vec3(0, 0, 1) : Vec3(to - from)};
    int best = -1;
    double nearest = 1e300;
    for (std::size_t t = 0; t < soup.size(); ++t) {
      const auto one = TriangleTree({soup[t]}).intersect(ray);
      if (one && one->t < nearest) {
        nearest = one->t;
        best = static_cast<int>(t);
      }
    }
    const auto found = tree.intersect(ray);
    ASSERT_EQ(found ? found->triangle : -1, best) << n;
    hits += best >= 0 ? 1 : 0;
  }
  EXPECT_GT(hits, 1000);
}

TEST(TwoStage, ProjectsAlongEitherNormalOrFromTheCentroid) {
  const Shape sphere = whole_shape(ShapeKind::sphere);
  const Vec3 point(0.5, 0, 0), up(0, 0, 1), centroid(0.5, 0, -0.3);
  const auto at = [&](MeshMapping mapping) {
    return two_stage_coordinates(sphere, mapping, point, up, centroid);
  };
  EXPECT_DOUBLE_EQ(at(MeshMapping::surface_normal)[1], 0.5) << "radially: on the equator";
  EXPECT_NEAR(at(MeshMapping::object_normal)[1], std::asin(0.5) / kPi, 1e-12)
      << "straight up to (0.5, 0, sqrt(3) / 2)";
  EXPECT_NEAR(at(MeshMapping::centroid)[1], std::asin(0.5) / kPi, 1e-12);
  const Vec3 aside(0, 0.5, 0);
  EXPECT_NEAR(two_stage_coordinates(sphere, MeshMapping::object_normal, point, aside, centroid)[0],
              (kPi / 3) / (2 * kPi), 1e-12)
      << "to (0.5, sqrt(3) / 2, 0)";
}

TEST(TwoStage, FallsBackToThePerpendicularWhereALineMisses) {
  const Vec3 point(2, 0, 0.25), normal(0, 1, 0);
  const Shape cylinder = whole_shape(ShapeKind::cylinder, 2);
  const auto uv =
      two_stage_coordinates(cylinder, MeshMapping::object_normal, point, normal, Vec3(0, 0, 0));
  EXPECT_DOUBLE_EQ(uv[0], 0);
  EXPECT_DOUBLE_EQ(uv[1], (2 - (0.25 + 1)) / 2);
  const Shape plane = whole_shape(ShapeKind::plane);
  const auto st = two_stage_coordinates(plane, MeshMapping::object_normal, Vec3(0.5, 3, 0.5),
                                        Vec3(1, 0, 0), Vec3(0, 0, 0));
  EXPECT_DOUBLE_EQ(st[0], 0.75);
  EXPECT_DOUBLE_EQ(st[1], 0.25);
}

TEST_F(Obj, MappedOverASphereHasTheSpheresCoordinatesAndGradientsAcrossTheSeam) {
  ObjectSpec spec;
  spec.mapping = MeshMapping::surface_normal;
  spec.shape = whole_shape(ShapeKind::sphere);
  // A triangle tangent to the sphere at theta = 0, where u goes from 1 to 0.
  const Mesh m = mesh("v 1 -1 -1\nv 1 1 -1\nv 1 0 2\nf 1 2 3\n", spec);
  for (const double y : {-1e-7, 1e-7}) {
    const auto hit = m.intersect({Vec3(3, y, 0), Vec3(-1, 0, 0)});
    ASSERT_TRUE(hit);
    const SurfacePoint point = m.at(hit->triangle, hit->b1, hit->b2);
    EXPECT_NEAR(point.u, y < 0 ? 1 : 0, 1e-6);
    EXPECT_NEAR(point.v, 0.5, 1e-9);
    EXPECT_NEAR((point.gradient_u - Vec3(0, 1 / (2 * kPi), 0)).norm(), 0, 1e-6);
    EXPECT_NEAR((point.gradient_v - Vec3(0, 0, -1 / kPi)).norm(), 0, 1e-6);
    EXPECT_NEAR((point.along_u.normalized() - Vec3(0, 1, 0)).norm(), 0, 1e-6);
  }
}

}  // namespace
}  // namespace ptm::golden
