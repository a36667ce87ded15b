#pragma once
#include "model/reference/unit/unit_config.h"

/// RTL of any parameters, ready before a model's process starts.
namespace ptm::testbench {

/// Sees to it that there is a unit, or an evaluator, with these parameters, in a process that may
/// still start others: builds one that does not come with the build and says so on the terminal.
/// Throws ExitError (a needed tool is missing) and golden::InputError (the folder for what is built
/// cannot be written).
void prepare_rtl_unit(const reference::EvalConfig& config, const reference::UnitConfig& unit);
void prepare_rtl_evaluator(const reference::EvalConfig& config);

}  // namespace ptm::testbench
