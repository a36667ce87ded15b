#pragma once
#include <string>

#include "testbench/run/run_result.h"

/// The page's section on the run's configuration, and on the program and machine that made it.
namespace ptm::testbench::html {

void add_made_by(std::string& page, const RunResult& result);

}  // namespace ptm::testbench::html
