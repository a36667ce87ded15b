// ptmsim: the one program. Commands live in a file each; this one owns the exit codes.
#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>
#include <exception>
#include <iostream>
#include <new>

#include "golden/files/ending_signals.h"
#include "golden/files/input_error.h"
#include "testbench/program/build_info.h"
#include "testbench/program/commands.h"
#include "testbench/program/exit_code.h"

namespace {

int fail(ptm::testbench::ExitCode code, const char* message) {
  std::cerr << "ptmsim: " << message << '\n';
  return static_cast<int>(code);
}

}  // namespace

int main(int argc, char** argv) {
  using ptm::testbench::ExitCode;
  ptm::golden::catch_ending_signals();
  std::signal(SIGXFSZ, SIG_IGN);  // a file too large is an error of the write, not the end
  CLI::App app{"Hardware for Polynomial Texture Maps, and the means to trust it", "ptmsim"};
  app.require_subcommand(1);
  const ptm::testbench::Invocation invocation = ptm::testbench::invocation(argc, argv);
  app.set_version_flag("--version", ptm::testbench::program_text(invocation));
  ptm::testbench::add_run_command(app, invocation);
  ptm::testbench::add_compare_command(app);
  ptm::testbench::add_plan_command(app);
  ptm::testbench::add_config_command(app);
  ptm::testbench::add_render_command(app);
  ptm::testbench::add_vectors_command(app);
  ptm::testbench::add_info_command(app);
  ptm::testbench::add_convert_command(app);
  ptm::testbench::add_synthesize_command(app);
  ptm::testbench::add_fit_command(app);
  ptm::testbench::add_bump_command(app);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    const int code = app.exit(error);
    if (code != 0) return static_cast<int>(ExitCode::usage);
  } catch (const ptm::golden::InputError& error) {
    return fail(ExitCode::bad_input, error.what());
  } catch (const ptm::testbench::ExitError& error) {
    return fail(error.code(), error.what());
  } catch (const std::bad_alloc&) {
    return fail(ExitCode::bad_input, "memory: found too little, expected enough for this input");
  } catch (const std::exception& error) {
    // Not that models disagree: whoever finds that throws ExitError.
    return fail(ExitCode::bad_input, error.what());
  } catch (...) {
    return fail(ExitCode::bad_input, "an error that does not say what it is");
  }
  std::cout.flush();
  if (!std::cout || std::fflush(stdout) != 0) {
    return fail(ExitCode::bad_input,
                "standard output: found a place that takes no more, expected all to be written");
  }
  return static_cast<int>(ExitCode::fine);
}
