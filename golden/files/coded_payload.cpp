#include "golden/files/coded_payload.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "golden/files/figure_text.h"
#include "golden/files/plane_codec.h"
#include "golden/files/plane_plan.h"
#include "golden/files/prediction.h"

namespace ptm::golden {
namespace {

/// decoding sequence: sequence[k] is the plane with order k.
std::vector<std::size_t> sequence_of(const std::vector<int>& order) {
  std::vector<std::size_t> sequence(order.size());
  for (std::size_t p = 0; p < order.size(); ++p) {
    sequence[static_cast<std::size_t>(order[p])] = p;
  }
  return sequence;
}

Plane decode_plane(Coding coding, const PlaneStream& stream, int width, int height) {
  return coding == Coding::jpeg ? decode_jpeg_plane(stream, width, height)
                                : decode_jpegls_plane(stream, width, height);
}

/// Where each plane's stream begins in the file; its side information follows it.
std::vector<std::uint64_t> starts_of(const PtmFileInfo& info, const std::string& file) {
  std::vector<std::uint64_t> starts;
  std::uint64_t at = info.header_bytes;
  for (std::size_t p = 0; p < info.compressed_bytes.size(); ++p) {
    starts.push_back(at);
    at += info.compressed_bytes[p] + info.side_bytes[p];  // 36 numbers of 31 bits: no overflow
  }
  if (at != info.file_bytes) {
    throw InputError(file, "byte " + std::to_string(std::min(at, info.file_bytes)) + " (payload)",
                     count_of(info.file_bytes - info.header_bytes, "byte") + " of payload",
                     std::to_string(at - info.header_bytes) + ", the sum of the listed sizes");
  }
  return starts;
}

struct CodedPlane {
  std::vector<std::uint8_t> stream, side;
};

/// A plane to build on, if any.
struct Reference {
  std::span<const std::uint8_t> plane;
  bool inverted = false;
};

/// Side information of one lossy plane; `decoded` becomes what a reader will have. Bytes may be
/// `tolerance` off.
std::vector<std::uint8_t> settle_plane(std::span<std::uint8_t> decoded,
                                       std::span<const std::uint8_t> wanted,
                                       const Reference& reference, const PtmWriteOptions& options) {
  const bool jpeg = options.coding == Coding::jpeg;
  const int tolerance = !jpeg ? options.near : options.exact ? 0 : 255;
  std::vector<std::uint8_t> side;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    bool astray = false;
    int value = decoded[i];
    if (!reference.plane.empty()) {
      value += predictor(reference.plane[i], reference.inverted) - 128;
      astray = value < 0 || value > 255 || (jpeg && decoded[i] == 0);
    }
    decoded[i] = static_cast<std::uint8_t>(value & 255);
    if (astray || std::abs(decoded[i] - wanted[i]) > tolerance) {
      append_side_record(side, i, wanted[i]);
      decoded[i] = wanted[i];
    }
  }
  return side;
}

bool is_lossy(const PtmWriteOptions& options) {
  return options.coding == Coding::jpeg || options.near > 0;
}

/// Codes one plane; `plane` becomes what a reader will have, so that later planes build on it.
CodedPlane code_plane(Plane& plane, const Reference& reference, const PtmMap& map,
                      const PtmWriteOptions& options) {
  const auto wanted = plane.bytes();
  Plane coded(wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    const int predicted =
        reference.plane.empty() ? 128 : predictor(reference.plane[i], reference.inverted);
    coded.bytes()[i] = is_lossy(options) ? clamped_difference(wanted[i], predicted)
                                         : wrapped_difference(wanted[i], predicted);
  }
  CodedPlane out;
  const bool jpeg = options.coding == Coding::jpeg;
  out.stream = jpeg ? encode_jpeg_plane(coded.bytes(), map.width, map.height, options.jpeg_quality)
                    : encode_jpegls_plane(coded.bytes(), map.width, map.height, options.near);
  if (!is_lossy(options)) return out;
  const std::string name = "the plane just written";
  Plane decoded = decode_plane(options.coding, {out.stream, name, "stream"}, map.width, map.height);
  out.side = settle_plane(decoded.bytes(), wanted, reference, options);
  plane = std::move(decoded);
  return out;
}

}  // namespace

