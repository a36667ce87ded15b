#pragma once
#include "tests/formal/changed_rtl.h"

namespace ptm::tests {

/// A text of one of the RTL's files, and what a fault makes of it.
struct Fault {
  const char* name;
  const char* file;
  const char* from;
  const char* to;

  [[nodiscard]] ChangedRtl planted_in(const std::vector<std::string>& files) const {
    return {file, from, to, files};
  }
};

}  // namespace ptm::tests
