#include "testbench/report/html_effects.h"

#include "testbench/report/html_table.h"
#include "testbench/report/html_text.h"

namespace ptm::testbench::html {
namespace {

using reference::UnitCounter;

/// "+1,024" and what that is of the whole; "0" if nothing changed.
std::string signed_count(std::uint64_t with, std::uint64_t without) {
  if (with == without) return "0";
  const std::uint64_t size = with > without ? with - without : without - with;
  const std::string part =
      with > 0 ? "<small>" + share(static_cast<double>(size) / static_cast<double>(with)) +
                     " of the scene's</small>"
               : "";
  return (with > without ? "+" : "−") + grouped(size) + part;
}

std::string counter_cell(const EffectRun& with, const EffectRun& without, UnitCounter n) {
  if (!with.counters || !without.counters) return "–";
  return signed_count((*with.counters)[n], (*without.counters)[n]);
}

std::uint64_t multiplies(const reference::UnitCounters& n) {
  return n[UnitCounter::multiplies_address] + n[UnitCounter::multiplies_filter] +
         n[UnitCounter::multiplies_eval] + n[UnitCounter::multiplies_combine] +
         n[UnitCounter::multiplies_effects];
}

std::string multiplies_cell(const EffectRun& with, const EffectRun& without) {
  if (!with.counters || !without.counters) return "–";
  return signed_count(multiplies(*with.counters), multiplies(*without.counters));
}

std::string cell_cell(const std::optional<UnitCells>& with, const std::optional<UnitCells>& without,
                      std::uint64_t UnitCells::*count) {
  return with && without ? signed_count((*with).*count, (*without).*count) : "–";
}

std::string effect_head(const EffectCost& cost) {
  std::string head = html_escape(cost.effect);
  std::string others;
  for (const std::string& name : cost.together) {
    others += (others.empty() ? "" : ", ") + html_escape(name);
  }
  return others.empty() ? head : head + "<small>and with it " + others + "</small>";
}

void add_cost_table(std::string& page, const EffectCosts& costs) {
  open_table(page, "effects", "What the scene costs with each effect, less what it costs without",
             {"effect", "cycles", "words", "lines read", "multiplies", "RTL cells", "multipliers",
              "memory bits", "samples changed", "RMSE, levels"});
  for (const EffectCost& cost : costs.costs) {
    const EffectRun &with = costs.with, &without = cost.without;
    add_row(page, "",
            {effect_head(cost), counter_cell(with, without, UnitCounter::cycles),
             counter_cell(with, without, UnitCounter::words),
             counter_cell(with, without, UnitCounter::lines_read),
             multiplies_cell(with, without),
             cell_cell(with.cells, without.cells, &UnitCells::cells),
             cell_cell(with.cells, without.cells, &UnitCells::multipliers),
             cell_cell(with.cells, without.cells, &UnitCells::memory_bits), share(cost.changed),
             levels(cost.rmse)});
  }
  close_table(page);
}

/// Seconds of a model, or nothing if it did not run.
std::optional<double> seconds_of(const EffectRun& run, const std::string& model) {
  for (const auto& [name, seconds] : run.seconds) {
    if (name == model) return seconds;
  }
  return std::nullopt;
}

void add_time_table(std::string& page, const EffectCosts& costs) {
  Row heads = {"drawn"};
  for (const auto& [model, seconds] : costs.with.seconds) heads.push_back(html_escape(model));
  open_table(page, "effects", "Time of each model: the scene, and the scene without each effect",
             heads);
  Row whole = {"the scene"};
  for (const auto& [model, seconds] : costs.with.seconds) whole.push_back(duration(seconds));
  add_row(page, "", whole);
  for (const EffectCost& cost : costs.costs) {
    Row row = {"without " + effect_head(cost)};
    for (const auto& [model, seconds] : costs.with.seconds) {
      const auto without = seconds_of(cost.without, model);
      row.push_back(without ? duration(*without) : "–");
    }
    add_row(page, "", row);
  }
  close_table(page);
}

}  // namespace

void add_effect_costs(std::string& page, const RunResult& result) {
  if (!result.costs || (result.costs->costs.empty() && result.costs->notes.empty())) return;
  open_section(page, "effects", "What each effect costs");
  add_cost_table(page, *result.costs);
  add_time_table(page, *result.costs);
  for (const std::string& note : result.costs->notes) page += "<p>" + html_escape(note) + "</p>\n";
  page += "</section>\n";
}

}  // namespace ptm::testbench::html
