#include <cmath>

#include "golden/scene/obj_file.h"
#include "tests/fuzz/fuzz_folder.h"
#include "tests/fuzz/fuzz_target.h"

// Wavefront OBJ files.
namespace ptm::tests {
namespace {

void check(const golden::ObjMesh& mesh) {
  const auto within = [](int index, std::size_t count) {
    return index >= 0 && static_cast<std::size_t>(index) < count;
  };
  if (mesh.triangles.empty()) std::abort();
  for (const golden::ObjTriangle& triangle : mesh.triangles) {
    for (const golden::ObjCorner& corner : triangle.corners) {
      if (!within(corner.position, mesh.positions.size())) std::abort();
      if (corner.texture != -1 && !within(corner.texture, mesh.texcoords.size())) std::abort();
      if (corner.normal != -1 && !within(corner.normal, mesh.normals.size())) std::abort();
    }
  }
  for (const golden::Vec3& position : mesh.positions) {
    if (!position.allFinite()) std::abort();
  }
}

}  // namespace

bool fuzz_reads(const std::uint8_t* data, std::size_t size) {
  static const FuzzFolder folder;
  try {
    check(golden::read_obj(folder.write("fuzz.obj", data, size)));
    return true;
  } catch (const golden::InputError&) {
    return false;
  }
}

std::vector<FuzzSeed> fuzz_seeds() {
  return {
      {"triangle", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"},
      {"all_statements",
       "\xEF\xBB\xBF# made\r\nmtllib a.mtl\no one\ng g1 g2\ns off\nv 0 0 0 1\nv 1 0 0 1 .5 .5\n"
       "v 1 1 0\nv 0 1 0\nvt 0\nvt 1 0\nvt 1 1 0\nvn 0 0 1\nvn 0 0 0\nusemtl m\n"
       "f 1/1/1 2/2/2 3/3/1 4//1\nf -4 -3 \\\n-2 -1\nl 1 2\np 1\nbevel on\nc_interp on\n"},
      {"concave", "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 1 .5 0\nv 0 2 0\nf 1 2 3 4 5\nf 5 4 3 2 1\n"},
      {"polygon_in_space",
       "v 0 0 1e30\nv 1e-30 0 0\nv 0 -1 0\nv 1 1 1\nv 0 0 0\nv 0 0 0\nf 1 2 3 4 5 6\nf 1 2 3\n"},
      {"refused_index", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n"},
      {"refused_curve", "v 0 0 0\ncstype bezier\ncurv 0 1 1 2 3\n"}};
}

}  // namespace ptm::tests

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  (void)ptm::tests::fuzz_reads(data, size);
  return 0;
}
