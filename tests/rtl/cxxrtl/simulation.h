#pragma once
#include "testbench/rtl/verilated_evaluator.h"

/// What Yosys' simulator CXXRTL makes of the RTL, behind the types of the Verilated one. A test
/// builds evaluator.cpp with the generated C++ into a library and loads it.
namespace ptm::tests {

/// Starts with a reset.
class CxxrtlEvaluator {
 public:
  virtual ~CxxrtlEvaluator() = default;
  /// As RtlEvaluator::cycle().
  virtual testbench::RtlSeen cycle(const testbench::RtlPins& pins) = 0;
};

}  // namespace ptm::tests
