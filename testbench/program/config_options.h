#pragma once
#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "golden/scene/setting.h"
#include "testbench/config/configuration.h"

namespace ptm::testbench {

/// --preset and --set, the same of every command that has hardware.
struct ConfigOptions {
  std::string preset;             ///< empty: the scene's, or base
  std::vector<std::string> sets;  ///< "guard=6", "memory.latency=20"

  [[nodiscard]] bool any() const { return !preset.empty() || !sets.empty(); }
};

/// For checks of options.
[[nodiscard]] std::vector<std::string> preset_names();

void add_config_options(CLI::App& command, ConfigOptions& options);
/// --set alone.
void add_set_option(CLI::App& command, ConfigOptions& options);

/// Puts what the options say behind what a scene says, so that it counts. A kind of memory other
/// than the scene's takes the scene's keys of the memory away. Throws ExitError (usage) of a --set
/// that is not NAME=VALUE.
void overlay(const ConfigOptions& options, golden::Settings& hardware, golden::Settings& memory);

/// Of a command without a scene. Throws golden::InputError as make_configuration() does.
[[nodiscard]] Configuration configuration_of(const ConfigOptions& options);

/// The evaluator's, of a command that writes a .ptm: its coefficients are bytes.
[[nodiscard]] reference::EvalConfig file_config_of(const ConfigOptions& options);

}  // namespace ptm::testbench
