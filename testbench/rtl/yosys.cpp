#include "testbench/rtl/yosys.h"

#include "testbench/rtl/variant_build.h"

namespace ptm::testbench {

std::vector<std::string> rtl_sources(const std::string& list) {
  return listed_sources(variant_build().source_root, list);
}

}  // namespace ptm::testbench
