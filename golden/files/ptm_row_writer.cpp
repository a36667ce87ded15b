#include "golden/files/ptm_row_writer.h"

#include <stdexcept>
#include <string>
#include <vector>

#include "golden/files/ptm_header.h"
#include "golden/files/raw_payload.h"

namespace ptm::golden {
namespace {

/// Bytes a texel takes in each of the payload's blocks (docs/spec/ptm-file.md, section 3).
std::vector<std::size_t> block_bytes(MapKind kind) {
  if (kind == MapKind::lrgb) return {6, 3};
  if (kind == MapKind::rgb) return {6, 6, 6};
  return {8};
}

}  // namespace

PtmRowWriter::PtmRowWriter(const std::filesystem::path& path, const PtmMap& shape)
    : shape_(shape), file_(path) {
  PtmFileInfo info;
  info.version = "PTM_1.2";
  info.format = "PTM_FORMAT_" + format_name(shape.kind, Coding::raw);
  const std::string header = format_ptm_header(shape, info);
  header_bytes_ = header.size();
  file_.write_at(0, {reinterpret_cast<const std::uint8_t*>(header.data()), header.size()});
}

void PtmRowWriter::write(int first_row, int rows, std::span<const std::uint8_t> coef,
                         std::span<const std::uint8_t> color) {
  PtmMap part = shape_;
  part.height = rows;
  part.coef.assign(coef.begin(), coef.end());
  part.color.assign(color.begin(), color.end());
  if (first_row < 0 || rows < 1 || rows > shape_.height - first_row ||
      coef.size() != part.texels() * 6 * part.polynomials() ||
      color.size() != part.texels() * part.color_bytes()) {
    throw std::invalid_argument("rows of another size than the map's");
  }
  // Rows run bottom-up within each block, so the rows of a part are one run of each.
  const std::vector<std::uint8_t> payload = format_raw_payload(part, false);
  const auto below = static_cast<std::size_t>(shape_.height - first_row - rows) *
                     static_cast<std::size_t>(shape_.width);
  std::uint64_t block = header_bytes_;
  std::size_t from = 0;
  for (const std::size_t bytes : block_bytes(shape_.kind)) {
    file_.write_at(block + below * bytes, std::span(payload).subspan(from, part.texels() * bytes));
    block += shape_.texels() * bytes;
    from += part.texels() * bytes;
  }
}

}  // namespace ptm::golden
