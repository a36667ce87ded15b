#pragma once
#include <span>
#include <string_view>

/// The rows of contract/effects.def that this build has.
namespace ptm::testbench {

struct EffectRow {
  const char* id;      ///< of its files
  const char* name;    ///< in scenes and reports
  const char* source;  ///< of its equation
  bool half;           ///< fragments bring the half-vector
  int sets, passes;    ///< most coefficient sets and evaluator passes that it adds
  unsigned stages;     ///< mask of stages that its draws use
};
struct StageRow {
  int number;  ///< its bit
  const char* id;
};

[[nodiscard]] std::span<const EffectRow> effect_rows();
[[nodiscard]] std::span<const StageRow> stage_rows();
/// Throws std::out_of_range if this build has none of that name.
[[nodiscard]] const EffectRow& effect_row(std::string_view name);

}  // namespace ptm::testbench
