#pragma once
#include <bit>
#include <cstdint>
#include <utility>
#include <vector>

#include "model/reference/unit/unit_config.h"

namespace ptm::pipeline {

/// Where a tile's lines stand in every cache, but for the plane: docs/spec/unit-timing.md, "Tags".
struct TilePlace {
  std::uint32_t row = 0;     ///< bank * sets
  std::uint32_t index = 0;   ///< {ty', tx'}
  std::uint32_t spread = 0;  ///< the xor's other side, without the plane
  std::uint32_t line = 0;    ///< of plane 0
};

/// Set and bank of a tile.
class SetMap {
 public:
  explicit SetMap(const reference::UnitConfig& unit)
      : sets_(static_cast<std::uint32_t>(reference::cache_sets(unit))) {
    const int k = std::countr_zero(sets_);
    bits_x_ = (k + 1) / 2;
    bits_y_ = k - bits_x_;
  }

  /// `salt` is 3 * level + 5 * texture.
  [[nodiscard]] TilePlace place(std::uint32_t tx, std::uint32_t ty, std::uint32_t salt,
                                std::uint32_t line) const {
    const std::uint32_t x = tx >> 1, y = ty >> 1;
    const std::uint32_t low_x = x & ((1U << bits_x_) - 1), low_y = y & ((1U << bits_y_) - 1);
    return {((ty & 1) * 2 + (tx & 1)) * sets_, low_y << bits_x_ | low_x,
            salt + (x >> bits_x_) + (y >> bits_y_), line};
  }
  /// Row of the tag memory for a plane of that tile.
  [[nodiscard]] std::uint32_t row(const TilePlace& tile, std::uint32_t plane) const {
    return tile.row + ((tile.index ^ (tile.spread + plane)) & (sets_ - 1));
  }
  [[nodiscard]] std::uint32_t rows() const { return 4 * sets_; }

 private:
  std::uint32_t sets_;
  int bits_x_, bits_y_;
};

/// The tags of one TMU's cache. The ways of a set stand in the order of their last use, invalid
/// ones behind: which way holds a line nothing outside can see.
class TagCache {
 public:
  static constexpr std::uint32_t kInvalid = ~0U;

  TagCache(std::uint32_t rows, int ways)
      : tags_(rows * static_cast<std::size_t>(ways), kInvalid),
        ways_(static_cast<std::uint32_t>(ways)) {}

  [[nodiscard]] bool used_last(std::uint32_t row, std::uint32_t line) const {
    return tags_[row * ways_] == line;
  }
  [[nodiscard]] bool holds(std::uint32_t row, std::uint32_t line) const {
    for (std::uint32_t w = 0; w < ways_; ++w) {
      if (tags_[row * ways_ + w] == line) return true;
    }
    return false;
  }
  /// Makes the line the one used last; it takes the least recently used way if it has none.
  /// Returns whether it was there.
  bool use(std::uint32_t row, std::uint32_t line) {
    std::uint32_t* set = &tags_[row * ways_];
    if (set[0] == line) return true;
    std::uint32_t moved = line;
    for (std::uint32_t w = 0; w < ways_; ++w) {
      std::swap(moved, set[w]);
      if (moved == line) return true;
    }
    return false;
  }
  void invalidate() { tags_.assign(tags_.size(), kInvalid); }

 private:
  std::vector<std::uint32_t> tags_;
  std::uint32_t ways_;
};

}  // namespace ptm::pipeline
