#include "testbench/program/config_options.h"

#include "golden/files/input_error.h"
#include "testbench/program/exit_code.h"

namespace ptm::testbench {
namespace {

constexpr std::string_view kMemory = "memory.";

golden::Setting parse(const std::string& text) {
  const std::size_t at = text.find('=');
  if (at == std::string::npos || at == 0) {
    throw ExitError(ExitCode::usage, "--set " + text + ": expected NAME=VALUE");
  }
  std::string name = text.substr(0, at);
  if (name == "preset") {
    throw ExitError(ExitCode::usage, "--set " + text + ": a preset is chosen by --preset");
  }
  return {.name = name, .text = text.substr(at + 1), .key = name, .place = "--set " + text};
}

}  // namespace

std::vector<std::string> preset_names() {
  std::vector<std::string> names;
  for (const reference::Preset& preset : reference::kPresets) names.emplace_back(preset.name);
  return names;
}

void add_set_option(CLI::App& command, ConfigOptions& options) {
  command
      .add_option("--set", options.sets,
                  "NAME=VALUE: a parameter of the hardware, or memory.NAME=VALUE of the memory, on "
                  "top of the preset; may be given again (docs/spec/scene.md)")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

void add_config_options(CLI::App& command, ConfigOptions& options) {
  command
      .add_option("--preset", options.preset,
                  "Preset of the evaluator, instead of the scene's own or base")
      ->check(CLI::IsMember(preset_names()));
  add_set_option(command, options);
}

void overlay(const ConfigOptions& options, golden::Settings& hardware, golden::Settings& memory) {
  if (!options.preset.empty()) {
    hardware.list.push_back(
        {.name = "preset", .text = options.preset, .key = "preset", .place = "--preset"});
  }
  for (const std::string& text : options.sets) {
    golden::Setting setting = parse(text);
    if (!setting.name.starts_with(kMemory)) {
      hardware.list.push_back(std::move(setting));
      continue;
    }
    setting.name.erase(0, kMemory.size());
    if (setting.name == "kind") {
      std::string kind = "fixed";
      for (const golden::Setting& s : memory.list) {
        if (s.name == "kind") kind = s.text;
      }
      if (kind != setting.text) memory.list.clear();
    }
    memory.list.push_back(std::move(setting));
  }
}

Configuration configuration_of(const ConfigOptions& options) {
  golden::Settings hardware, memory;
  overlay(options, hardware, memory);
  return make_configuration({"the command line", hardware, memory});
}

reference::EvalConfig file_config_of(const ConfigOptions& options) {
  const Configuration configuration = configuration_of(options);
  if (configuration.eval.coef_bits > 8) {
    const golden::Setting* named = configuration.find_named("coef_bits");
    throw golden::InputError("the command line", named ? named->place : "--preset",
                             "coef_bits = " + std::to_string(configuration.eval.coef_bits),
                             "at most 8, the bits of a .ptm file's coefficients");
  }
  return configuration.eval;
}

}  // namespace ptm::testbench
