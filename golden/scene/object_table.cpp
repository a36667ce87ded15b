#include <algorithm>
#include <cmath>
#include <sstream>

#include "golden/geometry/direction.h"
#include "golden/scene/scene_parts.h"

namespace ptm::golden {
namespace {

using Names = std::vector<std::string_view>;

constexpr double kDegree = std::numbers::pi / 180;
/// The gradient of a coordinate along an axis is its inverse; times the scales and offsets that a
/// scene can give it stays a number.
constexpr double kShortestAxis = 1e-200;

constexpr std::array<std::string_view, 5> kPlaneKeys{"origin", "i", "j", "s", "t"};
constexpr std::array<std::string_view, 9> kCylinderKeys{"origin", "radius", "height", "a", "b",
                                                        "theta0", "z0",     "theta",  "z"};
constexpr std::array<std::string_view, 8> kSphereKeys{"origin", "radius", "a",     "b",
                                                      "theta0", "phi0",   "theta", "phi"};

/// Two numbers, the second greater.
void read_range(const TableReader& table, std::string_view key, std::array<double, 2>& range,
                double low, double high) {
  if (!table.has(key)) return;
  table.read(key, range, low, high);
  if (!(range[1] > range[0])) {
    table.fail(key, "a range that does not rise", "two numbers, the second greater");
  }
}

void read_factor(const TableReader& table, std::string_view key, double& factor) {
  table.read(key, factor, -1e6, 1e6);
  if (factor == 0) table.fail(key, "0", "a number other than 0");
}

void read_plane(const TableReader& table, Shape& shape) {
  table.read("i", shape.axis_i);
  table.read("j", shape.axis_j);
  for (const auto& [key, axis] : {std::pair{"i", &shape.axis_i}, {"j", &shape.axis_j}}) {
    if (length(*axis) >= kShortestAxis) continue;
    std::ostringstream expected;
    expected << "an axis of length " << kShortestAxis << " or more";
    table.fail(key, axis->isZero(0) ? "(0, 0, 0)" : "an axis too short to divide by",
               expected.str());
  }
  if (!span_a_plane(shape.axis_i, shape.axis_j, 1e-12)) {
    table.fail(table.has("j") ? "j" : "i", "axes on a line", "axes that span a plane");
  }
  read_range(table, "s", shape.p_range, -1e6, 1e6);
  read_range(table, "t", shape.q_range, -1e6, 1e6);
}

/// theta = [from, to] in degrees, at most a turn.
void read_theta(const TableReader& table, Shape& shape) {
  table.read("theta0", shape.p0, -3600, 3600);
  shape.p0 *= kDegree;
  if (!table.has("theta")) return;
  std::array<double, 2> theta{};
  read_range(table, "theta", theta, -3600, 3600);
  if (theta[1] - theta[0] > 360) table.fail("theta", "more than a turn", "at most 360 degrees");
  // A whole turn must be one to the bit: that is how far angles are turned.
  const double from = theta[0] * kDegree;
  shape.p_range = {from,
                   theta[1] - theta[0] == 360 ? from + 2 * std::numbers::pi : theta[1] * kDegree};
}

void read_round(const TableReader& table, Shape& shape) {
  table.read("radius", shape.radius, 1e-9, 1e9);
  read_factor(table, "a", shape.a);
  read_factor(table, "b", shape.b);
  read_theta(table, shape);
  if (shape.kind == ShapeKind::cylinder) {
    table.read("z0", shape.q0, -1e9, 1e9);
    read_range(table, "z", shape.q_range, 0, shape.height);
    return;
  }
  table.read("phi0", shape.q0, -3600, 3600);
  shape.q0 *= kDegree;
  if (!table.has("phi")) return;
  read_range(table, "phi", shape.q_range, 0, 180);
  const bool to_pole = shape.q_range[1] == 180;
  shape.q_range = {shape.q_range[0] * kDegree,
                   to_pole ? std::numbers::pi : shape.q_range[1] * kDegree};
}

/// mapping = "vt", or a table: surface, project, and the surface's keys.
void read_mapping(const TableReader& object, ObjectSpec& spec) {
  const toml::node* node = object.find("mapping");
  if (!node) return;
  if (node->is_string()) {
    constexpr std::array<std::pair<std::string_view, MeshMapping>, 1> own{
        {{"vt", MeshMapping::own}}};
    object.choose<MeshMapping>("mapping", spec.mapping, own);
    return;
  }
  const TableReader table = object.table("mapping");
  if (!table.has("surface")) table.fail("", "no 'surface'", "surface = \"sphere\" or the like");
  ShapeKind kind = ShapeKind::sphere;
  table.choose<ShapeKind>("surface", kind, kShapeNames);
  const auto keys = shape_keys(kind);
  Names known(keys.begin(), keys.end());
  known.insert(known.end(), {"surface", "project"});
  table.only(known);
  constexpr std::array<std::pair<std::string_view, MeshMapping>, 3> ways{
      {{"object", MeshMapping::object_normal},
       {"surface", MeshMapping::surface_normal},
       {"centroid", MeshMapping::centroid}}};
  spec.mapping = MeshMapping::surface_normal;
  table.choose<MeshMapping>("project", spec.mapping, ways);
  spec.shape = read_shape(table, kind);
}

/// A number for all three axes, or three.
void read_scale(const TableReader& table, Vec3& scale) {
  const toml::node* node = table.find("scale");
  if (!node) return;
  if (node->is_array()) {
    table.read("scale", scale);
  } else {
    double factor = 1;
    table.read("scale", factor, -1e9, 1e9);
    scale = Vec3::Constant(factor);
  }
  if ((scale.array().abs() < 1e-9).any()) {
    table.fail("scale", "a factor of 0", "factors of at least 1e-9 in size");
  }
}

void read_uv(const TableReader& table, ObjectSpec& spec) {
  table.read("uv_scale", spec.uv_scale, -1e9, 1e9);
  if (spec.uv_scale[0] == 0 || spec.uv_scale[1] == 0) {
    table.fail("uv_scale", "0", "numbers other than 0");
  }
  table.read("uv_offset", spec.uv_offset, -1e9, 1e9);
}

void read_segments(const TableReader& table, ObjectSpec& spec) {
  const toml::node* node = table.find("segments");
  if (!node) return;
  const toml::array& pair = table.reader().array(*node, table.name("segments"), 2);
  for (std::size_t k = 0; k < 2; ++k) {
    spec.segments[k] =
        static_cast<int>(table.reader().integer(pair[k], table.name("segments"), 1, 4096));
  }
}

}  // namespace

std::span<const std::string_view> shape_keys(ShapeKind kind) {
  if (kind == ShapeKind::plane) return kPlaneKeys;
  if (kind == ShapeKind::cylinder) return kCylinderKeys;
  return kSphereKeys;
}

Shape read_shape(const TableReader& table, ShapeKind kind) {
  double height = 2;
  if (kind == ShapeKind::cylinder) table.read("height", height, 1e-9, 1e9);
  Shape shape = whole_shape(kind, height);
  table.read("origin", shape.origin);
  if (kind == ShapeKind::plane) {
    read_plane(table, shape);
  } else {
    read_round(table, shape);
  }
  return shape;
}

ObjectSpec read_object(const TableReader& table, const std::filesystem::path& folder) {
  ObjectSpec spec;
  spec.place = table.place("");
  if (!table.has("kind")) table.fail("", "no 'kind'", "kind = \"plane\" or the like");
  std::string kind;
  table.read("kind", kind);
  Names known{"kind",      "texture", "color", "combine",  "ka",        "kd",
              "translate", "rotate",  "scale", "uv_scale", "uv_offset", "effect"};
  if (kind == "mesh") {
    known.insert(known.end(), {"file", "mapping"});
    table.only(known);
    spec.mesh = true;
    std::string file;
    if (!table.has("file")) table.fail("", "no 'file'", "file = \"....obj\"");
    table.read("file", file);
    spec.file = folder / file;
    read_mapping(table, spec);
  } else {
    ShapeKind shape = ShapeKind::plane;
    if (std::none_of(kShapeNames.begin(), kShapeNames.end(),
                     [&](const auto& n) { return n.first == kind; })) {
      table.fail("kind", "'" + kind + "'", "one of plane, cylinder, sphere, mesh");
    }
    table.choose<ShapeKind>("kind", shape, kShapeNames);
    const auto keys = shape_keys(shape);
    known.insert(known.end(), keys.begin(), keys.end());
    known.emplace_back("segments");
    table.only(known);
    spec.shape = read_shape(table, shape);
    read_segments(table, spec);
  }
  table.read("translate", spec.transform.translate);
  table.read("rotate", spec.transform.rotate);
  read_scale(table, spec.transform.scale);
  read_uv(table, spec);
  return spec;
}

}  // namespace ptm::golden
