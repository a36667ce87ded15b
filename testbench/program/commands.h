#pragma once
#include <CLI/CLI.hpp>

#include "testbench/run/made_by.h"

/// One function a command: it adds the command, its options and what it does to the program.
/// A command reports trouble by throwing; main() turns that into the exit code.
namespace ptm::testbench {

/// Its report says what made it.
void add_run_command(CLI::App& app, const Invocation& invocation);
void add_render_command(CLI::App& app);
void add_vectors_command(CLI::App& app);
void add_info_command(CLI::App& app);
void add_convert_command(CLI::App& app);
void add_synthesize_command(CLI::App& app);
void add_fit_command(CLI::App& app);
void add_plan_command(CLI::App& app);
void add_bump_command(CLI::App& app);
void add_config_command(CLI::App& app);
void add_compare_command(CLI::App& app);

}  // namespace ptm::testbench
