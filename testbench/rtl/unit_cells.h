#pragma once
#include <cstdint>

#include "model/reference/eval_config.h"
#include "model/reference/unit/unit_config.h"

/// How large a unit is, as Yosys sees the RTL before it is mapped to any technology.
namespace ptm::testbench {

/// After `hierarchy; proc; opt_clean`, not flattened, counted times instances.
struct UnitCells {
  std::uint64_t cells = 0;        ///< all of them: an adder of any width is one
  std::uint64_t multipliers = 0;  ///< $mul
  std::uint64_t adders = 0;       ///< $add and $sub
  std::uint64_t memory_bits = 0;
  bool operator==(const UnitCells&) const = default;
};

/// Some four seconds. Throws ToolError without yosys, or if it fails; golden::InputError where the
/// folder for temporary files cannot be written.
[[nodiscard]] UnitCells count_unit_cells(const reference::EvalConfig& config,
                                         const reference::UnitConfig& unit);

}  // namespace ptm::testbench
