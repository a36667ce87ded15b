#include "testbench/run/unit_job.h"

#include <algorithm>
#include <cmath>

#include "golden/files/figure_text.h"
#include "model/reference/light_code.h"
#include "testbench/config/configuration.h"

namespace ptm::testbench {
namespace {

using golden::InputError;
using golden::UnitScene;
using reference::EvalConfig;
using reference::UnitFragment;

Configuration configuration_of(const UnitScene& scene) {
  return make_unit_configuration({scene.file.string(), scene.hardware, scene.memory});
}

/// A parameter that the scene names itself and that its effects want more of.
void check_named(const UnitScene& scene, const Configuration& configuration,
                 const reference::UnitConfig& planned) {
  using Table = reference::ParameterTable<reference::UnitConfig>;
  for (std::size_t i = 0; i < Table::kCount; ++i) {
    const reference::ParameterRow& row = Table::rows()[i];
    const golden::Setting* named = configuration.find_named(row.name);
    if (!named || Table::get(planned, i) == Table::get(configuration.unit, i)) continue;
    throw InputError(scene.file.string(), named->place, std::string(row.name) + " = " + named->text,
                     reference::parameter_text(row, Table::get(planned, i)) +
                         ", which the scene's effects need");
  }
}

ScenePlan plan_of(const UnitScene& prepared, const golden::LoadedTextures& textures,
                  const std::vector<golden::DrawExtras>& extras,
                  const Configuration& configuration) {
  ScenePlan plan = plan_scene(prepared, textures, extras, configuration.eval, configuration.unit);
  check_named(prepared, configuration, plan.unit);
  return plan;
}

std::string number(double x) {
  std::string text = std::to_string(x);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

std::string light_place(const UnitScene& scene, std::size_t frame) {
  return scene.lights[frame].place;
}

}  // namespace

std::string describe(const pipeline::MemoryModel& memory) {
  if (const auto* fixed = std::get_if<pipeline::FixedMemory>(&memory)) {
    return "fixed: " + golden::count_of(fixed->latency, "cycle") + " to an answer, " +
           std::to_string(fixed->interval) + " from one to the next";
  }
  if (const auto* random = std::get_if<pipeline::RandomMemory>(&memory)) {
    return "random: " + std::to_string(random->latency_min) + " to " +
           std::to_string(random->latency_max) + " cycles, out of order, seed " +
           std::to_string(random->seed);
  }
  const auto& dram = std::get<pipeline::DramMemory>(memory);
  return "paged DRAM: " + golden::count_of(dram.banks, "bank") + ", pages of " +
         golden::count_of(dram.page_lines, "line") + ", tRCD " + std::to_string(dram.tRCD) +
         ", tRP " + std::to_string(dram.tRP) + ", CL " + std::to_string(dram.CL) +
         ", refresh every " + std::to_string(dram.tREFI);
}

EvalConfig scene_eval_config(const UnitScene& scene) { return configuration_of(scene).eval; }

std::vector<UnitFragment> make_unit_fragments(const UnitScene& scene, const EvalConfig& config,
                                              const reference::UnitState& state,
                                              const std::vector<golden::SurfaceSample>& samples,
                                              std::size_t frame) {
  std::vector<UnitFragment> fragments;
  fragments.reserve(samples.size());
  for (const golden::SurfaceSample& s : samples) {
    const auto fragment = reference::quantize_unit_fragment(
        config, state.draws[static_cast<std::size_t>(s.draw)],
        {s.x, s.y, s.u, s.v, s.lod, s.axis_u, s.axis_v, s.probes_log2, s.light_vertex[0],
         s.light_vertex[1], s.half_vertex[0], s.half_vertex[1], s.lit, s.draw});
    if (!fragment) {
      throw InputError(
          scene.file.string(), light_place(scene, frame),
          "light (" + number(s.light_vertex[0]) + ", " + number(s.light_vertex[1]) + ")",
          "coordinates of at most " + number(reference::light_limit(config)) +
              ", which is what light_int = " + std::to_string(config.light_int) + " can express");
    }
    fragments.push_back(*fragment);
  }
  return fragments;
}

ScenePlan make_scene_plan(const UnitScene& scene) {
  const Configuration configuration = configuration_of(scene);  // before anything is loaded
  UnitScene prepared = scene;
  golden::LoadedTextures textures = golden::load_textures(scene);
  const auto extras = golden::prepare_effects(prepared, textures);
  return plan_of(prepared, textures, extras, configuration);
}

UnitJob make_unit_job(const UnitScene& scene) {
  UnitJob job;
  job.scene = scene;
  const Configuration configuration = configuration_of(scene);
  job.config = configuration.eval;
  job.memory = configuration.memory;
  job.timing.seed = scene.stress.seed;
  job.timing.input_gap = scene.stress.input_gap / 256.0;
  job.timing.output_stall = scene.stress.output_stall / 256.0;
  job.textures = golden::load_textures(scene);
  job.notes = golden::mesh_notes(scene);
  job.extras = golden::prepare_effects(job.scene, job.textures);
  for (const golden::DrawExtras& extras : job.extras) {
    for (const std::string& note : extras.notes) {  // several effects may say the same of a map
      const bool said = std::find(job.notes.begin(), job.notes.end(), note) != job.notes.end();
      if (!said) job.notes.push_back(note);
    }
  }
  job.plan = plan_of(job.scene, job.textures, job.extras, configuration);
  job.unit = job.plan.unit;
  job.state = make_unit_state(job.scene, job.textures, job.extras, job.config, job.notes);
  for (std::size_t frame = 0; frame < scene.lights.size(); ++frame) {
    UnitFrameInput& input = job.frames.emplace_back();
    input.samples = golden::make_samples(job.scene, job.textures, static_cast<int>(frame));
    input.fragments = make_unit_fragments(job.scene, job.config, job.state, input.samples, frame);
  }
  return job;
}

}  // namespace ptm::testbench
