#include <optional>

#include "testbench/rtl/rtl_variants.h"
#include "testbench/rtl/variant_cache.h"

namespace ptm::testbench {
namespace {

/// One that comes with the build; nothing if none has these parameters.
std::unique_ptr<RtlEvaluator> make_known(const reference::EvalConfig& config) {
#define PTM_MAKE(name) \
  if (config == variants::evaluator_##name##_evaluator) return make_rtl_##name();
  PTM_RTL_EVALUATORS(PTM_MAKE)
#undef PTM_MAKE
  return nullptr;
}

}  // namespace

bool has_rtl_evaluator(const reference::EvalConfig& config) {
#define PTM_IS_IT(name) \
  if (config == variants::evaluator_##name##_evaluator) return true;
  PTM_RTL_EVALUATORS(PTM_IS_IT)
#undef PTM_IS_IT
  return false;
}

std::unique_ptr<RtlEvaluator> make_rtl_evaluator(const reference::EvalConfig& config) {
  if (auto known = make_known(config)) return known;
  return load_variant<RtlEvaluator>(build_variant(config), "ptm_make_evaluator");
}

}  // namespace ptm::testbench
