#pragma once
#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "golden/files/input_error.h"
#include "golden/scene/shape.h"

namespace ptm::golden {

/// One corner of a triangle: indices from 0, -1 for none.
struct ObjCorner {
  int position = -1, texture = -1, normal = -1;
};
struct ObjTriangle {
  std::array<ObjCorner, 3> corners;
  int line = 0;  ///< of the face, from 1
};

/// A triangle mesh as a Wavefront OBJ holds it.
struct ObjMesh {
  std::vector<Vec3> positions, normals;          ///< normals as the file has them
  std::vector<std::array<double, 2>> texcoords;  ///< v as the file has it: up
  std::vector<ObjTriangle> triangles;            ///< at least one
  std::vector<std::string> notes;                ///< what was left out, said to the user
};

/// Reads v, vt, vn and f of a Wavefront OBJ; polygons, convex or not, are cut into triangles
/// (cut_polygon.h), and triangles without area are left out. So are faces of one or two corners,
/// with one note a file. A normal (0, 0, 0) counts as none. Indices count from 1, or from the end
/// if negative, at the place where the face stands. A line that ends in \ goes on in the next one,
/// unless it has a comment. Lines end as read_text_lines() says. Passed over: o, g, s, usemtl,
/// mtllib, l, p, bevel, mg, c_interp, d_interp, lod, shadow_obj, trace_obj, maplib, usemap, # and
/// blank lines, further numbers of v (weight or colour) and vt. Throws InputError with the line:
/// other keywords (free-form surfaces), too few or bad numbers, an index of nothing, numbers beyond
/// 1e30; and for a file without a triangle.
[[nodiscard]] ObjMesh read_obj(const std::filesystem::path& path);

}  // namespace ptm::golden
