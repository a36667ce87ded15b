#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "golden/files/ptm_map.h"

namespace ptm::golden {

/// One byte a texel in the file's row order, bottom row first: [height][width].
///
/// The memory is not cleared: a stream that promises more texels than it holds costs address space
/// only, since the system hands out pages when the decoder reaches them.
class Plane {
 public:
  Plane() = default;
  explicit Plane(std::size_t texels)
      : bytes_(std::make_unique_for_overwrite<std::uint8_t[]>(texels)), size_(texels) {}

  [[nodiscard]] std::span<std::uint8_t> bytes() { return {bytes_.get(), size_}; }
  [[nodiscard]] std::span<const std::uint8_t> bytes() const { return {bytes_.get(), size_}; }

 private:
  std::unique_ptr<std::uint8_t[]> bytes_;
  std::size_t size_ = 0;
};

/// Planes of a coded file: lrgb 9 (a0..a5, R, G, B), rgb 18 (plane 6c + k is a_k of channel c).
[[nodiscard]] constexpr std::size_t plane_count(MapKind kind) {
  return kind == MapKind::rgb ? 18 : 9;
}

/// Cuts a map of kind lrgb or rgb into its planes, bottom row first.
[[nodiscard]] std::vector<Plane> split_planes(const PtmMap& map);

/// The inverse: fills map.coef and map.color; map.kind, width and height are set already.
void join_planes(const std::vector<Plane>& planes, PtmMap& map);

}  // namespace ptm::golden
