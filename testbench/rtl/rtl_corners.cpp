#include "testbench/rtl/rtl_variants.h"

namespace ptm::testbench {

std::span<const RtlVariant> rtl_variants() {
#define PTM_VARIANT_ROW(name) {#name, variants::evaluator_##name##_evaluator, make_rtl_##name},
  static const RtlVariant all[] = {PTM_RTL_EVALUATORS(PTM_VARIANT_ROW)
                                       PTM_RTL_TEST_EVALUATORS(PTM_VARIANT_ROW)};
#undef PTM_VARIANT_ROW
  return all;
}

}  // namespace ptm::testbench
