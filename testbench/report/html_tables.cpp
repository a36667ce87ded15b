#include <algorithm>
#include <optional>

#include "testbench/report/html_table.h"
#include "testbench/report/html_text.h"
#include "testbench/report/report_html.h"

namespace ptm::testbench::html {
namespace {

const Row kMeasures = {"Differing<small>samples</small>",
                       "Share",
                       "Max<small>levels</small>",
                       "Mean<small>levels</small>",
                       "RMSE<small>levels</small>",
                       "PSNR",
                       "SSIM"};

Row measures(std::string head, const PictureDifference& d) {
  return {std::move(head), grouped(d.differing), share(d.share),      levels(d.max),
          levels(d.mean),  levels(d.rmse),       decibels(d.psnr_db), similarity(d.ssim)};
}

/// A row of what is left without samples on edges between texels; it has no SSIM.
void add_off_edges(std::string& page, const std::optional<PartDifference>& part) {
  if (!part) return;
  const double differing =
      static_cast<double>(part->differing) / static_cast<double>(part->samples);
  add_row(
      page, "",
      {"– without samples on edges", grouped(part->differing), share(differing), levels(part->max),
       levels(part->mean), levels(part->rmse), decibels(part->psnr_db), "–"});
}

Row headed(Row heads, const std::string& first) {
  heads.insert(heads.begin(), first);
  return heads;
}

Row model_heads(const RunResult& result, const std::string& first) {
  Row heads = {first};
  for (const ModelResult& model : result.models) heads.push_back(model.model);
  return heads;
}

/// "–" where a model has no such figure.
template <class Figure>
Row per_model(const RunResult& result, const std::string& head, Figure figure) {
  Row row = {head};
  for (const ModelResult& model : result.models) {
    const std::optional<std::string> cell = figure(model);
    row.push_back(cell.value_or("–"));
  }
  return row;
}

void add_time_table(std::string& page, const RunResult& result) {
  const double pixels =
      static_cast<double>(result.width) * result.height * static_cast<double>(result.lights.size());
  using Cell = std::optional<std::string>;
  open_table(page, "time",
             "Time and simulated cycles, " + plural(result.lights.size(), "light") + ", " +
                 grouped(static_cast<std::uint64_t>(pixels)) + " pixels in all",
             model_heads(result, "Figure"));
  add_row(page, "", per_model(result, "Wall time", [](const ModelResult& m) -> Cell {
            return duration(m.seconds);
          }));
  add_row(page, "", per_model(result, "Wall time a pixel", [&](const ModelResult& m) -> Cell {
            return duration(m.seconds / pixels);
          }));
  add_row(page, "", per_model(result, "Cycles simulated", [](const ModelResult& m) -> Cell {
            return m.cycles ? Cell(grouped(*m.cycles)) : std::nullopt;
          }));
  add_row(page, "", per_model(result, "Cycles a pixel", [&](const ModelResult& m) -> Cell {
            return m.cycles ? Cell(significant(static_cast<double>(*m.cycles) / pixels))
                            : std::nullopt;
          }));
  add_row(page, "",
          per_model(result, "Cycles simulated a second", [](const ModelResult& m) -> Cell {
            if (!m.cycles || !(m.seconds > 0)) return std::nullopt;
            return significant(static_cast<double>(*m.cycles) / m.seconds / 1e6) + " million";
          }));
  close_table(page);
}

const Counter* find_counter(const ModelResult& model, const std::string& name) {
  for (const Counter& counter : model.counters) {
    if (counter.name == name) return &counter;
  }
  return nullptr;
}

void add_counter_table(std::string& page, const RunResult& result) {
  std::vector<std::string> names;
  for (const ModelResult& model : result.models) {
    for (const Counter& counter : model.counters) {
      if (std::find(names.begin(), names.end(), counter.name) == names.end()) {
        names.push_back(counter.name);
      }
    }
  }
  if (names.empty()) return;
  open_table(page, "counters",
             "Counters over all lights; ≠ marks a counter in which models that "
             "have it disagree",
             model_heads(result, "Counter"));
  for (const std::string& name : names) {
    std::optional<std::uint64_t> first;
    bool disagree = false;
    const Row row = per_model(result, "<code>" + html_escape(name) + "</code>",
                              [&](const ModelResult& model) -> std::optional<std::string> {
                                const Counter* counter = find_counter(model, name);
                                if (!counter) return std::nullopt;
                                disagree |= first.value_or(counter->value) != counter->value;
                                first = counter->value;
                                return grouped(counter->value);
                              });
    add_row(page, disagree ? "marked" : "", row);
  }
  close_table(page);
}

}  // namespace

void add_pair_table(std::string& page, const RunComparison& comparison) {
  if (comparison.pairs.empty()) return;
  open_section(page, "pairs", "Every pair");
  const std::uint64_t samples = comparison.pairs.front().difference.samples;
  open_table(page, "pairs",
             "Differences over all lights, " + grouped(samples) +
                 " samples a pair; ≠ marks models that must agree and do not",
             headed(kMeasures, "Pair"));
  for (const PairDifference& pair : comparison.pairs) {
    const bool defect = pair.must_agree && pair.difference.max > 0;
    add_row(page, defect ? "marked" : "", measures(pair.a + " – " + pair.b, pair.difference));
    add_off_edges(page, pair.off_edges);
  }
  close_table(page);
  page += "</section>\n";
}

void add_preset_table(std::string& page, const RunResult& result, const RunComparison& comparison) {
  if (comparison.presets.empty()) return;
  open_section(page, "presets", "Error of the hardware, per preset");
  open_table(page, "presets", "Reference with each preset against golden, over all lights",
             headed(kMeasures, "Preset"));
  for (const PresetDifference& preset : comparison.presets) {
    const bool own = preset.preset == result.preset;
    const std::string name = html_escape(preset.preset) + (own ? " (this run)" : "");
    add_row(page, own ? "bold" : "", measures(name, preset.difference));
    add_off_edges(page, preset.off_edges);
  }
  close_table(page);
  page += "</section>\n";
}

void add_cost_tables(std::string& page, const RunResult& result) {
  open_section(page, "cost", "Time, cycles and counters");
  page += "<div class=\"duo\">\n";
  add_time_table(page, result);
  add_counter_table(page, result);
  page += "</div>\n</section>\n";
}

}  // namespace ptm::testbench::html
