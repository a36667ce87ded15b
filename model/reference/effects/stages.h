#pragma once
#include <array>
#include <string_view>

#include "effects/reference_stages.h"
#include "model/reference/effects/stage.h"

/// The stages that this build has, from the rows of contract/effects.def that are on. A new
/// row and its headers change nothing here.
namespace ptm::reference::effects {

struct StageRow {
  unsigned number;  ///< bit of UnitConfig::stages
  std::string_view name;
};

#define PTM_STAGE(number, id) StageRow{number, #id},
#define PTM_EFFECT(...)
inline constexpr auto kStageRows = std::to_array<StageRow>({
#include "effects/effects.def"
    {32, ""},  // none: lets a build have no stage at all
});
#undef PTM_STAGE
#undef PTM_EFFECT

/// Bits of the stages that there are.
inline constexpr unsigned kStages = [] {
  unsigned mask = 0;
  for (const StageRow& row : kStageRows) mask |= row.number < 32 ? 1U << row.number : 0U;
  return mask;
}();

static_assert(
    [] {
      for (std::size_t n = 0; n + 2 < kStageRows.size(); ++n) {
        if (kStageRows[n].number >= kStageRows[n + 1].number) return false;
      }
      return kStages < 256;  // the register's field
    }(),
    "effects.def lists stages in the order of their numbers, at most eight");

/// Bit of a stage by its name; 0 if this build has no such stage.
[[nodiscard]] consteval unsigned stage_bit(std::string_view name) {
  for (const StageRow& row : kStageRows) {
    if (row.name == name) return 1U << row.number;
  }
  return 0;
}

/// The stages that act on the draw, in the order of their numbers; the others change nothing.
template <class Int>
constexpr void apply_stages([[maybe_unused]] const StageInput<Int>& in,
                            [[maybe_unused]] StagePixel<Int>& pixel) {
#define PTM_APPLY(id) \
  if ((in.draw.effects.stages & stage_bit(#id)) != 0) id::apply(in, pixel);
  PTM_REFERENCE_STAGES(PTM_APPLY)
#undef PTM_APPLY
}

/// multiplies_effects of a fragment of the draw: docs/spec/effects.md, "Multiplies".
[[nodiscard]] constexpr unsigned stage_multiplies([[maybe_unused]] const EvalConfig& config,
                                                  [[maybe_unused]] const Draw& draw) {
  unsigned sum = 0;
#define PTM_COUNT(id) \
  if ((draw.effects.stages & stage_bit(#id)) != 0) sum += id::multiplies(config, draw);
  PTM_REFERENCE_STAGES(PTM_COUNT)
#undef PTM_COUNT
  return sum;
}

}  // namespace ptm::reference::effects
