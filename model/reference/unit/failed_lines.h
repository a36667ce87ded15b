#pragma once
#include "model/reference/unit/unit_fragment.h"
#include "model/reference/unit/unit_memory.h"

namespace ptm::reference {

/// Whether a fragment fetches a tap of a line that the memory could not read (UnitState::failed):
/// the pixel's flag, docs/spec/unit.md, "Lines that cannot be read". Requires a legal draw of the
/// state.
[[nodiscard]] bool fetches_failed_line(const EvalConfig& config, const UnitState& state,
                                       const UnitFragment& fragment);

}  // namespace ptm::reference
