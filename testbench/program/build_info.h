#pragma once
#include "testbench/run/made_by.h"

namespace ptm::testbench {

/// What this build of the program says of itself, and the words that it was called with. Its source
/// alone includes the commit, and belongs to the program alone.
[[nodiscard]] Invocation invocation(int argc, const char* const* argv);

}  // namespace ptm::testbench
