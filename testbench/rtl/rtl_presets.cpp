#include "testbench/rtl/rtl_variants.h"

namespace ptm::testbench {

std::unique_ptr<RtlEvaluator> make_rtl_evaluator(std::string_view name) {
  const std::string_view known = reference::find_preset(name).name;
  if (known == "paper8") return make_rtl_paper8();
  if (known == "base") return make_rtl_base();
  if (known == "wide") return make_rtl_wide();
  throw std::invalid_argument("preset '" + std::string(name) + "' is not built as RTL");
}

}  // namespace ptm::testbench
