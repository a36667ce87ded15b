#pragma once
#include "testbench/rtl/verilated_unit.h"

/// What Yosys' simulator CXXRTL makes of the RTL, behind the types of the Verilated units. A test
/// builds evaluator.cpp or unit.cpp with the generated C++ into a library and loads it.
namespace ptm::tests {

/// Starts with a reset.
class CxxrtlEvaluator {
 public:
  virtual ~CxxrtlEvaluator() = default;
  /// As RtlEvaluator::cycle().
  virtual testbench::RtlSeen cycle(const testbench::RtlPins& pins) = 0;
};

/// Starts with a reset, and with a memory that owes nothing.
class CxxrtlUnit {
 public:
  virtual ~CxxrtlUnit() = default;
  /// As those of RtlUnit.
  virtual testbench::RtlUnitSeen cycle(const testbench::RtlUnitPins& pins) = 0;
  virtual void write(std::uint16_t address, std::uint32_t data) = 0;
  [[nodiscard]] virtual std::uint32_t read(std::uint16_t address) = 0;
};

}  // namespace ptm::tests
