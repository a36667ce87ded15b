#include "model/pipeline/unit/texture_unit_feed.h"

namespace ptm::pipeline {

TextureUnit::Feed TextureUnit::feed_with_effects(
    std::span<const reference::UnitFragment> fragments) {
  return feed<true>(fragments);
}

}  // namespace ptm::pipeline
