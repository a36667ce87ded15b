#pragma once
#include <array>
#include <vector>

#include "golden/effects/effect.h"
#include "golden/render/mip_levels.h"

namespace ptm::golden {

/// What a draw's effects add to its pixels, texel by texel, with the map's mip levels: each set
/// that an extra pass evaluates is averaged as the map is (Eq. 14; set 0 is the luminance without
/// the colour).
class AddendTexture {
 public:
  /// Of a draw whose effects change pixels. With `levels` false there is level 0 only. Map and
  /// extras must stay where they are; without extra passes the map may be null.
  AddendTexture(const LoadedTexture* map, const DrawSpec& draw, const DrawExtras& extras,
                bool levels);

  [[nodiscard]] std::size_t passes() const { return sets_.size(); }
  [[nodiscard]] int levels() const { return 1 + static_cast<int>(below_.size()); }
  [[nodiscard]] int width(int level) const;
  [[nodiscard]] int height(int level) const;
  /// The effects' Effect::texel, in order, on the values of the passes; fourth number 0.
  [[nodiscard]] Rgba texel(int level, int i, int j, const std::array<double, 2>& light,
                           const std::array<double, 2>& half) const;
  /// The effects' Effect::pixel, in order.
  [[nodiscard]] Rgb pixel(const Rgba& addend, const Rgb& color) const;

 private:
  const DrawExtras* extras_;
  int width_ = 0, height_ = 0;
  std::vector<const std::vector<double>*> sets_;  ///< level 0, one a pass, [height][width][6]
  std::vector<MipLevel> below_;                   ///< [height][width][passes][6]
  std::vector<decltype(Effect::texel)> texels_;
  std::vector<decltype(Effect::pixel)> pixels_;
};

/// The same at one half-vector: a texture to filter.
struct AddendView {
  const AddendTexture* texture;
  std::array<double, 2> half;
  [[nodiscard]] int levels() const { return texture->levels(); }
  [[nodiscard]] int width(int level) const { return texture->width(level); }
  [[nodiscard]] int height(int level) const { return texture->height(level); }
  [[nodiscard]] Rgba texel(int level, int i, int j, const std::array<double, 2>& light) const {
    return texture->texel(level, i, j, light, half);
  }
};

}  // namespace ptm::golden
