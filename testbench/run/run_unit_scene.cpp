#include "testbench/run/run_unit_scene.h"

#include <algorithm>
#include <memory>

#include "model/reference/unit/shade.h"
#include "testbench/config/configuration.h"
#include "testbench/run/edge_samples.h"
#include "testbench/run/prepare_rtl.h"
#include "testbench/run/stopwatch.h"
#include "testbench/run/unit_probe.h"
#include "testbench/run/unit_rtl.h"
#include "testbench/run/unit_section.h"

namespace ptm::testbench {
namespace {

using Pixels = std::vector<std::vector<reference::UnitPixel>>;  ///< [frame][fragment]

bool names(const golden::UnitScene& scene, const std::string& model) {
  return std::find(scene.models.begin(), scene.models.end(), model) != scene.models.end();
}

std::vector<Counter> named(const reference::UnitConfig& unit,
                           const reference::UnitCounters& counters) {
  std::vector<Counter> list;
  for (std::size_t i = 0; i < counters.value.size(); ++i) {
    if (!has_counter(unit, i)) continue;
    // A scene without effects has no row for theirs.
    const bool spared = contract::spared_counter(static_cast<reference::UnitCounter>(i));
    if (spared && counters.value[i] == 0) continue;
    list.push_back({std::string(reference::unit_counter_names()[i]), counters.value[i]});
  }
  return list;
}

ModelResult model_result(const UnitJob& job, const UnitTimed& timed, const Pixels& pixels) {
  ModelResult result;
  result.model = timed.model;
  result.seconds = timed.seconds;
  const reference::UnitCounters counters = total_counters(timed);
  if (job.unit.counters) result.cycles = counters[reference::UnitCounter::cycles];
  result.counters = named(job.unit, counters);
  for (const auto& frame : pixels) result.frames.push_back(unit_image(job.scene, frame));
  return result;
}

/// The reference's pictures for every preset that can express the scene's lights; first those of
/// the run's own configuration if it is none.
void add_presets(const UnitJob& job, const Pixels& own, RunResult& result) {
  std::vector<reference::Preset> rows(reference::kPresets.begin(), reference::kPresets.end());
  const std::string own_name = name_of(job.config);
  if (!is_preset(job.config)) rows.insert(rows.begin(), {own_name, job.config});
  for (const auto& [name, config] : rows) {
    PresetFrames frames{std::string(name), {}};
    try {
      std::vector<std::string> notes;
      const bool same = config == job.config;
      const reference::UnitState state =
          same ? job.state : make_unit_state(job.scene, job.textures, job.extras, config, notes);
      for (std::size_t n = 0; n < job.frames.size(); ++n) {
        std::vector<reference::UnitPixel> pixels = own[n];
        if (!same) {
          const auto fragments =
              make_unit_fragments(job.scene, config, state, job.frames[n].samples, n);
          reference::shade_all(config, state, fragments, pixels);
        }
        frames.frames.push_back(unit_image(job.scene, pixels));
      }
      result.presets.push_back(std::move(frames));
    } catch (const golden::InputError& error) {
      result.notes.push_back("preset " + frames.preset + " is left out of the table: found " +
                             error.found() + ", expected " + error.expected());
    }
  }
}

FrameLight frame_light(const golden::LightSpec& light) {
  using Kind = FrameLight::Kind;
  const Kind kind = light.kind == golden::LightKind::local   ? Kind::local
                    : light.kind == golden::LightKind::point ? Kind::position
                                                             : Kind::direction;
  return {light.vector[0], light.vector[1], light.vector[2], kind};
}

void describe_scene(const UnitJob& job, RunResult& result) {
  result.scene_file = job.scene.file.string();
  for (const golden::LoadedTexture& texture : job.textures) {
    result.map_file += (result.map_file.empty() ? "" : ", ") + texture.name;
    for (const std::string& note : texture.notes) {
      result.notes.push_back("texture " + texture.name + ": " + note);
    }
  }
  result.map_format = "texture unit";
  result.preset = name_of(job.config);
  result.config.evaluator = job.config;
  result.config.tmus = job.unit.tmus;
  result.config.unit = {
      job.unit,
      job.memory,
      job.scene.stress,
      {job.scene.traversal, job.scene.tile, job.scene.keep_cache, job.scene.draw_twice}};
  result.width = job.scene.size[0];
  result.height = job.scene.size[1];
  for (const golden::LightSpec& light : job.scene.lights) {
    result.lights.push_back(frame_light(light));
  }
  result.notes.insert(result.notes.end(), job.notes.begin(), job.notes.end());
  // What is seen does not depend on the light.
  if (job.frames.front().fragments.empty()) {
    result.notes.push_back("the camera sees no object: every pixel is the background");
  }
}

/// Pixels whose point sample lies on an edge between texels; empty if none does.
std::vector<std::uint8_t> unit_edge_pixels(const UnitJob& job) {
  const auto width = static_cast<std::size_t>(job.scene.size[0]);
  std::vector<std::uint8_t> on_edge(width * static_cast<std::size_t>(job.scene.size[1]), 0);
  bool any = false;
  for (const golden::SurfaceSample& s : job.frames.front().samples) {
    if (!on_texel_edge(s.u, s.v, s.lod, job.state.draws[static_cast<std::size_t>(s.draw)]))
      continue;
    on_edge[static_cast<std::size_t>(s.y) * width + static_cast<std::size_t>(s.x)] = 1;
    any = true;
  }
  if (!any) on_edge.clear();
  return on_edge;
}

using Children = std::vector<std::pair<std::string, ChildProcess>>;

/// The timed models that the scene names, and loose beside the timing exact.
Children start_timed_models(const UnitJob& job) {
  if (names(job.scene, "rtl")) prepare_rtl_unit(job.config, job.unit);
  Children children;
  for (const std::string model : {"pipeline", "loose", "rtl"}) {
    if (names(job.scene, model == "loose" ? "pipeline" : model)) {
      children.emplace_back(model, start_unit_model(job, model));
    }
  }
  return children;
}

/// The RTL's own pixels; none of frames that a fault kept from being drawn.
Pixels own_pixels(const UnitTimed& rtl, std::size_t frames) {
  Pixels pixels;
  for (const pipeline::UnitFrameResult& frame : rtl.frames) pixels.push_back(frame.pixels);
  pixels.resize(frames);
  return pixels;
}

/// Waits for the timed models; each but loose adds its pictures: loose's would be the reference's
/// once more.
std::vector<UnitTimed> take_timed_models(Children& children, const UnitJob& job,
                                         const Pixels& pixels, SceneRun& run) {
  std::vector<UnitTimed> timed;
  for (auto& [model, child] : children) {
    const UnitTimed& unit = timed.emplace_back(take_unit_model(child, model));
    for (const pipeline::UnitFrameResult& frame : unit.frames) {
      if (frame.fault) run.faults.push_back(model + ": " + frame.fault->what);
    }
    if (model == "loose") continue;
    run.result.models.push_back(
        model_result(job, unit, model == "rtl" ? own_pixels(unit, pixels.size()) : pixels));
  }
  return timed;
}

}  // namespace

SceneRun run_unit_scene(const golden::UnitScene& scene) {
  const auto job = std::make_shared<const UnitJob>(make_unit_job(scene));
  SceneRun run;
  run.unit = job->unit;
  RunResult& result = run.result;
  describe_scene(*job, result);
  result.edge_pixels = unit_edge_pixels(*job);
  Children children = start_timed_models(*job);
  if (names(scene, "golden")) result.models.push_back(render_unit_golden(*job));
  const Stopwatch watch;
  const Pixels pixels = unit_pixels(*job);
  const double seconds = watch.seconds();
  if (names(scene, "reference")) {
    ModelResult& reference = result.models.emplace_back();
    reference.model = "reference";
    reference.seconds = seconds;
    for (const auto& frame : pixels) reference.frames.push_back(unit_image(scene, frame));
  }
  if (names(scene, "golden")) add_presets(*job, pixels, result);
  std::vector<UnitTimed> timed = take_timed_models(children, *job, pixels, run);
  if (!timed.empty()) result.unit = make_unit_section(*job, timed);
  if (names(scene, "pipeline") && names(scene, "rtl")) run.late_pixels = result.unit->late_pixels;
  result.probe = make_unit_probe(job, std::move(timed));
  return run;
}

}  // namespace ptm::testbench
