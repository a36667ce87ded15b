#include "testbench/run/run_scene.h"

#include <algorithm>
#include <map>
#include <memory>
#include <optional>

#include "golden/files/ptm_file.h"
#include "golden/files/ptm_header.h"
#include "golden/scene/flat_samples.h"
#include "testbench/config/configuration.h"
#include "testbench/run/edge_samples.h"
#include "testbench/run/light_advice.h"
#include "testbench/run/picture_models.h"
#include "testbench/run/pixel_probe.h"
#include "testbench/run/prepare_rtl.h"
#include "testbench/run/timed_models.h"

namespace ptm::testbench {
namespace {

using CyclesByModel = std::map<std::string, std::vector<std::vector<pipeline::Cycle>>>;

bool names(const golden::Scene& scene, const std::string& model) {
  return std::find(scene.models.begin(), scene.models.end(), model) != scene.models.end();
}

/// What a scene's [hardware] says. The pipeline holds a map in the unit's memory.
Configuration configuration_of(const golden::Scene& scene) {
  const golden::Settings none;
  const SettingsOf settings{scene.file.string(), scene.hardware, none};
  return names(scene, "pipeline") ? make_unit_configuration(settings)
                                  : make_configuration(settings);
}

/// Parameters that were named and mean nothing here.
void note_idle_parameters(const Configuration& configuration, std::vector<std::string>& notes) {
  std::string idle;
  for (const golden::Setting& setting : configuration.named) {
    const bool unit = reference::find_parameter<reference::UnitConfig>(setting.name).has_value();
    if (unit && setting.name != "tmus") idle += (idle.empty() ? "" : ", ") + setting.name;
  }
  if (idle.empty()) return;
  notes.push_back("of a flat map only the evaluator and the number of TMUs matter, not " + idle);
}

FlatJob make_job(const golden::Scene& scene, const Configuration& configuration,
                 golden::PtmFile&& file) {
  FlatJob job;
  job.name = scene.file.string();
  job.map_file = scene.map;
  job.map = std::move(file.map);
  job.width = scene.size ? (*scene.size)[0] : job.map.width;
  job.height = scene.size ? (*scene.size)[1] : job.map.height;
  job.lights = scene.lights;
  job.tmus = configuration.unit.tmus;
  choose_config(job, configuration.eval);
  return job;
}

/// A light outside of the unit disc is drawn, since polynomials extrapolate, but seldom meant.
void note_extrapolation(const golden::Light& light, std::vector<std::string>& notes) {
  const std::string advice = light_advice(light.u, light.v);
  if (!advice.empty()) notes.push_back(light.place + ": the map is extrapolated. " + advice);
}

/// The reference's pictures for every preset that can express the scene's lights, for the table of
/// the hardware's error against golden; first those of the run's own configuration if it is none.
void add_presets(const FlatJob& job, const ModelResult* reference, RunResult& result) {
  if (reference && !is_preset(job.config)) {
    result.presets.push_back({name_of(job.config), reference->frames});
  }
  for (const reference::Preset& preset : reference::kPresets) {
    const std::string name(preset.name);
    if (reference && preset.config == job.config) {
      result.presets.push_back({name, reference->frames});
      continue;
    }
    try {
      check_hardware_limits(job, preset.config);
      result.presets.push_back(
          {name, reference_frames(job, preset.config, store_map(job.map, preset.config))});
    } catch (const golden::InputError& error) {
      result.notes.push_back("preset " + name + " is left out of the table: found " +
                             error.found() + ", expected " + error.expected());
    }
  }
}

/// Pixels whose sample lies on an edge between texels; empty if none does.
std::vector<std::uint8_t> flat_edge_pixels(const FlatJob& job) {
  std::vector<std::uint8_t> on_edge;
  for (int y = 0; y < job.height; ++y) {
    for (int x = 0; x < job.width; ++x) {
      const golden::Sample s = golden::flat_sample(x, y, job.width, job.height, job.lights.front());
      const bool edge = on_texel_edge(s.u, job.map.width, reference::Wrap::clamp) ||
                        on_texel_edge(s.v, job.map.height, reference::Wrap::clamp);
      on_edge.push_back(edge ? 1 : 0);
    }
  }
  if (std::count(on_edge.begin(), on_edge.end(), 1) == 0) on_edge.clear();
  return on_edge;
}

const ModelResult* find(const RunResult& result, const std::string& model) {
  const auto found = std::find_if(result.models.begin(), result.models.end(),
                                  [&](const ModelResult& m) { return m.model == model; });
  return found == result.models.end() ? nullptr : &*found;
}

/// Pixels whose cycles differ; nothing unless both models ran.
std::optional<std::uint64_t> count_late_pixels(const CyclesByModel& cycles) {
  if (!cycles.contains("pipeline") || !cycles.contains("rtl")) return {};
  std::uint64_t late = 0;
  for (std::size_t frame = 0; frame < cycles.at("rtl").size(); ++frame) {
    const auto& x = cycles.at("pipeline")[frame];
    const auto& y = cycles.at("rtl")[frame];
    for (std::size_t i = 0; i < x.size(); ++i) late += x[i] != y[i] ? 1U : 0U;
  }
  return late;
}

}  // namespace

SceneRun run_scene(const golden::Scene& scene) {
  const Configuration configuration = configuration_of(scene);  // before anything is read
  const golden::PtmMap header = golden::read_ptm_header(scene.map).map;
  check_hardware_size(scene.map, header.width, header.height);  // before the rest is read
  golden::PtmFile file = golden::read_ptm(scene.map);
  SceneRun run;
  RunResult& result = run.result;
  result.notes = file.info.notes;
  note_idle_parameters(configuration, result.notes);
  for (const golden::Light& light : scene.lights) note_extrapolation(light, result.notes);
  result.map_format = file.info.format;
  const auto job = std::make_shared<const FlatJob>(make_job(scene, configuration, std::move(file)));
  result.scene_file = job->name;
  result.map_file = job->map_file.string();
  result.preset = name_of(job->config);
  result.config.evaluator = job->config;
  result.config.tmus = job->tmus;
  result.width = job->width;
  result.height = job->height;
  for (const golden::Light& light : job->lights) result.lights.push_back({light.u, light.v, 0});
  result.notes.push_back("the map was " + job->hardware.how);
  result.edge_pixels = flat_edge_pixels(*job);

  std::optional<ChildProcess> timing, rtl;  // forked before any thread of this process starts
  if (names(scene, "rtl")) prepare_rtl_evaluator(job->config);
  if (names(scene, "pipeline")) timing.emplace(start_pipeline(*job));
  if (names(scene, "rtl")) rtl.emplace(start_rtl(*job));
  if (names(scene, "golden")) result.models.push_back(render_golden(*job));
  if (names(scene, "reference")) result.models.push_back(render_reference(*job));
  if (find(result, "golden")) add_presets(*job, find(result, "reference"), result);

  CyclesByModel cycles;
  for (auto* child : {&timing, &rtl}) {
    if (!*child) continue;
    const std::string model = child == &timing ? "pipeline" : "rtl";
    TimedResult timed = take_result(**child, model, *job);
    result.models.push_back(std::move(timed.model));
    cycles[model] = std::move(timed.cycles);
  }
  run.late_pixels = count_late_pixels(cycles);
  if (run.late_pixels) {
    result.notes.push_back("pipeline and rtl let " + std::to_string(*run.late_pixels) +
                           " pixels go in different cycles, counted from the first operand");
  }
  result.probe = make_probe(job, std::move(cycles));
  return run;
}

}  // namespace ptm::testbench
