#pragma once
#include <memory>
#include <span>

#include "contract/rtl_variants.h"
#include "testbench/rtl/verilated_evaluator.h"

/// Every variant of the evaluator that comes with the build (contract/variants.toml): the presets,
/// and two corners of the stated ranges for tests.
namespace ptm::testbench {

#define PTM_DECLARE(name) [[nodiscard]] std::unique_ptr<RtlEvaluator> make_rtl_##name();
PTM_RTL_EVALUATORS(PTM_DECLARE)
PTM_RTL_TEST_EVALUATORS(PTM_DECLARE)
#undef PTM_DECLARE

#ifdef PTM_VARIANT_LIBRARY
[[nodiscard]] std::unique_ptr<RtlEvaluator> make_rtl_cached();
#endif

inline constexpr reference::EvalConfig kSmall = variants::evaluator_small_evaluator;
inline constexpr reference::EvalConfig kLarge = variants::evaluator_large_evaluator;

struct RtlVariant {
  const char* name;
  reference::EvalConfig config;
  std::unique_ptr<RtlEvaluator> (*make)();
};
/// All of them; needs the library ptm_rtl_corners.
[[nodiscard]] std::span<const RtlVariant> rtl_variants();

}  // namespace ptm::testbench
