#include "golden/files/ptm_file.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "golden/files/coded_payload.h"
#include "golden/files/pending_file.h"
#include "golden/files/plane_codec.h"
#include "golden/files/ptm_header.h"
#include "golden/files/raw_payload.h"
#include "golden/files/whole_file.h"

namespace ptm::golden {
namespace {

void require(bool condition, const char* what) {
  if (!condition) throw std::invalid_argument(std::string("write_ptm: ") + what);
}

void check_map(const PtmMap& map, const PtmWriteOptions& options) {
  const auto usable = [](double scale) { return std::isfinite(scale) && scale != 0; };
  const auto finite = [](double value) { return std::isfinite(value); };
  require(map.width > 0 && map.height > 0, "an empty map");
  require(map.coef.size() == map.texels() * 6 * map.polynomials(), "coef of the wrong size");
  require(map.color.size() == map.texels() * map.color_bytes(), "color of the wrong size");
  require(std::all_of(map.scale.begin(), map.scale.end(), usable), "a scale of 0, inf or NaN");
  require(
      map.kind != MapKind::lum || std::all_of(map.lum_matrix.begin(), map.lum_matrix.end(), finite),
      "a colour matrix with inf or NaN");
  require(!format_name(map.kind, options.coding).empty(),
          "LUM maps have no JPEG or JPEG-LS format");
  require(!options.version_1_1 || (options.coding == Coding::raw && map.kind == MapKind::lrgb),
          "PTM_1.1 is written for uncompressed LRGB only");
  // 65500 is what libjpeg takes.
  require(options.coding == Coding::raw ||
              (map.width <= 65500 && map.height <= 65500 && map.texels() <= largest_coded_plane),
          "a coded format with a side above 65500 or more than 268435456 texels");
  require(options.near >= 0 && options.near <= 127, "a tolerated loss outside 0..127");
  require(options.near == 0 || options.coding == Coding::jpegls,
          "a tolerated loss goes with JPEG-LS only");
  require(options.jpeg_quality >= 1 && options.jpeg_quality <= 100, "a quality outside 1..100");
}

constexpr const char* kMapFile = "a .ptm file";

void check_payload_size(const PtmHeader& header, const std::string& file) {
  if (header.info.coding == Coding::raw) {
    check_raw_size(header, file);
  } else {
    check_coded_size(header, file);
  }
}

struct FormattedPtm {
  std::vector<std::uint8_t> bytes;
  std::vector<std::string> notes;
};

/// What the readers described in docs/spec/ptm-file.md, section 7, make of this file.
std::vector<std::string> notes_for(const PtmMap& map, const PtmFileInfo& info,
                                   const std::vector<std::uint8_t>& payload) {
  std::vector<std::string> notes;
  const bool space_first = payload[0] == ' ' || (payload[0] >= '\t' && payload[0] <= '\r');
  if (info.coding == Coding::raw && space_first) {
    notes.emplace_back("the payload begins with a white-space byte, which cceh/rti swallows");
  }
  if (map.kind == MapKind::lum) notes.emplace_back("no other program reads PTM_FORMAT_LUM");
  if (info.coding == Coding::jpegls) notes.push_back("no other program reads " + info.format);
  if (info.coding != Coding::jpeg) return notes;
  if (map.width % 4 != 0) {
    notes.emplace_back("RTIViewer shears JPEG files whose width is not a multiple of 4");
  }
  if (std::count(info.transforms.begin(), info.transforms.end(), 1) != 0) {
    notes.emplace_back("relight refuses JPEG files with inverted planes");
  }
  if (payload.size() > map.texels() * raw_bytes_per_texel(map.kind)) {
    notes.emplace_back("larger than uncompressed: side information lists what JPEG changed");
  }
  return notes;
}

FormattedPtm format_with_notes(const PtmMap& map, const PtmWriteOptions& options) {
  check_map(map, options);
  CodedPayload payload;
  if (options.coding == Coding::raw) {
    payload.bytes = format_raw_payload(map, options.version_1_1);
  } else {
    payload = format_coded_payload(map, options);
  }
  payload.info.version = options.version_1_1 ? "PTM_1.1" : "PTM_1.2";
  payload.info.format = "PTM_FORMAT_" + format_name(map.kind, options.coding);
  payload.info.coding = options.coding;
  const std::string header = format_ptm_header(map, payload.info);
  FormattedPtm out{{header.begin(), header.end()}, notes_for(map, payload.info, payload.bytes)};
  out.bytes.insert(out.bytes.end(), payload.bytes.begin(), payload.bytes.end());
  return out;
}

}  // namespace

PtmFile parse_ptm(std::span<const std::uint8_t> bytes, const std::string& name) {
  PtmHeader header = parse_ptm_header(bytes, name);
  PtmMap map = header.info.coding == Coding::raw ? read_raw_payload(header, bytes, name)
                                                 : read_coded_payload(header, bytes, name);
  return {std::move(map), std::move(header.info)};
}

PtmHeader read_ptm_header(const std::filesystem::path& path) {
  const auto head = read_file_head(path, kMapFile, "PTM_", kMostHeaderBytes);
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  PtmHeader header = parse_ptm_header(head, path.string(), error ? head.size() : size);
  check_payload_size(header, path.string());
  return header;
}

PtmFile read_ptm(const std::filesystem::path& path) {
  // Before the rest is read: a header that promises what the file has not.
  (void)read_ptm_header(path);
  return parse_ptm(read_whole_file(path, "PTM_", kMapFile), path.string());
}

std::vector<std::uint8_t> format_ptm(const PtmMap& map, const PtmWriteOptions& options) {
  return format_with_notes(map, options).bytes;
}

std::vector<std::string> write_ptm(const std::filesystem::path& path, const PtmMap& map,
                                   const PtmWriteOptions& options) {
  PendingFile file(path);
  std::vector<std::string> notes = write_ptm(file, map, options);
  file.commit();
  return notes;
}

std::vector<std::string> write_ptm(PendingFile& file, const PtmMap& map,
                                   const PtmWriteOptions& options) {
  FormattedPtm formatted = format_with_notes(map, options);
  file.write(formatted.bytes);
  return std::move(formatted.notes);
}

}  // namespace ptm::golden
