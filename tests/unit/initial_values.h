#pragma once
#include "testbench/rtl/initial_values.h"
#include "tests/unit/unit_agreement.h"

namespace ptm::testbench {

/// The scene's pixels, cycles and counters under three seeds of the RTL's initial values, each
/// against reference and pipeline. (The models run in processes that this one starts.)
inline void expect_no_difference(const std::string& scene) {
  const UnitJob job = load_unit_scene(scene);
  for (const std::uint32_t seed : {1U, 2U, 3U}) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    set_rtl_initial_values(seed);
    expect_agreement(job, run_pair(job));
  }
  set_rtl_initial_values(0);
}

}  // namespace ptm::testbench
