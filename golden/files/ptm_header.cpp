#include "golden/files/ptm_header.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "golden/files/figure_text.h"
#include "golden/files/header_lines.h"
#include "golden/files/lum_matrix.h"
#include "golden/files/number_text.h"
#include "golden/files/plane.h"

namespace ptm::golden {
namespace {

using Words = std::vector<std::string_view>;

struct FormatRow {
  MapKind kind;
  Coding coding;
  const char* name;
};
constexpr std::array<FormatRow, 7> formats{{
    {MapKind::lrgb, Coding::raw, "LRGB"},
    {MapKind::rgb, Coding::raw, "RGB"},
    {MapKind::lum, Coding::raw, "LUM"},
    {MapKind::lrgb, Coding::jpeg, "JPEG_LRGB"},
    {MapKind::rgb, Coding::jpeg, "JPEG_RGB"},
    {MapKind::lrgb, Coding::jpegls, "JPEGLS_LRGB"},
    {MapKind::rgb, Coding::jpegls, "JPEGLS_RGB"},
}};
constexpr const char* known_formats =
    "PTM_FORMAT_ and one of LRGB, RGB, LUM, JPEG_LRGB, JPEG_RGB, JPEGLS_LRGB, JPEGLS_RGB";

void read_version(HeaderLines& lines, PtmFileInfo& info) {
  const std::string expected = "PTM_1.2 or PTM_1.1";
  const Words words = lines.next("version", expected);
  if (words.size() != 1 || (words[0] != "PTM_1.2" && words[0] != "PTM_1.1")) {
    lines.fail("version", quoted(lines.text()), expected);
  }
  info.version = words[0];
}

void read_format(HeaderLines& lines, PtmHeader& header) {
  const Words words = lines.next("format", known_formats);
  for (const FormatRow& row : formats) {
    if (words.size() == 1 && words[0] == std::string("PTM_FORMAT_") + row.name) {
      header.info.format = words[0];
      header.map.kind = row.kind;
      header.info.coding = row.coding;
    }
  }
  if (header.info.format.empty()) lines.fail("format", quoted(lines.text()), known_formats);
  // A coded payload says by itself what it holds; a raw one of another kind would be a guess.
  const bool raw_of_other_kind =
      header.info.coding == Coding::raw && header.map.kind != MapKind::lrgb;
  if (header.info.version == "PTM_1.1" && raw_of_other_kind) {
    lines.fail("format", header.info.format + " in a PTM_1.1 file",
               "PTM_FORMAT_LRGB, the one uncompressed format known of PTM_1.1");
  }
}

int to_dimension(const HeaderLines& lines, const std::string& field, std::string_view word) {
  const auto value = parse_integer(word, 1, std::numeric_limits<int>::max());
  if (!value) lines.fail(field, quoted(word), "a whole number of at least 1");
  return static_cast<int>(*value);
}

void read_size(HeaderLines& lines, PtmHeader& header) {
  const std::string expected = "the width, or width and height";
  const Words words = lines.next("width", expected);
  if (words.size() > 2) lines.fail("width", quoted(lines.text()), expected);
  header.map.width = to_dimension(lines, "width", words[0]);
  if (words.size() == 2) {
    header.map.height = to_dimension(lines, "height", words[1]);
    header.info.notes.emplace_back(
        "width and height share a line; RTIViewer and relight fail on it");
    return;
  }
  const Words second = lines.next("height", "the height");
  if (second.size() != 1) lines.fail("height", quoted(lines.text()), "the height");
  header.map.height = to_dimension(lines, "height", second[0]);
}

double to_scale(const HeaderLines& lines, std::string_view word) {
  const auto value = parse_real(word);
  if (!value || *value == 0) lines.fail("scales", quoted(word), "a finite number other than 0");
  return *value;
}

std::int32_t to_bias(const HeaderLines& lines, std::string_view word) {
  using Limits = std::numeric_limits<std::int32_t>;
  const auto value = parse_integer(word, Limits::min(), Limits::max());
  if (!value) lines.fail("biases", quoted(word), "a whole number of 32 bits");
  return static_cast<std::int32_t>(*value);
}

/// Of all bytes that a plane may hold; infinite beyond the largest double.
double largest_coefficient(const PtmMap& map, std::size_t k) {
  const double bias = map.bias[k];
  return std::abs(map.scale[k]) * std::max(std::abs(bias), std::abs(255 - bias));
}

void check_coefficients(const HeaderLines& lines, const PtmMap& map) {
  for (std::size_t k = 0; k < 6; ++k) {
    if (std::isfinite(largest_coefficient(map, k))) continue;
    lines.fail("scales and biases",
               "scale " + std::to_string(k) + " of " + format_real(map.scale[k]) + " with bias " +
                   std::to_string(map.bias[k]),
               "a scale whose coefficients, scale (byte - bias), stay below 1.8e308");
  }
}

/// A channel of a LUM map is a sum of products with its matrix' row.
void check_lum_sums(const HeaderLines& lines, const PtmMap& map) {
  for (std::size_t c = 0; c < 3; ++c) {
    const double* row = &map.lum_matrix[c * 4];
    double sum = 255 * (std::abs(row[0]) + std::abs(row[2])) + std::abs(row[3]);
    for (std::size_t k = 0; k < 6; ++k) sum += std::abs(row[1]) * largest_coefficient(map, k);
    if (std::isfinite(sum)) continue;
    lines.fail("colour matrix", "row " + std::to_string(c) + " with these scales",
               "numbers whose products with the coefficients stay below 1.8e308");
  }
}

void read_scales_and_biases(HeaderLines& lines, PtmHeader& header) {
  const std::string expected = "6 scales, or 6 scales and 6 biases";
  const Words words = lines.next("scales", expected);
  if (words.size() != 6 && words.size() != 12) {
    lines.fail("scales", count_of(words.size(), "word"), expected);
  }
  for (std::size_t k = 0; k < 6; ++k) header.map.scale[k] = to_scale(lines, words[k]);
  if (words.size() == 12) {
    for (std::size_t k = 0; k < 6; ++k) header.map.bias[k] = to_bias(lines, words[6 + k]);
    header.info.notes.emplace_back(
        "scales and biases share a line; RTIViewer and relight fail on it");
    return;
  }
  const Words biases = lines.next("biases", "6 biases");
  if (biases.size() != 6) {
    lines.fail("biases", count_of(biases.size(), "word"), "6 biases");
  }
  for (std::size_t k = 0; k < 6; ++k) header.map.bias[k] = to_bias(lines, biases[k]);
}

/// The next line as a colour matrix, if it is one; the lines stand where they stood if not.
std::optional<std::array<double, 16>> try_matrix(HeaderLines& lines) {
  std::array<double, 16> matrix{};
  try {
    const Words words = lines.next("colour matrix", "16 numbers");
    bool good = words.size() == matrix.size();
    for (std::size_t i = 0; good && i < matrix.size(); ++i) {
      const auto value = parse_real(words[i]);
      good = value.has_value();
      if (good) matrix[i] = *value;
    }
    if (good) return matrix;
  } catch (const InputError&) {
    // No line end at all: not a matrix.
  }
  lines.step_back();
  return std::nullopt;
}

/// The matrix line may be missing. It is there if the next line is 16 numbers: a payload that looks
/// like that would need 31 bytes of text in the right places. Else the payload must fill the file.
void read_lum_matrix(HeaderLines& lines, PtmHeader& header) {
  if (const auto matrix = try_matrix(lines)) {
    header.map.lum_matrix = *matrix;
    return;
  }
  const std::uint64_t left = lines.bytes_left();
  if (header.map.texels() > left || header.map.texels() * 8 != left) {
    const std::string expected = "16 numbers, or a payload without a matrix line";
    (void)lines.next("colour matrix", expected);
    lines.fail("colour matrix", quoted(lines.text()), expected);
  }
  header.map.lum_matrix = jfif_lum_matrix();
  header.info.notes.emplace_back("no colour matrix; JFIF's YCbCr matrix is assumed");
}

template <class Number>
std::vector<Number> read_list(HeaderLines& lines, const std::string& field, std::size_t count,
                              std::int64_t low, std::int64_t high) {
  const std::string expected = std::to_string(count) + " whole numbers from " +
                               std::to_string(low) + " to " + std::to_string(high);
  const Words words = lines.next(field, expected);
  if (words.size() != count) lines.fail(field, count_of(words.size(), "word"), expected);
  std::vector<Number> values;
  for (const std::string_view word : words) {
    const auto value = parse_integer(word, low, high);
    if (!value) lines.fail(field, quoted(word), expected);
    values.push_back(static_cast<Number>(*value));
  }
  return values;
}

void read_transforms(HeaderLines& lines, PtmFileInfo& info, std::size_t planes) {
  constexpr std::int64_t far = std::numeric_limits<std::int32_t>::max();
  info.transforms = read_list<int>(lines, "transforms", planes, 0, 2);
  const std::string transforms_place = lines.place("transforms");
  const auto x = read_list<int>(lines, "motion x", planes, -far - 1, far);
  const auto y = read_list<int>(lines, "motion y", planes, -far - 1, far);
  for (std::size_t p = 0; p < planes; ++p) {
    const bool moves = x[p] != 0 || y[p] != 0;
    const std::string plane = "plane " + std::to_string(p);
    if (info.transforms[p] == 2 && moves) {
      throw InputError(lines.file(), transforms_place,
                       "motion compensation by (" + std::to_string(x[p]) + ", " +
                           std::to_string(y[p]) + ") in " + plane,
                       "transform 0 or 1, or 2 with the vector (0, 0)");
    }
    if (info.transforms[p] == 2) info.notes.push_back(plane + ": motion compensation by (0, 0)");
    if (info.transforms[p] != 2 && moves) {
      info.notes.push_back(plane + ": a motion vector without that transform is ignored");
    }
  }
}

void read_order(HeaderLines& lines, PtmFileInfo& info, std::size_t planes) {
  const auto last = static_cast<std::int64_t>(planes) - 1;
  info.order = read_list<int>(lines, "order", planes, 0, last);
  std::vector<int> sorted = info.order;
  std::sort(sorted.begin(), sorted.end());
  const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
  if (twice != sorted.end()) {
    lines.fail("order", "position " + std::to_string(*twice) + " twice", "every position once");
  }
  info.references = read_list<int>(lines, "references", planes, -1, last);
  for (std::size_t p = 0; p < planes; ++p) {
    const std::string plane = "plane " + std::to_string(p);
    const int reference = info.references[p];
    if (reference < 0) {
      if (info.transforms[p] == 1) {
        info.notes.push_back(plane + ": an inversion without a reference is ignored");
      }
    } else if (info.order[static_cast<std::size_t>(reference)] >= info.order[p]) {
      lines.fail("references",
                 plane + " built on plane " + std::to_string(reference) + ", decoded no earlier",
                 "a plane that comes before it in the order, or -1");
    }
  }
}

void read_planes(HeaderLines& lines, PtmHeader& header) {
  constexpr std::int64_t far = std::numeric_limits<std::int32_t>::max();
  const std::size_t planes = plane_count(header.map.kind);
  PtmFileInfo& info = header.info;
  info.quality = read_list<int>(lines, "quality", 1, -far - 1, far)[0];
  read_transforms(lines, info, planes);
  read_order(lines, info, planes);
  info.compressed_bytes = read_list<std::uint64_t>(lines, "compressed sizes", planes, 1, far);
  info.side_bytes = read_list<std::uint64_t>(lines, "side information sizes", planes, 0, far);
  for (const std::uint64_t size : info.side_bytes) {
    if (size % 5 != 0) {
      lines.fail("side information sizes", std::to_string(size), "multiples of 5 bytes");
    }
  }
}

template <class Values, class Text>
void append_line(std::string& out, const Values& values, Text text) {
  bool first = true;
  for (const auto& value : values) {
    if (!first) out += ' ';
    first = false;
    out += text(value);
  }
  out += '\n';
}

}  // namespace

std::string format_name(MapKind kind, Coding coding) {
  for (const FormatRow& row : formats) {
    if (row.kind == kind && row.coding == coding) return row.name;
  }
  return {};
}

PtmHeader parse_ptm_header(std::span<const std::uint8_t> bytes, const std::string& file) {
  return parse_ptm_header(bytes, file, bytes.size());
}

PtmHeader parse_ptm_header(std::span<const std::uint8_t> head, const std::string& file,
                           std::uint64_t file_bytes) {
  HeaderLines lines(head, file, file_bytes);
  PtmHeader header;
  read_version(lines, header.info);
  read_format(lines, header);
  read_size(lines, header);
  read_scales_and_biases(lines, header);
  check_coefficients(lines, header.map);
  if (header.map.kind == MapKind::lum) {
    read_lum_matrix(lines, header);
    check_lum_sums(lines, header.map);
  }
  if (header.info.coding != Coding::raw) read_planes(lines, header);
  if (lines.saw_crlf()) header.info.notes.emplace_back("header lines end with CR LF");
  header.info.file_bytes = file_bytes;
  header.info.header_bytes = lines.position();
  return header;
}

std::string format_ptm_header(const PtmMap& map, const PtmFileInfo& info) {
  const auto integer = [](auto value) { return std::to_string(value); };
  std::string out = info.version + "\n" + info.format + "\n";
  out += std::to_string(map.width) + "\n" + std::to_string(map.height) + "\n";
  append_line(out, map.scale, format_real);
  append_line(out, map.bias, integer);
  if (map.kind == MapKind::lum) append_line(out, map.lum_matrix, format_real);
  if (info.coding == Coding::raw) return out;
  const std::vector<int> still(plane_count(map.kind), 0);
  out += std::to_string(info.quality) + "\n";
  append_line(out, info.transforms, integer);
  append_line(out, still, integer);
  append_line(out, still, integer);
  append_line(out, info.order, integer);
  append_line(out, info.references, integer);
  append_line(out, info.compressed_bytes, integer);
  append_line(out, info.side_bytes, integer);
  return out;
}

}  // namespace ptm::golden
