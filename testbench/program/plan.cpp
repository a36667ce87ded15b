// ptmsim plan: what a scene calls for and what it will cost, before anything is drawn.
#include <iomanip>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "golden/files/figure_text.h"
#include "golden/scene/scene.h"
#include "testbench/plan/effect_rows.h"
#include "testbench/program/commands.h"
#include "testbench/program/config_options.h"
#include "testbench/program/expected_file.h"
#include "testbench/run/unit_job.h"

namespace ptm::testbench {
namespace {

using Json = nlohmann::ordered_json;

struct PlanOptions {
  std::string scene;
  ConfigOptions config;
  bool json = false;
};

Json cost_json(const PixelCost& cost) {
  return {{"footprints", cost.footprints},
          {"probes", cost.probes},
          {"words", cost.words},
          {"taps", cost.taps},
          {"multiplies",
           {{"address", cost.address},
            {"filter", cost.filter},
            {"eval", cost.eval},
            {"combine", cost.combine},
            {"effects", cost.effects},
            {"all", cost.multiplies()}}},
          {"cycles", cost.cycles}};
}

Json plan_json(const ScenePlan& plan) {
  Json json;
  json["hardware"] = {{"half_vector", plan.unit.half_vector},
                      {"extra_sets", plan.unit.extra_sets},
                      {"extra_passes", plan.unit.extra_passes},
                      {"stages", plan.unit.stages}};
  json["blocks"] = Json::array();
  for (const PlannedBlock& block : plan.blocks) {
    json["blocks"].push_back(
        {{"name", block.name}, {"what", block.what}, {"effects", block.effects}});
  }
  json["draws"] = Json::array();
  for (const PlannedDraw& draw : plan.draws) {
    json["draws"].push_back({{"map", draw.map},
                             {"color", draw.color},
                             {"effects", draw.effects},
                             {"words", draw.words},
                             {"passes", draw.passes},
                             {"extra_passes", draw.extra_passes},
                             {"stages", draw.stages},
                             {"least", cost_json(draw.least)},
                             {"most", cost_json(draw.most)}});
  }
  return json;
}

std::string list(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text.empty() ? "none" : text;
}

void print_cost(const char* name, const PixelCost& cost) {
  std::cout << "  " << std::left << std::setw(8) << name << std::right << std::setw(6) << cost.words
            << std::setw(6) << cost.taps << std::setw(9) << cost.address << std::setw(8)
            << cost.filter << std::setw(6) << cost.eval << std::setw(9) << cost.combine
            << std::setw(9) << cost.effects << std::setw(7) << cost.multiplies() << std::setw(8)
            << cost.cycles << '\n';
}

void print_draw(std::size_t number, const PlannedDraw& draw) {
  std::cout << "draw " << number << ": ";
  if (!draw.map.empty()) std::cout << "map " << draw.map;
  if (!draw.color.empty()) std::cout << (draw.map.empty() ? "" : ", ") << "colour " << draw.color;
  std::cout << "; effects: " << list(draw.effects) << '\n'
            << "  " << golden::count_of(draw.words, "word") << " a texel, "
            << golden::count_of(draw.passes, "pass") << " of the map's and " << draw.extra_passes
            << " of effects, stages: " << list(draw.stages) << '\n'
            << "  a pixel   words  taps  address  filter  eval  combine  effects    all  cycles\n";
  print_cost("least", draw.least);
  print_cost("most", draw.most);
}

void print_plan(const ScenePlan& plan) {
  if (plan.blocks.empty()) std::cout << "no effect needs hardware of its own\n";
  for (const PlannedBlock& block : plan.blocks) {
    std::cout << block.name << ": " << block.what << ", for " << list(block.effects) << '\n';
  }
  for (std::size_t d = 0; d < plan.draws.size(); ++d) print_draw(d, plan.draws[d]);
  std::cout << "taps: texels read. Multiplies: address to effects. Cycles: with every line a hit.\n"
               "Least: one footprint; most: all that the filter can ask for.\n";
}

void plan(const PlanOptions& options) {
  expect_file(options.scene, golden::FileType::scene);
  if (!golden::is_unit_scene(options.scene)) {
    throw golden::InputError(options.scene, "the file", "a flat scene",
                             "a scene with [[object]]: only such a one has draws and effects");
  }
  golden::UnitScene scene = golden::read_unit_scene(options.scene);
  overlay(options.config, scene.hardware, scene.memory);
  const ScenePlan planned = make_scene_plan(scene);
  if (options.json) {
    std::cout << plan_json(planned).dump(2) << '\n';
  } else {
    print_plan(planned);
  }
}

}  // namespace

void add_plan_command(CLI::App& app) {
  auto options = std::make_shared<PlanOptions>();
  CLI::App* command = app.add_subcommand(
      "plan", "What a scene's effects add to the unit, and what a pixel will cost");
  command->add_option("scene", options->scene, "Scene, TOML (docs/spec/scene.md)")->required();
  add_config_options(*command, options->config);
  command->add_flag("--json", options->json, "The same as JSON");
  command->callback([options] { plan(*options); });
}

}  // namespace ptm::testbench
