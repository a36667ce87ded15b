// ptmsim run: a scene through the models, compared, with a report.
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "golden/scene/scene.h"
#include "testbench/program/commands.h"
#include "testbench/program/exit_code.h"
#include "testbench/report/report.h"
#include "testbench/run/run_scene.h"

namespace ptm::testbench {
namespace {

struct RunOptions {
  std::string scene, out;
  std::vector<std::string> models;
  std::string preset;
};

void run(const RunOptions& options) {
  golden::Scene scene = golden::read_scene(options.scene);
  if (!options.models.empty()) scene.models = options.models;
  if (!options.preset.empty()) {
    scene.preset = options.preset;
    scene.preset_place = "--preset";
  }
  const SceneRun run = run_scene(scene);
  write_report(run.result, options.out);
  for (const std::string& note : run.result.notes) std::cout << "note: " << note << '\n';
  print_summary(run.result, std::cout);
  std::cout << "report: " << (std::filesystem::path(options.out) / "report.html").string() << '\n';
  if (run.disagreements.empty()) return;
  std::string message = "the models disagree";
  for (const std::string& sentence : run.disagreements) message += "; " + sentence;
  throw ExitError(ExitCode::disagree, message);
}

}  // namespace

void add_run_command(CLI::App& app) {
  auto options = std::make_shared<RunOptions>();
  CLI::App* command = app.add_subcommand(
      "run", "Render a scene with each model, compare the pictures, write a report");
  command->add_option("scene", options->scene, "Scene, TOML (docs/spec/scene.md)")->required();
  command->add_option("--out", options->out, "Folder for pictures, report.json and report.html")
      ->required();
  command->add_option("--models", options->models, "Which models, instead of the scene's own list")
      ->delimiter(',')
      ->check(CLI::IsMember({"golden", "reference", "pipeline", "rtl"}));
  command->add_option("--preset", options->preset, "Evaluator preset, instead of the scene's own")
      ->check(CLI::IsMember({"paper8", "base", "wide"}));
  command->callback([options] { run(*options); });
}

}  // namespace ptm::testbench
