#include "golden/scene/flat_samples.h"

#include <algorithm>

#include "golden/render/light_map.h"
#include "golden/render/texture_filter.h"

namespace ptm::golden {

Sample flat_sample(int x, int y, int width, int height, const Light& light) {
  return {(x + 0.5) / width, (y + 0.5) / height, light.u, light.v};
}

std::size_t nearest_texel(const PtmMap& map, const Sample& sample) {
  const auto x = static_cast<std::size_t>(point_texel(sample.u, map.width, WrapMode::clamp));
  const auto y = static_cast<std::size_t>(point_texel(sample.v, map.height, WrapMode::clamp));
  return y * static_cast<std::size_t>(map.width) + x;
}

ImageReal render_flat(const PtmMap& map, int width, int height, const Light& light) {
  ImageReal image(width, height, 3);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const Sample sample = flat_sample(x, y, width, height, light);
      const Rgb color = light_texel(map, nearest_texel(map, sample), sample.lu, sample.lv);
      std::copy(color.begin(), color.end(), &image.at(x, y));
    }
  }
  return image;
}

}  // namespace ptm::golden
