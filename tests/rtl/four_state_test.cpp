// The unit in a four-state simulator: no X, and everything as in Verilator, on a few scenes. All of
// them and both units: four_state_slow_test.cpp.
#include "tests/rtl/four_state.h"

namespace ptm::tests {
namespace {

TEST(FourState, TheUnitGivesNoXAndWhatVerilatorGives) {
  const testbench::RtlUnitVariant small = testbench::rtl_unit_variants().back();
  const FourStateUnit unit(small, unit_sources());
  for (const SmallScene& scene : small_scenes()) {
    const std::string name = scene.name;
    if (name == "LrgbBilinear" || name == "PaletteLrgbDecal" || name == "ColorOnly" ||
        name == "RgbTrilinearAdd") {
      expect_replayed(small, unit, scene, 12);
    }
  }
}

}  // namespace
}  // namespace ptm::tests
