// ptmsim vectors: evaluator inputs and outputs as CSV, for other people's test benches.
#include <iostream>
#include <memory>

#include "testbench/program/commands.h"
#include "testbench/program/config_options.h"
#include "testbench/program/exit_code.h"
#include "testbench/program/option_checks.h"
#include "testbench/run/prepare_rtl.h"
#include "testbench/vectors/vector_csv.h"

namespace ptm::testbench {
namespace {

struct VectorOptions {
  VectorRequest request;
  ConfigOptions config;
  std::string format = "lrgb", unit = "evaluator";
};

void print_vectors(VectorOptions options) {
  if (options.unit == "lerp") {
    options.request.kind = VectorKind::lerp;
  } else if (options.format == "rgb") {
    options.request.kind = VectorKind::rgb;
  }
  options.request.config = configuration_of(options.config).eval;
  const bool evaluator = options.request.kind != VectorKind::lerp;
  if (evaluator && options.request.model == "rtl") prepare_rtl_evaluator(options.request.config);
  std::ios::sync_with_stdio(false);
  write_vectors(options.request, std::cout);
  std::cout.flush();
  if (!std::cout) throw std::runtime_error("standard output: cannot be written");
}

}  // namespace

void add_vectors_command(CLI::App& app) {
  auto options = std::make_shared<VectorOptions>();
  VectorRequest& request = options->request;
  CLI::App* command = app.add_subcommand(
      "vectors", "Print evaluator inputs and outputs as CSV (docs/spec/vectors.md)");
  add_config_options(*command, options->config);
  command->add_option("--count", request.count, "How many rows")
      ->check(whole_number())
      ->capture_default_str();
  command->add_option("--seed", request.seed, "Which operands: the same for every model")
      ->check(whole_number())
      ->capture_default_str();
  command->add_option("--model", request.model, "Whose outputs")
      ->check(CLI::IsMember({"reference", "rtl", "pipeline"}))
      ->capture_default_str();
  command->add_option("--format", options->format, "Pixels of an LRGB or an RGB map")
      ->check(CLI::IsMember({"lrgb", "rgb"}))
      ->capture_default_str();
  command->add_option("--unit", options->unit, "The evaluator, or the filter's lerp")
      ->check(CLI::IsMember({"evaluator", "lerp"}))
      ->capture_default_str();
  command->callback([options] { print_vectors(*options); });
}

}  // namespace ptm::testbench
