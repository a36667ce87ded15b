#include "golden/effects/effect.h"

/// The picture's negative.
namespace ptm::golden {
namespace {

void negate(const DrawExtras&, const Rgb&, Rgb& color) {
  for (double& level : color) level = 255 - level;
}

}  // namespace

const Effect& negative_effect();
const Effect& negative_effect() {
  static const Effect effect{.id = "negative", .name = "negative", .pixel = negate};
  return effect;
}

}  // namespace ptm::golden
