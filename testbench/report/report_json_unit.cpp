#include "testbench/report/report_json.h"
#include "testbench/report/unit_figures.h"

namespace ptm::testbench {
namespace {

using Json = nlohmann::ordered_json;

Json name_or_null(const std::string& name) { return name.empty() ? Json(nullptr) : Json(name); }

Json draw_json(const UnitDraw& draw) {
  Json json = {{"object", draw.object},
               {"texture", name_or_null(draw.texture)},
               {"color", name_or_null(draw.color)},
               {"cycles_per_pixel", draw.cycles_per_pixel}};
  if (!draw.effects.empty()) json["effects"] = draw.effects;
  return json;
}

Json timing_json(const reference::UnitConfig& config, const UnitTiming& timing) {
  Json counters = Json::object();
  for (std::size_t n = 0; n < reference::kUnitCounters; ++n) {
    if (!knows(timing, n)) continue;
    if (!timing.estimate && !has_counter(config, n)) continue;
    const bool spared = contract::spared_counter(static_cast<reference::UnitCounter>(n));
    if (spared && timing.counters.value[n] == 0) continue;
    counters[std::string(reference::unit_counter_names()[n])] = timing.counters.value[n];
  }
  return {{"estimate", timing.estimate},
          {"counters", std::move(counters)},
          {"lines_per_window", timing.lines_per_window}};
}

}  // namespace

Json unit_json(const UnitSection& unit) {
  Json json = {{"memory", unit.memory},           {"window", unit.window},
               {"draws", Json::array()},          {"timings", Json::object()},
               {"late_pixels", unit.late_pixels}, {"differing_counters", unit.differing_counters}};
  if (!unit.effect_blocks.empty()) json["effect_blocks"] = unit.effect_blocks;
  for (const UnitDraw& draw : unit.draws) json["draws"].push_back(draw_json(draw));
  for (const UnitTiming& timing : unit.timings) {
    json["timings"][timing.model] = timing_json(unit.config, timing);
  }
  return json;
}

}  // namespace ptm::testbench
