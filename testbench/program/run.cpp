// ptmsim run: a scene through the models, compared, with a report.
#include <algorithm>
#include <exception>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "golden/files/figure_text.h"
#include "golden/scene/scene.h"
#include "testbench/program/commands.h"
#include "testbench/program/config_options.h"
#include "testbench/program/exit_code.h"
#include "testbench/program/expected_file.h"
#include "testbench/report/html_text.h"
#include "testbench/report/report.h"
#include "testbench/run/measure_effects.h"
#include "testbench/run/run_scene.h"
#include "testbench/run/run_unit_scene.h"

namespace ptm::testbench {
namespace {

struct RunOptions {
  std::string scene, out;
  std::vector<std::string> models;
  std::vector<std::string> presets;
  ConfigOptions config;
  bool effect_costs = false;
};

void print_costs(const EffectCosts& costs) {
  const auto more = [](std::uint64_t with, std::uint64_t without) {
    return (with < without ? "-" : "+") + grouped(with < without ? without - with : with - without);
  };
  using reference::UnitCounter;
  for (const std::string& note : costs.notes) std::cout << "note: " << note << '\n';
  for (const EffectCost& cost : costs.costs) {
    const auto &with = costs.with.counters, &without = cost.without.counters;
    std::string text;
    if (with && without) {
      text += more((*with)[UnitCounter::cycles], (*without)[UnitCounter::cycles]) + " cycles, " +
              more((*with)[UnitCounter::words], (*without)[UnitCounter::words]) + " words";
    }
    if (costs.with.cells && cost.without.cells) {
      text += (text.empty() ? "" : ", ") +
              more(costs.with.cells->cells, cost.without.cells->cells) + " cells";
    }
    std::string who = cost.effect;
    for (const std::string& other : cost.together) who += " and with it " + other;
    std::cout << who << (text.empty() ? "" : " costs " + text + "; it") << " changes "
              << share(cost.changed) << " of all samples, RMSE "
              << golden::count_of(levels(cost.rmse), "level") << '\n';
  }
}

void print_summary(const RunResult& result, const RunComparison& comparison) {
  for (const std::string& note : result.notes) std::cout << "note: " << note << '\n';
  for (const ModelResult& model : result.models) {
    std::cout << model.model << ": " << duration(model.seconds);
    if (model.cycles) std::cout << ", " << plural(*model.cycles, "cycle");
    std::cout << '\n';
  }
  for (const PairDifference& pair : comparison.pairs) {
    std::cout << pair.a << " and " << pair.b << ": " << grouped(pair.difference.differing) << " of "
              << grouped(pair.difference.samples) << " samples differ, at most "
              << golden::count_of(levels(pair.difference.max), "level") << ", "
              << decibels(pair.difference.psnr_db) << '\n';
  }
  const auto golden = std::find_if(comparison.pairs.begin(), comparison.pairs.end(),
                                   [](const PairDifference& p) { return p.a == "golden"; });
  if (golden != comparison.pairs.end() && comparison.edge_samples != 0) {
    std::cout << "note: " << edge_sentence(comparison, *golden) << '\n';
  }
  if (result.costs) print_costs(*result.costs);
  for (const PresetDifference& preset : comparison.presets) {
    std::cout << "preset " << preset.preset
              << " against golden: " << decibels(preset.difference.psnr_db) << ", largest error "
              << golden::count_of(levels(preset.difference.max), "level") << '\n';
  }
}

SceneRun run_flat(const RunOptions& options) {
  if (options.effect_costs) {
    throw golden::InputError(options.scene, "the file", "a flat scene with --cost-of-effects",
                             "a scene with [[object]]: only such a one has effects");
  }
  golden::Scene scene = golden::read_scene(options.scene);
  if (!options.models.empty()) scene.models = options.models;
  golden::Settings memory;  // a flat scene has none
  overlay(options.config, scene.hardware, memory);
  if (!memory.list.empty()) {
    throw golden::InputError(options.scene, memory.list.front().place,
                             "a parameter of the memory in a flat scene",
                             "a scene with [[object]]: only such a one has a memory");
  }
  return run_scene(scene);
}

void say(const std::string& what) { std::cerr << "ptmsim: " << what << '\n'; }

SceneRun run_unit(const RunOptions& options) {
  golden::UnitScene scene = golden::read_unit_scene(options.scene);
  if (!options.models.empty()) scene.models = options.models;
  overlay(options.config, scene.hardware, scene.memory);
  SceneRun run = run_unit_scene(scene);
  if (options.effect_costs) run.result.costs = measure_effects(scene, run, say);
  return run;
}

void refuse_disagreement(const SceneRun& run, const RunComparison& comparison) {
  if (!run.faults.empty()) throw ExitError(ExitCode::disagree, run.faults.front());
  if (!comparison.models_agree()) {
    throw ExitError(ExitCode::disagree, "models that must agree differ; the report says where");
  }
  if (run.late_pixels.value_or(0) != 0) {
    throw ExitError(ExitCode::disagree, "pipeline and rtl differ in the cycle of " +
                                            golden::count_of(*run.late_pixels, "pixel"));
  }
  if (run.result.unit && !run.result.unit->differing_counters.empty()) {
    throw ExitError(ExitCode::disagree, "pipeline and rtl differ in the counter " +
                                            run.result.unit->differing_counters.front());
  }
}

/// What one configuration made of the scene, for a row beside others.
struct RunFigures {
  std::string preset;
  std::optional<double> psnr_db, largest;  ///< of the hardware against golden
  std::optional<std::uint64_t> cycles;
  std::exception_ptr disagreement;
};

RunFigures figures_of(const std::string& preset, const RunResult& result,
                      const RunComparison& comparison) {
  RunFigures figures;
  figures.preset = preset;
  for (const PairDifference& pair : comparison.pairs) {
    if (pair.a != "golden" || figures.psnr_db) continue;
    figures.psnr_db = pair.difference.psnr_db;
    figures.largest = pair.difference.max;
  }
  for (const ModelResult& model : result.models) {
    if (model.cycles) figures.cycles = model.cycles;
  }
  return figures;
}

RunFigures run_one(const RunOptions& options, const Invocation& invocation) {
  SceneRun run = golden::is_unit_scene(options.scene) ? run_unit(options) : run_flat(options);
  run.result.made_by = made_by(invocation);
  const RunComparison comparison = compare_run(run.result);
  const ReportPaths report = write_report(run.result, comparison, options.out);
  print_summary(run.result, comparison);
  std::cout << "report: " << report.html.string() << '\n';
  RunFigures figures = figures_of(options.config.preset, run.result, comparison);
  try {
    refuse_disagreement(run, comparison);
  } catch (const ExitError&) {
    figures.disagreement = std::current_exception();
  }
  return figures;
}

void print_figures(const std::vector<RunFigures>& rows) {
  std::cout << "\npreset      PSNR against golden  largest error       cycles\n";
  for (const RunFigures& row : rows) {
    std::cout << std::left << std::setw(12) << row.preset << std::right << std::setw(19)
              << (row.psnr_db ? decibels(*row.psnr_db) : "-") << std::setw(15)
              << (row.largest ? levels(*row.largest) : "-") << std::setw(13)
              << (row.cycles ? grouped(*row.cycles) : "-") << '\n';
  }
}

/// The scene with each preset, a report each.
std::vector<RunFigures> run_presets(const RunOptions& options, const Invocation& invocation) {
  std::vector<RunFigures> rows;
  for (const std::string& preset : options.presets) {
    RunOptions one = options;
    one.config.preset = preset;
    one.out = (std::filesystem::path(options.out) / preset).string();
    std::cout << (rows.empty() ? "" : "\n") << "with preset " << preset << ":\n";
    rows.push_back(run_one(one, invocation));
  }
  print_figures(rows);
  return rows;
}

void run(RunOptions options, const Invocation& invocation) {
  expect_file(options.scene, golden::FileType::scene);
  if (options.presets.size() == 1) options.config.preset = options.presets.front();
  const std::vector<RunFigures> rows = options.presets.size() > 1
                                           ? run_presets(options, invocation)
                                           : std::vector<RunFigures>{run_one(options, invocation)};
  for (const RunFigures& row : rows) {
    if (row.disagreement) std::rethrow_exception(row.disagreement);
  }
}

}  // namespace

void add_run_command(CLI::App& app, const Invocation& invocation) {
  auto options = std::make_shared<RunOptions>();
  CLI::App* command = app.add_subcommand(
      "run", "Render a scene with each model, compare the pictures, write a report");
  command->add_option("scene", options->scene, "Scene, TOML (docs/spec/scene.md)")->required();
  command->add_option("--out", options->out, "Folder for pictures, report.json and report.html")
      ->required();
  command->add_option("--models", options->models, "Which models, instead of the scene's own list")
      ->delimiter(',')
      ->check(CLI::IsMember({"golden", "reference", "pipeline", "rtl"}));
  command
      ->add_option("--preset", options->presets,
                   "Preset of the evaluator, instead of the scene's own; of several, as base,wide, "
                   "each draws the scene, into a folder of its name")
      ->delimiter(',')
      ->check(CLI::IsMember(preset_names()));
  add_set_option(*command, options->config);
  command->add_flag("--cost-of-effects", options->effect_costs,
                    "Draw the scene again without each of its effects, and report what each costs");
  command->callback([options, invocation] { run(*options, invocation); });
}

}  // namespace ptm::testbench
