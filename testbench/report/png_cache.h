#pragma once
#include <cstdint>
#include <deque>
#include <memory>
#include <vector>

#include "golden/files/image.h"

namespace ptm::testbench {

/// Encodes pictures, remembering the last few: reference, pipeline and RTL give the same picture as
/// a rule, and page and files want it once each; encoding is most of a report's time.
class PngCache {
 public:
  using Bytes = std::shared_ptr<const std::vector<std::uint8_t>>;
  /// golden::encode_png(image). Throws as it does.
  [[nodiscard]] Bytes encode(const golden::Image8& image);

 private:
  struct Entry {
    golden::Image8 image;
    Bytes png;
  };
  std::deque<Entry> entries_;  ///< latest first
};

}  // namespace ptm::testbench
