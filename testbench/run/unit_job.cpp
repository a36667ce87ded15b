#include "testbench/run/unit_job.h"

#include <algorithm>
#include <cmath>

#include "model/reference/light_code.h"

namespace ptm::testbench {
namespace {

using golden::InputError;
using golden::UnitScene;
using reference::EvalConfig;
using reference::UnitFragment;

reference::UnitConfig unit_config(const UnitScene& scene) {
  const golden::HardwareSpec& hardware = scene.hardware;
  reference::UnitConfig unit;
  unit.tmus = hardware.tmus;
  unit.cache_kib = hardware.cache_kib;
  unit.ways = hardware.ways;
  unit.fragment_fifo = hardware.fragment_fifo;
  unit.miss_fifo = hardware.miss_fifo;
  unit.palette_lrgb_ports = hardware.palette_lrgb_ports;
  unit.palette_rgb_ports = hardware.palette_rgb_ports;
  unit.eval_lanes = hardware.eval_lanes;
  unit.counters = hardware.counters;
  unit.duplicate_lines = hardware.duplicate_lines;
  try {
    validate(unit);
  } catch (const std::invalid_argument& error) {
    throw InputError(scene.file.string(), hardware.place, error.what(),
                     "a unit that can be built (docs/spec/unit-timing.md)");
  }
  return unit;
}

pipeline::MemoryModel memory_model(const golden::MemorySpec& spec) {
  const auto cycles = [](int n) { return static_cast<pipeline::Cycle>(n); };
  switch (spec.kind) {
    case golden::MemoryKind::dram: {
      pipeline::DramMemory dram;
      dram.banks = spec.banks;
      dram.page_lines = spec.page_lines;
      dram.tRCD = cycles(spec.t_rcd);
      dram.tRP = cycles(spec.t_rp);
      dram.CL = cycles(spec.cl);
      dram.tRAS = cycles(spec.t_ras);
      dram.tREFI = cycles(spec.t_refi);
      dram.tRFC = cycles(spec.t_rfc);
      dram.burst = cycles(spec.burst);
      dram.overhead = cycles(spec.overhead);
      return dram;
    }
    case golden::MemoryKind::random:
      return pipeline::RandomMemory{spec.seed, cycles(spec.latency_min), cycles(spec.latency_max)};
    case golden::MemoryKind::fixed:
      break;
  }
  return pipeline::FixedMemory{cycles(spec.latency), cycles(spec.interval)};
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
    return "fixed: " + std::to_string(fixed->latency) + " cycles to an answer, " +
           std::to_string(fixed->interval) + " from one to the next";
  }
  if (const auto* random = std::get_if<pipeline::RandomMemory>(&memory)) {
    return "random: " + std::to_string(random->latency_min) + " to " +
           std::to_string(random->latency_max) + " cycles, out of order, seed " +
           std::to_string(random->seed);
  }
  const auto& dram = std::get<pipeline::DramMemory>(memory);
  return "paged DRAM: " + std::to_string(dram.banks) + " banks, pages of " +
         std::to_string(dram.page_lines) + " lines, tRCD " + std::to_string(dram.tRCD) + ", tRP " +
         std::to_string(dram.tRP) + ", CL " + std::to_string(dram.CL) + ", refresh every " +
         std::to_string(dram.tREFI);
}

EvalConfig scene_eval_config(const UnitScene& scene) {
  try {
    EvalConfig config = reference::find_preset(scene.hardware.preset).config;
    if (scene.hardware.shift_groups) config.shift_groups = *scene.hardware.shift_groups;
    return config;
  } catch (const std::invalid_argument&) {
    throw InputError(scene.file.string(), scene.hardware.preset_place,
                     "preset '" + scene.hardware.preset + "'", "paper8, base or wide");
  }
}

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
              ", which is what light_int = " + std::to_string(config.light_int) +
              " of the preset can express");
    }
    fragments.push_back(*fragment);
  }
  return fragments;
}

ScenePlan make_scene_plan(const UnitScene& scene) {
  UnitScene prepared = scene;
  golden::LoadedTextures textures = golden::load_textures(scene);
  const auto extras = golden::prepare_effects(prepared, textures);
  return plan_scene(prepared, textures, extras, scene_eval_config(scene), unit_config(scene));
}

UnitJob make_unit_job(const UnitScene& scene) {
  UnitJob job;
  job.scene = scene;
  job.preset = scene.hardware.preset;
  job.config = scene_eval_config(scene);
  job.memory = memory_model(scene.memory);
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
  job.plan = plan_scene(job.scene, job.textures, job.extras, job.config, unit_config(scene));
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