void check_coded_size(const PtmHeader& header, const std::string& file) {
  const std::size_t texels = header.map.texels();
  const std::string size =
      std::to_string(header.map.width) + " x " + std::to_string(header.map.height);
  if (texels > largest_coded_plane) {
    throw InputError(file, "width and height", size,
                     "at most " + std::to_string(largest_coded_plane) + " texels in a coded file");
  }
  (void)starts_of(header.info, file);
  const std::uint64_t bytes = std::uint64_t{texels} * plane_count(header.map.kind);
  if (bytes > unsuspicious_planes && bytes / most_planes_per_byte > header.info.file_bytes) {
    throw InputError(
        file, "width and height",
        size + " texels in a file of " + std::to_string(header.info.file_bytes) + " bytes",
        "at least a byte for " + std::to_string(most_planes_per_byte) +
            " bytes of planes that take more than " + std::to_string(unsuspicious_planes));
  }
}

PtmMap read_coded_payload(PtmHeader& header, std::span<const std::uint8_t> bytes,
                          const std::string& file) {
  check_coded_size(header, file);
  PtmFileInfo& info = header.info;
  const std::vector<std::uint64_t> starts = starts_of(info, file);
  std::vector<Plane> planes(starts.size());
  for (const std::size_t p : sequence_of(info.order)) {
    const auto stream = bytes.subspan(starts[p], info.compressed_bytes[p]);
    const auto side = bytes.subspan(starts[p] + info.compressed_bytes[p], info.side_bytes[p]);
    const std::string place =
        "plane " + std::to_string(p) + " at byte " + std::to_string(starts[p]);
    planes[p] =
        decode_plane(info.coding, {stream, file, place}, header.map.width, header.map.height);
    if (info.references[p] >= 0) {
      const auto& reference = planes[static_cast<std::size_t>(info.references[p])];
      add_prediction(planes[p].bytes(), reference.bytes(), info.transforms[p] == 1);
    }
    apply_side_information(planes[p].bytes(), side, file, starts[p] + stream.size());
    const bool ends_there = stream.size() >= 2 && stream[stream.size() - 2] == 0xff &&
                            stream[stream.size() - 1] == 0xd9;
    if (!ends_there) info.notes.push_back(place + ": bytes follow the stream's end marker");
  }
  PtmMap map = header.map;
  join_planes(planes, map);
  return map;
}

CodedPayload format_coded_payload(const PtmMap& map, const PtmWriteOptions& options) {
  std::vector<Plane> planes = split_planes(map);
  const bool jpeg = options.coding == Coding::jpeg;
  PlanePlan plan = plan_planes(planes, map.width, map.height,
                               is_lossy(options) ? Differences::clamped : Differences::wrapped,
                               !jpeg || options.inversion);
  std::vector<CodedPlane> coded(planes.size());
  for (const std::size_t p : sequence_of(plan.order)) {
    Reference reference{{}, plan.transforms[p] == 1};
    if (plan.references[p] >= 0) {
      reference.plane = std::as_const(planes[static_cast<std::size_t>(plan.references[p])]).bytes();
    }
    coded[p] = code_plane(planes[p], reference, map, options);
  }
  CodedPayload out;
  out.info.quality = options.coding == Coding::jpeg ? options.jpeg_quality : 100;
  out.info.transforms = std::move(plan.transforms);
  out.info.order = std::move(plan.order);
  out.info.references = std::move(plan.references);
  for (const CodedPlane& plane : coded) {
    out.info.compressed_bytes.push_back(plane.stream.size());
    out.info.side_bytes.push_back(plane.side.size());
    out.bytes.insert(out.bytes.end(), plane.stream.begin(), plane.stream.end());
    out.bytes.insert(out.bytes.end(), plane.side.begin(), plane.side.end());
  }
  return out;
}

}  // namespace ptm::golden
