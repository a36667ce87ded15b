#pragma once
#include <array>
#include <string_view>

#include "contract/eval_config.h"

/// EvalConfig, the parameters of one evaluator, and its presets kPaper8, kBase, kWide and kPresets
/// are generated from contract/parameters.toml.
namespace ptm::reference {

inline constexpr int kShiftMax = 15;

/// The preset of that name; throws std::invalid_argument that lists the names there are.
[[nodiscard]] const Preset& find_preset(std::string_view name);

/// Throws std::invalid_argument naming the first field outside its range, its value and the range.
void validate(const EvalConfig& config);

/// The parameters as the RTL takes them, for build files and tests.
[[nodiscard]] std::array<NamedParameter, ParameterTable<EvalConfig>::kCount> rtl_parameters(
    const EvalConfig& config);

}  // namespace ptm::reference
