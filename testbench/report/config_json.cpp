#include "testbench/report/config_json.h"

#include "testbench/plan/effect_rows.h"

namespace ptm::testbench {
namespace {

using Json = nlohmann::ordered_json;

Json evaluator_json(const reference::EvalConfig& config) {
  const bool nearest = config.rounding == reference::Rounding::nearest;
  return {{"coef_bits", config.coef_bits},
          {"delta_bits", config.delta_bits},
          {"light_int", config.light_int},
          {"light_frac", config.light_frac},
          {"basis_frac", config.basis_frac},
          {"guard", config.guard},
          {"rounding", nearest ? "nearest" : "truncate"},
          {"lum_bits", config.lum_bits},
          {"lum_frac", config.lum_frac},
          {"shift_min", config.shift_min},
          {"shift_groups", config.shift_groups},
          {"filter_frac", config.filter_frac}};
}

Json unit_json(const reference::UnitConfig& config) {
  return {{"tmus", config.tmus},
          {"cache_kib", config.cache_kib},
          {"ways", config.ways},
          {"fragment_fifo", config.fragment_fifo},
          {"miss_fifo", config.miss_fifo},
          {"palette_lrgb_ports", config.palette_lrgb_ports},
          {"palette_rgb_ports", config.palette_rgb_ports},
          {"eval_lanes", config.eval_lanes},
          {"counters", config.counters},
          {"duplicate_lines", config.duplicate_lines}};
}

bool has_parts_for_effects(const reference::UnitConfig& config) {
  return config.half_vector || config.extra_sets != 0 || config.extra_passes != 0 ||
         config.stages != 0;
}

Json effects_json(const reference::UnitConfig& config) {
  Json stages = Json::array();
  for (const StageRow& stage : stage_rows()) {
    if ((config.stages >> stage.number & 1U) != 0) stages.push_back(stage.id);
  }
  return {{"half_vector", config.half_vector},
          {"extra_sets", config.extra_sets},
          {"extra_passes", config.extra_passes},
          {"stages", std::move(stages)}};
}

Json memory_json(const pipeline::FixedMemory& memory) {
  return {{"kind", "fixed"}, {"latency", memory.latency}, {"interval", memory.interval}};
}

Json memory_json(const pipeline::DramMemory& memory) {
  return {{"kind", "dram"},        {"banks", memory.banks},      {"page_lines", memory.page_lines},
          {"tRCD", memory.tRCD},   {"tRP", memory.tRP},          {"CL", memory.CL},
          {"tRAS", memory.tRAS},   {"tREFI", memory.tREFI},      {"tRFC", memory.tRFC},
          {"burst", memory.burst}, {"overhead", memory.overhead}};
}

Json memory_json(const pipeline::RandomMemory& memory) {
  return {{"kind", "random"},
          {"seed", memory.seed},
          {"latency_min", memory.latency_min},
          {"latency_max", memory.latency_max}};
}

Json stress_json(const golden::StressSpec& stress) {
  return {{"input_gap", stress.input_gap},
          {"output_stall", stress.output_stall},
          {"seed", stress.seed}};
}

Json frames_json(const FrameOrder& frames) {
  const bool tiles = frames.traversal == golden::Traversal::tiles;
  return {{"traversal", tiles ? "tiles" : "scan"},
          {"tile", frames.tile},
          {"keep_cache", frames.keep_cache},
          {"draw_twice", frames.draw_twice}};
}

}  // namespace

Json config_json(const RunConfig& config) {
  Json json = {{"evaluator", evaluator_json(config.evaluator)}};
  if (!config.unit) {
    json["unit"] = {{"tmus", config.tmus}};
    return json;
  }
  json["unit"] = unit_json(config.unit->unit);
  if (has_parts_for_effects(config.unit->unit)) {
    json["effects"] = effects_json(config.unit->unit);
  }
  json["memory"] =
      std::visit([](const auto& memory) { return memory_json(memory); }, config.unit->memory);
  json["stress"] = stress_json(config.unit->stress);
  json["frames"] = frames_json(config.unit->frames);
  return json;
}

}  // namespace ptm::testbench
