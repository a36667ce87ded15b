// ptmsim config: a configuration as a scene, RTL and Verilator's command line say it.
#include <iostream>
#include <memory>

#include "testbench/program/commands.h"
#include "testbench/program/config_options.h"
#include "testbench/program/exit_code.h"
#include "testbench/rtl/variant_cache.h"

namespace ptm::testbench {
namespace {

struct ConfigCommand {
  ConfigOptions config;
  std::string format = "all";
};

/// From the folder that holds rtl.
std::string verilator_command(const std::vector<std::string>& parameters) {
  std::string command =
      "verilator --lint-only -Wall -Irtl -y rtl/effects rtl/lint.vlt -f rtl/files.f -f rtl/unit.f "
      "--top-module ptm_unit";
  for (const std::string& parameter : parameters) command += " -G" + parameter;
  return command;
}

void print(const ConfigCommand& command) {
  golden::Settings hardware, memory;
  overlay(command.config, hardware, memory);
  const SettingsOf settings{"the command line", hardware, memory};
  const Configuration configuration = make_unit_configuration(settings);
  const auto parameters = rtl_parameters(configuration.eval, configuration.unit);
  const bool all = command.format == "all";
  if (all) std::cout << "# " << name_of(configuration.eval) << '\n';
  if (all || command.format == "toml") std::cout << configuration_toml(configuration);
  if (all) std::cout << "\n# parameters of rtl/ptm_unit.sv\n";
  if (all || command.format == "rtl") {
    for (const std::string& parameter : parameters) {
      std::cout << (all ? "# " : "") << parameter << '\n';
    }
  }
  if (all) std::cout << "\n# for Verilator, in the folder that holds rtl\n# ";
  if (all || command.format == "verilator") std::cout << verilator_command(parameters) << '\n';
}

}  // namespace

void add_config_command(CLI::App& app) {
  const auto options = std::make_shared<ConfigCommand>();
  CLI::App* command = app.add_subcommand(
      "config", "Print a configuration as TOML, as RTL parameters and as a command of Verilator");
  add_config_options(*command, options->config);
  command->add_option("--format", options->format, "One of these alone")
      ->check(CLI::IsMember({"all", "toml", "rtl", "verilator"}))
      ->capture_default_str();
  command->callback([options] { print(*options); });
}

}  // namespace ptm::testbench
