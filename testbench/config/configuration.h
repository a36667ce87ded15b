#pragma once
#include <set>
#include <string>
#include <vector>

#include "golden/scene/setting.h"
#include "model/pipeline/memory_timing.h"
#include "model/reference/unit/unit_config.h"

/// What the hardware and the memory behind it are built with: contract/parameters.toml.
///
/// A preset is a name for the values of an evaluator's parameters, and no more: nothing but this
/// file and what prints names knows of presets.
namespace ptm::testbench {

struct Configuration {
  reference::EvalConfig eval;
  reference::UnitConfig unit;
  pipeline::MemoryModel memory;
  /// Parameters that were named, with where: an effect may not change these.
  std::vector<golden::Setting> named;

  [[nodiscard]] const golden::Setting* find_named(std::string_view parameter) const;
};

/// Where settings stand, for errors.
struct SettingsOf {
  std::string file;  ///< the scene; or "the command line"
  const golden::Settings& hardware;
  const golden::Settings& memory;
};

/// A preset, `base` unless one is named, with the values that are named besides. Throws
/// golden::InputError naming the parameter, what was found and what was expected: of a key that is
/// no parameter, of a value of another kind or outside its range.
[[nodiscard]] Configuration make_configuration(const SettingsOf& settings);

/// The same where `whole_unit` is to be built: there parameters of the evaluator may be narrower
/// (reference::unit_fault()).
[[nodiscard]] Configuration make_unit_configuration(const SettingsOf& settings);

[[nodiscard]] bool is_preset(const reference::EvalConfig& config);

/// "base"; of what is no preset, the nearest one and what differs: "base with guard = 6".
[[nodiscard]] std::string name_of(const reference::EvalConfig& config);

/// "fixed", "dram" or "random".
[[nodiscard]] std::string memory_kind(const pipeline::MemoryModel& memory);

/// As a scene's [hardware] and [memory] say it: every parameter, none left to a preset.
[[nodiscard]] std::string configuration_toml(const Configuration& configuration);

}  // namespace ptm::testbench
