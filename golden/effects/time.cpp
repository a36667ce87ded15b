#include "golden/effects/given_light.h"

/// Section 4.2: lu is the time of day.
namespace ptm::golden {

const Effect& time_effect();
const Effect& time_effect() {
  static const Effect effect{.id = "time",
                             .name = "time",
                             .keys = coordinate_keys(),
                             .prepare = check_given_light,
                             .light = give_light};
  return effect;
}

}  // namespace ptm::golden
