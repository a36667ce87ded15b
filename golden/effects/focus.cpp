#include "golden/effects/given_light.h"

/// Section 4.2: lu is the distance that is in focus, lv the aperture.
namespace ptm::golden {

const Effect& focus_effect();
const Effect& focus_effect() {
  static const Effect effect{.id = "focus",
                             .name = "focus",
                             .keys = coordinate_keys(),
                             .prepare = check_given_light,
                             .light = give_light};
  return effect;
}

}  // namespace ptm::golden
