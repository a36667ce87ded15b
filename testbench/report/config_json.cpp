#include "testbench/report/config_json.h"

#include <algorithm>
#include <array>
#include <span>

#include "testbench/config/configuration.h"
#include "testbench/plan/effect_rows.h"

namespace ptm::testbench {
namespace {

using Json = nlohmann::ordered_json;

/// A parameter's value: a number, true or false, or a word.
Json value_json(const reference::ParameterRow& row, std::int64_t value) {
  switch (row.kind) {
    case reference::ParameterKind::flag: return value != 0;
    case reference::ParameterKind::choice: return row.choices[static_cast<std::size_t>(value)];
    case reference::ParameterKind::number: return value;
  }
  return nullptr;
}

/// Every parameter of a configuration by its name, but for those of other tables of the report.
template <class Config>
Json parameters_json(const Config& config, std::span<const std::string_view> without = {}) {
  using Table = reference::ParameterTable<Config>;
  Json json = Json::object();
  for (std::size_t i = 0; i < Table::kCount; ++i) {
    const reference::ParameterRow& row = Table::rows()[i];
    if (std::find(without.begin(), without.end(), row.name) != without.end()) continue;
    json[std::string(row.name)] = value_json(row, Table::get(config, i));
  }
  return json;
}

/// What a unit is built with for effects alone has a table of its own, with stages by their names.
constexpr std::array<std::string_view, 4> kEffectParts{"half_vector", "extra_sets", "extra_passes",
                                                       "stages"};

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

Json memory_json(const pipeline::MemoryModel& memory) {
  Json json = {{"kind", memory_kind(memory)}};
  json.update(std::visit([](const auto& model) { return parameters_json(model); }, memory));
  return json;
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
  Json json = {{"evaluator", parameters_json(config.evaluator)}};
  if (!config.unit) {
    json["unit"] = {{"tmus", config.tmus}};
    return json;
  }
  json["unit"] = parameters_json(config.unit->unit, kEffectParts);
  if (has_parts_for_effects(config.unit->unit)) {
    json["effects"] = effects_json(config.unit->unit);
  }
  json["memory"] = memory_json(config.unit->memory);
  json["stress"] = stress_json(config.unit->stress);
  json["frames"] = frames_json(config.unit->frames);
  return json;
}

}  // namespace ptm::testbench
