#include "golden/files/relightable_kind.h"

#include <array>
#include <sstream>
#include <utility>

#include "golden/files/figure_text.h"

namespace ptm::golden {
namespace {

using namespace std::string_view_literals;

/// RTIViewer's .rti: lines that begin with #, then the type, then "width height colours", then
/// "terms basis-type bytes-a-term" (Cultural Heritage Imaging, Reflectance Transformation Imaging
/// file format).
std::optional<std::string> rti_kind(std::string_view head) {
  if (!head.starts_with('#')) return std::nullopt;
  std::istringstream in{std::string(head)};
  std::string line;
  bool marked = false;
  while (in.peek() == '#' && std::getline(in, line)) {
    marked = marked || line.starts_with("#HSH") || line.starts_with("#RTI") ||
             line.starts_with("#SH") || line.starts_with("#PTM");
  }
  int type = 0, width = 0, height = 0, colors = 0, terms = 0;
  const bool sizes = static_cast<bool>(in >> type >> width >> height >> colors >> terms);
  if (!marked || !sizes) {
    if (!marked) return std::nullopt;
    return "a relightable picture (.rti) whose header is cut";
  }
  std::string basis = "of basis type " + std::to_string(type);
  if (type == 1) basis = "of polynomials (PTM) in another container";
  if (type == 2) basis = "of spherical harmonics (SH)";
  if (type == 3) basis = "of hemispherical harmonics (HSH)";
  return "a relightable picture (.rti) " + basis + ": " + std::to_string(width) + " x " +
         std::to_string(height) + " texels, " + count_of(colors, "colour") + ", " +
         count_of(terms, "term") + " a colour";
}

/// The text after "key": in a JSON text, without quotes; empty if the key is not there.
std::string json_value(std::string_view text, std::string_view key) {
  std::string name(1, '"');
  name.append(key).append("\"");
  std::size_t at = text.find(name);
  if (at == std::string_view::npos) return {};
  at = text.find_first_not_of(" \t\r\n:\"", at + name.size());
  if (at == std::string_view::npos) return {};
  return std::string(text.substr(at, text.find_first_of(",\"}\r\n", at) - at));
}

/// Relight's info.json lies beside pictures plane_0.jpg, plane_1.jpg and so on.
std::optional<std::string> relight_kind(std::string_view head) {
  if (head.find_first_not_of(" \t\r\n\xEF\xBB\xBF") == std::string_view::npos ||
      head[head.find_first_not_of(" \t\r\n\xEF\xBB\xBF")] != '{') {
    return std::nullopt;
  }
  const bool planes = head.find("\"nplanes\"") != std::string_view::npos ||
                      head.find("\"yccplanes\"") != std::string_view::npos ||
                      (head.find("\"basis\"") != std::string_view::npos &&
                       head.find("\"colorspace\"") != std::string_view::npos);
  if (!planes) return "a JSON file";
  std::string name = "the description (info.json) of Relight's pictures of planes";
  for (const char* key : {"type", "colorspace", "width", "height", "nplanes"}) {
    const std::string value = json_value(head, key);
    if (!value.empty()) name += ", " + std::string(key) + " " + value.substr(0, 24);
  }
  return name;
}

}  // namespace

std::optional<std::string> relightable_kind(std::string_view head, std::string_view extension) {
  if (auto name = rti_kind(head)) return name;
  if (auto name = relight_kind(head)) return name;
  constexpr std::array<std::pair<std::string_view, const char*>, 9> marks{{
      {" sxN"sv, "a multiresolution mesh (Nexus, .nxs or .nxz)"},
      {"ply\n"sv, "a mesh (Stanford PLY)"},
      {"ply\r"sv, "a mesh (Stanford PLY)"},
      {"glTF"sv, "a mesh (binary glTF)"},
      {"PK\x03\x04"sv, "a ZIP archive"},
      {"\x1f\x8b"sv, "data compressed by gzip"},
      {"%PDF"sv, "a PDF document"},
      {"<?xml"sv, "an XML document"},
      {"<svg"sv, "a drawing (SVG)"},
  }};
  for (const auto& [mark, name] : marks) {
    if (head.starts_with(mark)) return name;
  }
  // Files of the fitters before .rti begin with three numbers and no mark.
  if (extension == ".hsh") {
    return "a relightable picture of hemispherical harmonics (HSH), by its name";
  }
  if (extension == ".rti" && !head.empty()) {
    return "a relightable picture (.rti) of a basis that is not known";
  }
  return std::nullopt;
}

}  // namespace ptm::golden
