#include "golden/scene/obj_file.h"

#include <algorithm>
#include <limits>
#include <string_view>

#include "golden/files/figure_text.h"
#include "golden/files/number_text.h"
#include "golden/files/text_lines.h"
#include "golden/geometry/direction.h"
#include "golden/scene/cut_polygon.h"

namespace ptm::golden {
namespace {

constexpr std::string_view kBlanks = " \t\r\f\v";

class ObjReader {
 public:
  explicit ObjReader(const std::filesystem::path& path) : path_(path) {}

  ObjMesh read() {
    std::string whole;
    for (std::string& line : read_text_lines(path_, "a Wavefront OBJ", kLargestObj)) {
      ++line_;
      // A comment ends with its line, whatever its last character.
      const bool goes_on = line.ends_with('\\') && line.find('#') == std::string::npos;
      if (goes_on) line.back() = ' ';
      whole += line;
      if (goes_on) continue;
      take(whole);
      whole.clear();
    }
    take(whole);
    if (no_polygons_ > 0) {
      mesh_.notes.push_back(path_.filename().string() + ": " + count_of(no_polygons_, "face") +
                            " of fewer than three corners left out, the first in line " +
                            std::to_string(first_no_polygon_));
    }
    if (mesh_.triangles.empty()) {
      throw InputError(path_.string(), "the file", "no triangle that has an area", "faces (f)");
    }
    return std::move(mesh_);
  }

 private:
  [[noreturn]] void fail(const std::string& found, const std::string& expected) const {
    throw InputError(path_.string(), "line " + std::to_string(line_), found, expected);
  }

  static std::vector<std::string_view> fields_of(std::string_view text) {
    std::vector<std::string_view> fields;
    for (;;) {
      const std::size_t first = text.find_first_not_of(kBlanks);
      if (first == std::string_view::npos) return fields;
      text.remove_prefix(first);
      const std::size_t last = std::min(text.find_first_of(kBlanks), text.size());
      fields.push_back(text.substr(0, last));
      text.remove_prefix(last);
    }
  }

  void take(std::string_view text) {
    const auto fields = fields_of(text.substr(0, text.find('#')));
    if (fields.empty()) return;
    const std::string_view key = fields[0];
    if (key == "v") {
      const auto n = numbers(fields, 3);
      mesh_.positions.emplace_back(n[0], n[1], n[2]);
    } else if (key == "vn") {
      const auto n = numbers(fields, 3);
      mesh_.normals.emplace_back(n[0], n[1], n[2]);
    } else if (key == "vt") {
      take_texcoord(fields);
    } else if (key == "f") {
      take_face(fields);
    } else if (std::find(kPassed.begin(), kPassed.end(), key) == kPassed.end()) {
      fail(quoted(key), "v, vt, vn or f");
    }
  }

  void take_texcoord(const std::vector<std::string_view>& fields) {
    const auto n = numbers(fields, 1);
    mesh_.texcoords.push_back({n[0], fields.size() > 2 ? number(fields[2]) : 0.0});
  }

  double number(std::string_view text) const {
    const auto value = parse_real(text);
    // Beyond that the squares of areas would be no numbers before long.
    if (!value || std::abs(*value) > 1e30) fail(quoted(text), "a finite number");
    return *value;
  }

  std::array<double, 3> numbers(const std::vector<std::string_view>& fields,
                                std::size_t count) const {
    if (fields.size() < count + 1) {
      fail(std::to_string(fields.size() - 1) + " numbers", std::to_string(count));
    }
    std::array<double, 3> values{};
    for (std::size_t i = 0; i < count; ++i) values[i] = number(fields[i + 1]);
    return values;
  }

  int index(std::string_view text, std::size_t count, const char* what) const {
    const auto most =
        static_cast<std::int64_t>(std::min<std::size_t>(count, std::numeric_limits<int>::max()));
    const auto value = parse_integer(text, -most, most);
    if (!value || *value == 0) {
      fail(quoted(text),
           std::string("an index of one of the ") + std::to_string(count) + " " + what + " so far");
    }
    return static_cast<int>(*value > 0 ? *value - 1 : most + *value);
  }

  /// "7", "7/2", "7//3" or "7/2/3".
  ObjCorner corner(std::string_view text) const {
    std::array<std::string_view, 3> parts;
    std::size_t n = 0;
    for (std::string_view rest = text;; ++n) {
      if (n == 3) fail(quoted(text), "at most v/vt/vn");
      const std::size_t slash = rest.find('/');
      parts[n] = rest.substr(0, slash);
      if (slash == std::string_view::npos) break;
      rest.remove_prefix(slash + 1);
    }
    ObjCorner c;
    c.position = index(parts[0], mesh_.positions.size(), "v");
    if (!parts[1].empty()) c.texture = index(parts[1], mesh_.texcoords.size(), "vt");
    if (!parts[2].empty()) c.normal = index(parts[2], mesh_.normals.size(), "vn");
    // Exporters write (0, 0, 0) where they know none: the face's own normal stands in.
    if (c.normal >= 0 && mesh_.normals[static_cast<std::size_t>(c.normal)].isZero(0)) c.normal = -1;
    return c;
  }

  [[nodiscard]] bool has_area(const ObjTriangle& triangle) const {
    const auto at = [&](std::size_t k) {
      return mesh_.positions[static_cast<std::size_t>(triangle.corners[k].position)];
    };
    const Vec3 e1 = at(1) - at(0), e2 = at(2) - at(0);
    return length(e1) >= kShortestEdge && length(e2) >= kShortestEdge && span_a_plane(e1, e2, 0);
  }

  void take_face(const std::vector<std::string_view>& fields) {
    std::vector<ObjCorner> corners;
    std::vector<Vec3> places;
    for (std::size_t i = 1; i < fields.size(); ++i) {
      corners.push_back(corner(fields[i]));
      places.push_back(mesh_.positions[static_cast<std::size_t>(corners.back().position)]);
    }
    if (corners.size() < 3) {  // an edge or a point, which no picture shows
      if (no_polygons_++ == 0) first_no_polygon_ = line_;
      return;
    }
    for (const auto& [a, b, c] : cut_polygon(places, first_of(corners))) {
      const ObjTriangle triangle{{corners[a], corners[b], corners[c]}, line_};
      if (has_area(triangle)) mesh_.triangles.push_back(triangle);
    }
  }

  /// The corner of the least position: the same one, wherever the face's list begins.
  static std::size_t first_of(const std::vector<ObjCorner>& corners) {
    const auto least = std::min_element(
        corners.begin(), corners.end(),
        [](const ObjCorner& a, const ObjCorner& b) { return a.position < b.position; });
    return static_cast<std::size_t>(least - corners.begin());
  }

  // What names, groups, smooths or shades, and lines and points.
  static constexpr std::array<std::string_view, 16> kPassed{
      "o",  "g",        "s",        "usemtl", "mtllib",     "l",         "p",      "bevel",
      "mg", "c_interp", "d_interp", "lod",    "shadow_obj", "trace_obj", "maplib", "usemap"};
  /// What is inversely as long must be a number, whatever a scene multiplies it with.
  static constexpr double kShortestEdge = 1e-200;
  static constexpr std::uintmax_t kLargestObj = std::uintmax_t{1} << 30;
  std::filesystem::path path_;
  int line_ = 0, first_no_polygon_ = 0;
  std::size_t no_polygons_ = 0;
  ObjMesh mesh_;
};

}  // namespace

ObjMesh read_obj(const std::filesystem::path& path) { return ObjReader(path).read(); }

}  // namespace ptm::golden
