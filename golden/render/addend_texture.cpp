#include "golden/render/addend_texture.h"

#include <algorithm>

namespace ptm::golden {
namespace {

constexpr std::size_t kMostPasses = 4;

/// Appends what is neither null nor there already.
template <class Function>
void add_once(std::vector<Function>& functions, Function function) {
  if (function && std::find(functions.begin(), functions.end(), function) == functions.end()) {
    functions.push_back(function);
  }
}

double value_of(const double* a, const std::array<double, 2>& light) {
  return std::clamp(luminance({a[0], a[1], a[2], a[3], a[4], a[5]}, light[0], light[1]), 0.0,
                    255.0);
}

MipLevel interleaved(const std::vector<const std::vector<double>*>& sets, int width, int height) {
  MipLevel level{width, height, {}};
  const std::size_t numbers = sets[0]->size();
  level.values.reserve(numbers * sets.size());
  for (std::size_t first = 0; first < numbers; first += 6) {
    for (const std::vector<double>* set : sets) {
      level.values.insert(level.values.end(), set->data() + first, set->data() + first + 6);
    }
  }
  return level;
}

}  // namespace

AddendTexture::AddendTexture(const LoadedTexture* map, const DrawSpec& draw,
                             const DrawExtras& extras, bool levels)
    : extras_(&extras) {
  if (map) {
    width_ = map->width;
    height_ = map->height;
  }
  for (const EffectPass& pass : extras.passes) {
    sets_.push_back(pass.set == 0 ? &map->coef
                                  : &extras.sets.at(static_cast<std::size_t>(pass.set - 1)));
  }
  for (const EffectSpec& spec : draw.effects) {
    const Effect* effect = find_effect(spec.effect);
    if (!effect) continue;
    add_once(texels_, effect->texel);
    add_once(pixels_, effect->pixel);
  }
  if (!levels || sets_.empty() || (width_ == 1 && height_ == 1)) return;
  const std::size_t channels = 6 * sets_.size();
  below_.push_back(halve(interleaved(sets_, width_, height_), channels));
  while (below_.back().width > 1 || below_.back().height > 1) {
    below_.push_back(halve(below_.back(), channels));
  }
}

int AddendTexture::width(int level) const {
  return level == 0 ? width_ : below_[static_cast<std::size_t>(level) - 1].width;
}

int AddendTexture::height(int level) const {
  return level == 0 ? height_ : below_[static_cast<std::size_t>(level) - 1].height;
}

Rgba AddendTexture::texel(int level, int i, int j, const std::array<double, 2>& light,
                          const std::array<double, 2>& half) const {
  const std::size_t t = static_cast<std::size_t>(j) * static_cast<std::size_t>(width(level)) +
                        static_cast<std::size_t>(i);
  std::array<double, kMostPasses> values{};
  for (std::size_t k = 0; k < sets_.size(); ++k) {
    const double* a =
        level == 0
            ? &(*sets_[k])[t * 6]
            : &below_[static_cast<std::size_t>(level) - 1].values[(t * sets_.size() + k) * 6];
    values[k] = value_of(a, extras_->passes[k].half ? half : light);
  }
  Rgb addend{};
  for (const auto effect : texels_) {
    effect(*extras_, std::span(values).first(sets_.size()), addend);
  }
  return {addend[0], addend[1], addend[2], 0};
}

Rgb AddendTexture::pixel(const Rgba& addend, const Rgb& color) const {
  Rgb out = color;
  for (const auto effect : pixels_) effect(*extras_, {addend[0], addend[1], addend[2]}, out);
  return out;
}

}  // namespace ptm::golden
