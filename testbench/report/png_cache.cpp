#include "testbench/report/png_cache.h"

#include "golden/files/png_bytes.h"

namespace ptm::testbench {
namespace {

constexpr std::size_t kRemembered = 8;

bool equal(const golden::Image8& p, const golden::Image8& q) {
  return p.width == q.width && p.height == q.height && p.channels == q.channels &&
         p.samples == q.samples;
}

}  // namespace

PngCache::Bytes PngCache::encode(const golden::Image8& image) {
  for (const Entry& entry : entries_) {
    if (equal(entry.image, image)) return entry.png;
  }
  Bytes png = std::make_shared<const std::vector<std::uint8_t>>(golden::encode_png(image));
  entries_.push_front({image, png});
  if (entries_.size() > kRemembered) entries_.pop_back();
  return png;
}

}  // namespace ptm::testbench
