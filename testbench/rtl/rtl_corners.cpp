#include "testbench/rtl/rtl_variants.h"

namespace ptm::testbench {

const std::array<RtlVariant, 5>& rtl_variants() {
  static const std::array<RtlVariant, 5> variants{{{"paper8", reference::kPaper8, make_rtl_paper8},
                                                   {"base", reference::kBase, make_rtl_base},
                                                   {"wide", reference::kWide, make_rtl_wide},
                                                   {"small", kSmall, make_rtl_small},
                                                   {"large", kLarge, make_rtl_large}}};
  return variants;
}

}  // namespace ptm::testbench
