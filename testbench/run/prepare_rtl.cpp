#include "testbench/run/prepare_rtl.h"

#include <iostream>

#include "golden/files/input_error.h"
#include "testbench/program/exit_code.h"
#include "testbench/rtl/unit_variants.h"
#include "testbench/rtl/variant_cache.h"
#include "testbench/rtl/verilated_evaluator.h"

namespace ptm::testbench {
namespace {

void say(const std::string& what) { std::cerr << "ptmsim: " << what << '\n'; }

template <class Build>
void prepare(const Build& build) {
  try {
    build();
  } catch (const ToolError& error) {
    throw ExitError(ExitCode::missing_tool, error.what());
  } catch (const UnusableCache& error) {
    throw golden::InputError(error.folder, "$PTMSIM_CACHE", error.reason,
                             "a folder that can be written, for units that are built");
  }
}

}  // namespace

void prepare_rtl_unit(const reference::EvalConfig& config, const reference::UnitConfig& unit) {
  if (find_rtl_unit_variant(config, unit)) return;
  prepare([&] { (void)build_variant(config, unit, say); });
}

void prepare_rtl_evaluator(const reference::EvalConfig& config) {
  if (has_rtl_evaluator(config)) return;
  prepare([&] { (void)build_variant(config, say); });
}

}  // namespace ptm::testbench
