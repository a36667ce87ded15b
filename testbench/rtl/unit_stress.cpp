#include "testbench/rtl/unit_variants.h"

namespace ptm::testbench {

const RtlUnitVariant& rtl_unit_stress() {
  static const RtlUnitVariant variant{"stress",
                                      {.shift_groups = 3},
                                      {.tmus = 3,
                                       .cache_kib = 1,
                                       .ways = 1,
                                       .fragment_fifo = 8,
                                       .miss_fifo = 12,
                                       .palette_lrgb_ports = 2,
                                       .palette_rgb_ports = 2},
                                      make_rtl_unit_stress};
  return variant;
}

}  // namespace ptm::testbench
