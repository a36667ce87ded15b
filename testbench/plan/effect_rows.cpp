#include "testbench/plan/effect_rows.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

namespace ptm::testbench {

std::span<const EffectRow> effect_rows() {
  static const std::vector<EffectRow> rows{
#define PTM_STAGE(number, id)
#define PTM_EFFECT(id, name, source, half, sets, passes, stages) \
  {#id, name, source, (half) != 0, sets, passes, stages},
#include "effects/effects.def"
#undef PTM_STAGE
#undef PTM_EFFECT
  };
  return rows;
}

std::span<const StageRow> stage_rows() {
  static const std::vector<StageRow> rows{
#define PTM_STAGE(number, id) {number, #id},
#define PTM_EFFECT(id, name, source, half, sets, passes, stages)
#include "effects/effects.def"
#undef PTM_STAGE
#undef PTM_EFFECT
  };
  return rows;
}

const EffectRow& effect_row(std::string_view name) {
  const auto rows = effect_rows();
  const auto found = std::find_if(rows.begin(), rows.end(),
                                  [&](const EffectRow& row) { return row.name == name; });
  if (found == rows.end()) throw std::out_of_range("no effect '" + std::string(name) + "'");
  return *found;
}

}  // namespace ptm::testbench
