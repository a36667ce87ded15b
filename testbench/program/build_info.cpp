#include "testbench/program/build_info.h"

#include "testbench/program/commit.h"

namespace ptm::testbench {

Invocation invocation(int argc, const char* const* argv) {
  Invocation made;
  made.version = PTM_VERSION;
  made.commit = kCommit;
  if (kChanged != SourcesChanged::unknown) made.changed = kChanged == SourcesChanged::yes;
  made.command.assign(argv, argv + argc);
  return made;
}

}  // namespace ptm::testbench
