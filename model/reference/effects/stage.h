#pragma once
#include <array>

#include "model/reference/eval_config.h"
#include "model/reference/integer.h"
#include "model/reference/unit/unit_memory.h"

/// What a stage of the effect chain sees and changes: docs/spec/effects.md, "Steps". A stage is one
/// header of this folder with one struct of its id:
///
///     struct power {
///       /// multiplies of a fragment on whose draw it acts
///       static constexpr unsigned multiplies(const EvalConfig&, const Draw&);
///       /// the step
///       template <class Int> static constexpr void apply(const StageInput<Int>&,
///       StagePixel<Int>&);
///     };
///
/// Twins: rtl/effects/ptm_effect_<id>.sv for values and cycles, model/pipeline/effects/<id>.h for
/// cycles.
namespace ptm::reference::effects {

template <class Int = Value>
struct StageInput {
  const EvalConfig& config;
  const Draw& draw;
  const EffectTable& table;
  std::array<Int, kExtraPasses> value{};  ///< of the extra passes, lum_frac fraction bits
};

template <class Int = Value>
struct StagePixel {
  std::array<Int, 3> rgb{};     ///< 0..255
  std::array<Int, 3> addend{};  ///< levels with 4 fraction bits
};

}  // namespace ptm::reference::effects
