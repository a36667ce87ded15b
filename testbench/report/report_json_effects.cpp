#include <cmath>

#include "testbench/report/report_json.h"

namespace ptm::testbench {
namespace {

using Json = nlohmann::ordered_json;
using reference::UnitCounter;

Json cells_json(const std::optional<UnitCells>& cells) {
  if (!cells) return nullptr;
  return {{"cells", cells->cells},
          {"multipliers", cells->multipliers},
          {"adders", cells->adders},
          {"memory_bits", cells->memory_bits}};
}

Json run_json(const EffectRun& run) {
  const auto count = [&](UnitCounter n) {
    return run.counters ? Json((*run.counters)[n]) : Json(nullptr);
  };
  return {{"cycles", count(UnitCounter::cycles)},
          {"words", count(UnitCounter::words)},
          {"lines_read", count(UnitCounter::lines_read)},
          {"multiplies",
           {{"address", count(UnitCounter::multiplies_address)},
            {"filter", count(UnitCounter::multiplies_filter)},
            {"eval", count(UnitCounter::multiplies_eval)},
            {"combine", count(UnitCounter::multiplies_combine)},
            {"effects", count(UnitCounter::multiplies_effects)}}},
          {"rtl", cells_json(run.cells)}};
}

Json times_json(const EffectRun& run) {
  Json seconds = Json::object();
  for (const auto& [model, time] : run.seconds) seconds[model] = time;
  return seconds;
}

}  // namespace

Json effect_costs_json(const EffectCosts& costs) {
  Json json = {{"with", run_json(costs.with)}, {"without", Json::array()}, {"notes", costs.notes}};
  for (const EffectCost& cost : costs.costs) {
    Json one = {{"effect", cost.effect}, {"together", cost.together}};
    one.update(run_json(cost.without));
    one["picture"] = {{"changed", cost.changed},
                      {"rmse", cost.rmse},
                      {"max", cost.largest},
                      {"psnr_db", std::isinf(cost.psnr_db) ? Json(nullptr) : Json(cost.psnr_db)}};
    json["without"].push_back(std::move(one));
  }
  return json;
}

Json effect_times_json(const EffectCosts& costs) {
  Json json = {{"with", times_json(costs.with)}, {"without", Json::array()}};
  for (const EffectCost& cost : costs.costs) {
    json["without"].push_back({{"effect", cost.effect}, {"seconds", times_json(cost.without)}});
  }
  return json;
}

}  // namespace ptm::testbench
