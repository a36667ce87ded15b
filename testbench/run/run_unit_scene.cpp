#include "testbench/run/run_unit_scene.h"

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <set>

#include "model/reference/unit/shade.h"
#include "testbench/run/stopwatch.h"
#include "testbench/run/unit_probe.h"

namespace ptm::testbench {
namespace {

constexpr std::uint64_t kWindows = 240;  ///< of the bandwidth chart

bool names(const golden::UnitScene& scene, const std::string& model) {
  return std::find(scene.models.begin(), scene.models.end(), model) != scene.models.end();
}

reference::UnitCounters total(const UnitTimed& timed) {
  reference::UnitCounters sum;
  for (const pipeline::UnitFrameResult& frame : timed.frames) {
    for (std::size_t i = 0; i < sum.value.size(); ++i) sum.value[i] += frame.counters.value[i];
  }
  return sum;
}

std::vector<Counter> named(const reference::UnitCounters& counters) {
  std::vector<Counter> list;
  for (std::size_t i = 0; i < counters.value.size(); ++i) {
    list.push_back({std::string(reference::unit_counter_names()[i]), counters.value[i]});
  }
  return list;
}

/// Lines that arrived a window, frames one after another.
std::vector<std::uint32_t> windows(const UnitTimed& timed, std::uint64_t window) {
  std::vector<std::uint32_t> lines;
  for (const pipeline::UnitFrameResult& frame : timed.frames) {
    const std::size_t first = lines.size();
    const std::uint64_t last = frame.taken.empty() ? 0 : frame.taken.back();
    lines.resize(first + last / window + 1);
    for (const pipeline::Cycle cycle : frame.answered) {
      if (cycle <= last) ++lines[first + cycle / window];
    }
  }
  return lines;
}

ModelResult model_result(const UnitJob& job, const UnitTimed& timed,
                         const std::vector<std::vector<reference::UnitPixel>>& pixels) {
  ModelResult result;
  result.model = timed.model;
  result.seconds = timed.seconds;
  const reference::UnitCounters counters = total(timed);
  result.cycles = counters[reference::UnitCounter::cycles];
  result.counters = named(counters);
  for (const auto& frame : pixels) result.frames.push_back(unit_image(job.scene, frame));
  return result;
}

std::string texture_name(const UnitJob& job, int texture) {
  return texture < 0 ? "" : job.textures[static_cast<std::size_t>(texture)].name;
}

UnitSection make_section(const UnitJob& job, const std::vector<UnitTimed>& timed) {
  UnitSection section;
  section.config = job.unit;
  section.memory = describe(job.memory);
  std::uint64_t cycles = 0;
  for (const UnitTimed& model : timed) {
    cycles = std::max(cycles, total(model)[reference::UnitCounter::cycles]);
  }
  section.window = std::max<std::uint64_t>(1, cycles / kWindows);
  for (std::size_t d = 0; d < job.scene.draws.size(); ++d) {
    const golden::DrawSpec& spec = job.scene.draws[d];
    section.draws.push_back({"draw " + std::to_string(d), texture_name(job, spec.map),
                             texture_name(job, spec.color),
                             warm_cycles_per_pixel(job, static_cast<int>(d))});
  }
  for (const UnitTimed& model : timed) {
    const bool estimate = model.model == "loose";
    section.timings.push_back(
        {model.model, model.seconds, estimate, total(model),
         estimate ? std::vector<std::uint32_t>{} : windows(model, section.window)});
  }
  return section;
}

const UnitTimed* find(const std::vector<UnitTimed>& timed, const std::string& model) {
  const auto found = std::find_if(timed.begin(), timed.end(),
                                  [&](const UnitTimed& t) { return t.model == model; });
  return found == timed.end() ? nullptr : &*found;
}

/// The reference's pictures for every preset that can express the scene's lights.
void add_presets(const UnitJob& job, const std::vector<std::vector<reference::UnitPixel>>& own,
                 RunResult& result) {
  for (const reference::Preset& preset : reference::kPresets) {
    PresetFrames frames{std::string(preset.name), {}};
    reference::EvalConfig config = preset.config;
    if (job.scene.hardware.shift_groups) config.shift_groups = *job.scene.hardware.shift_groups;
    try {
      std::vector<std::string> notes;
      const bool same = frames.preset == job.preset;
      const reference::UnitState state =
          same ? job.state : make_unit_state(job.scene, job.textures, config, notes);
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

void describe_scene(const UnitJob& job, RunResult& result) {
  result.scene_file = job.scene.file.string();
  for (const golden::LoadedTexture& texture : job.textures) {
    result.map_file += (result.map_file.empty() ? "" : ", ") + texture.name;
    for (const std::string& note : texture.notes) result.notes.push_back(note);
  }
  result.map_format = "texture unit";
  result.preset = job.preset;
  result.width = job.scene.size[0];
  result.height = job.scene.size[1];
  for (const golden::LightSpec& light : job.scene.lights) {
    result.lights.push_back({light.vector[0], light.vector[1]});
  }
  result.notes.insert(result.notes.end(), job.notes.begin(), job.notes.end());
}

}  // namespace

std::uint64_t count_late_pixels(const UnitTimed& a, const UnitTimed& b) {
  std::uint64_t late = 0;
  for (std::size_t n = 0; n < std::max(a.frames.size(), b.frames.size()); ++n) {
    static const std::vector<pipeline::Cycle> none;
    const auto& x = n < a.frames.size() ? a.frames[n].taken : none;
    const auto& y = n < b.frames.size() ? b.frames[n].taken : none;
    const std::size_t both = std::min(x.size(), y.size());
    for (std::size_t i = 0; i < both; ++i) late += x[i] != y[i] ? 1U : 0U;
    late += std::max(x.size(), y.size()) - both;
  }
  return late;
}

std::vector<std::string> differing_counters(const UnitTimed& a, const UnitTimed& b) {
  std::set<std::size_t> differing;
  for (std::size_t n = 0; n < std::min(a.frames.size(), b.frames.size()); ++n) {
    for (std::size_t i = 0; i < reference::kUnitCounters; ++i) {
      if (a.frames[n].counters.value[i] != b.frames[n].counters.value[i]) differing.insert(i);
    }
  }
  std::vector<std::string> list;
  for (const std::size_t i : differing) list.emplace_back(reference::unit_counter_names()[i]);
  return list;
}

double warm_cycles_per_pixel(const UnitJob& job, int draw) {
  const reference::Draw& d = job.state.draws[static_cast<std::size_t>(draw)];
  const int groups = (draw_words(d) + job.unit.tmus - 1) / job.unit.tmus;
  const int passes = (draw_passes(d) + job.unit.eval_lanes - 1) / job.unit.eval_lanes;
  double sum = 0, count = 0;
  for (const UnitFrameInput& frame : job.frames) {
    for (const reference::UnitFragment& fragment : frame.fragments) {
      if (fragment.draw != draw) continue;
      const int beats =
          groups * reference::footprint_count(d, fragment) * (1 << fragment.probes_log2);
      sum += std::max(beats, passes);
      ++count;
    }
  }
  return count > 0 ? sum / count : 0;
}

SceneRun run_unit_scene(const golden::UnitScene& scene) {
  const auto job = std::make_shared<const UnitJob>(make_unit_job(scene));
  SceneRun run;
  RunResult& result = run.result;
  describe_scene(*job, result);

  std::vector<std::pair<std::string, ChildProcess>> children;
  for (const char* model : {"pipeline", "loose", "rtl"}) {
    const bool wanted =
        names(scene, model) || (model == std::string("loose") && names(scene, "pipeline"));
    if (wanted) children.emplace_back(model, start_unit_model(*job, model));
  }
  if (names(scene, "golden")) result.models.push_back(render_unit_golden(*job));
  const Stopwatch watch;
  const auto pixels = unit_pixels(*job);
  const double seconds = watch.seconds();
  if (names(scene, "reference")) {
    ModelResult& reference = result.models.emplace_back();
    reference.model = "reference";
    reference.seconds = seconds;
    for (const auto& frame : pixels) reference.frames.push_back(unit_image(scene, frame));
  }
  if (names(scene, "golden")) add_presets(*job, pixels, result);

  std::vector<UnitTimed> timed;
  for (auto& [model, child] : children) {
    UnitTimed& unit = timed.emplace_back(take_unit_model(child, *job, model));
    for (const pipeline::UnitFrameResult& frame : unit.frames) {
      if (frame.fault) run.faults.push_back(model + ": " + frame.fault->what);
    }
    if (model == "loose") continue;  // its pixels would be the reference's once more
    auto own = pixels;
    if (model == "rtl") {
      for (std::size_t n = 0; n < own.size(); ++n) own[n] = unit.frames[n].pixels;
    }
    result.models.push_back(model_result(*job, unit, own));
  }
  if (!timed.empty()) result.unit = make_section(*job, timed);
  const UnitTimed* exact = find(timed, "pipeline");
  const UnitTimed* rtl = find(timed, "rtl");
  if (exact && rtl) {
    run.late_pixels = result.unit->late_pixels = count_late_pixels(*exact, *rtl);
    result.unit->differing_counters = differing_counters(*exact, *rtl);
  }
  result.probe = make_unit_probe(job, std::move(timed));
  return run;
}

}  // namespace ptm::testbench
