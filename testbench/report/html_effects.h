#pragma once
#include <string>

#include "testbench/run/run_result.h"

/// The page's section on what each effect costs; nothing of it stands in other pages.
namespace ptm::testbench::html {

void add_effect_costs(std::string& page, const RunResult& result);

}  // namespace ptm::testbench::html
