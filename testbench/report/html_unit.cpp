#include "testbench/report/html_unit.h"

#include <algorithm>

#include "testbench/report/html_table.h"
#include "testbench/report/html_text.h"

namespace ptm::testbench::html {
namespace {

using reference::UnitCounter;

void add_tile(std::string& page, const std::string& figure, const std::string& meaning) {
  page += "<div class=\"tile\"><b>" + figure + "</b><span>" + meaning + "</span></div>\n";
}

std::string figure(std::optional<double> value) { return value ? significant(*value) : "–"; }

std::string percent(std::optional<double> part) { return part ? share(*part) : "–"; }

/// "1.000", or "1.000 to 3.000" where draws differ.
std::string warm_formula(const UnitSection& unit) {
  const auto [least, most] = std::minmax_element(
      unit.draws.begin(), unit.draws.end(),
      [](const auto& a, const auto& b) { return a.cycles_per_pixel < b.cycles_per_pixel; });
  const std::string low = significant(least->cycles_per_pixel),
                    high = significant(most->cycles_per_pixel);
  return low == high ? low : low + " to " + high + " by draw";
}

void add_tiles(std::string& page, const UnitSection& unit, const UnitTiming& lead) {
  const reference::UnitCounters& n = lead.counters;
  const std::string of = timing_label(lead.model);
  page += "<div class=\"tiles\">\n";
  add_tile(page, figure(fill_rate(lead)), "pixels a cycle, the fill rate of " + of);
  add_tile(page, figure(per_pixel(lead, UnitCounter::cycles)),
           "cycles a pixel" + (unit.draws.empty() ? std::string()
                                                  : "; with every line a hit, by the formula: " +
                                                        warm_formula(unit)));
  add_tile(page, percent(hit_rate(lead)),
           "of " + grouped(n[UnitCounter::tag_hits] + n[UnitCounter::tag_misses]) +
               " look-ups hit the caches");
  add_tile(page, figure(bytes_per_cycle(lead)), "bytes a cycle from memory");
  add_tile(page, figure(per_pixel(lead, UnitCounter::words)), "words a pixel");
  add_tile(page, figure(per_pixel(lead, UnitCounter::lines_read)),
           "lines of " + fixed(kLineBytes, 0) + " bytes a pixel");
  page += "</div>\n";
}

bool has_palette(const UnitSection& unit) {
  return std::any_of(unit.timings.begin(), unit.timings.end(), [](const UnitTiming& t) {
    return t.counters[UnitCounter::palette_lookups] > 0;
  });
}

void add_fact(std::string& page, const std::string& name, const std::string& value) {
  page += "<dt>" + name + "</dt><dd>" + html_escape(value) + "</dd>\n";
}

void add_build(std::string& page, const UnitSection& unit) {
  const reference::UnitConfig& c = unit.config;
  page += "<dl class=\"facts\">\n";
  add_fact(page, "TMUs", std::to_string(c.tmus) + ", each with a cache of its own");
  add_fact(page, "Cache of a TMU",
           std::to_string(c.cache_kib) + " KiB, " +
               plural(static_cast<std::size_t>(c.ways), "way") + ", four banks of " +
               plural(static_cast<std::size_t>(reference::cache_sets(c)), "set"));
  add_fact(page, "Fragment FIFO", plural(static_cast<std::size_t>(c.fragment_fifo), "beat"));
  add_fact(page, "Miss ring", plural(static_cast<std::size_t>(c.miss_fifo), "line"));
  if (has_palette(unit)) {
    add_fact(page, "Palette ports",
             std::to_string(c.palette_lrgb_ports) + " for LRGB, " +
                 std::to_string(c.palette_rgb_ports) + " for RGB");
  }
  add_fact(page, "Evaluators", std::to_string(c.eval_lanes));
  if (!c.counters) {
    add_fact(page, "Counters", "none");
  } else if (!c.duplicate_lines) {
    add_fact(page, "Counters", "all but duplicate_lines");
  }
  for (const std::string& block : unit.effect_blocks) add_fact(page, "For effects", block);
  if (!unit.memory.empty()) add_fact(page, "Memory", unit.memory);
  page += "</dl>\n";
}

std::size_t built_counters(const reference::UnitConfig& config) {
  std::size_t count = 0;
  for (std::size_t n = 0; n < reference::kUnitCounters; ++n) count += has_counter(config, n);
  return count;
}

std::string list_counters(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) {
    text += (text.empty() ? "<code>" : ", <code>") + html_escape(name) + "</code>";
  }
  return text;
}

}  // namespace

void add_unit_verdict(std::string& page, const RunResult& result) {
  if (!result.unit) return;
  const UnitSection& unit = *result.unit;
  if (unit.late_pixels == 0 && unit.differing_counters.empty()) {
    const UnitTiming* rtl = find_timing(unit, "rtl");
    if (!rtl || !find_timing(unit, "pipeline")) return;
    page += "<p class=\"verdict good\"><strong>✓ pipeline and rtl agree in the cycle of " +
            (has_counter(unit.config, UnitCounter::pixels)
                 ? "each of " + plural(rtl->counters[UnitCounter::pixels], "pixel") +
                       " and in all " + std::to_string(built_counters(unit.config)) + " counters"
                 : std::string("each pixel; the unit is built without counters")) +
            ".</strong></p>\n";
    return;
  }
  page += "<p class=\"verdict bad\"><strong>✗ pipeline and rtl differ in time.</strong>";
  if (unit.late_pixels > 0) {
    page += "<br>" + plural(unit.late_pixels, "pixel") +
            (unit.late_pixels == 1 ? " leaves" : " leave") + " in another cycle.";
  }
  if (!unit.differing_counters.empty()) {
    page += "<br>" + plural(unit.differing_counters.size(), "counter") +
            (unit.differing_counters.size() == 1 ? " differs: " : " differ: ") +
            list_counters(unit.differing_counters) + ".";
  }
  page += "</p>\n";
}

void add_unit_definitions(std::string& page) {
  page += R"(<dt>Fill rate</dt><dd>Pixels taken ÷ cycles, cycles running from the first fragment
accepted to the last pixel taken; with several frames, both summed.</dd>
<dt>Hit rate</dt><dd>Tag look-ups that found their line ÷ all. A line that is on its way counts as
found.</dd>
<dt>Bandwidth</dt><dd>Bytes of the lines that arrived from memory ÷ cycles.</dd>
)";
}

void add_unit(std::string& page, const RunResult& result) {
  if (!result.unit) return;
  const UnitSection& unit = *result.unit;
  open_section(page, "unit", "The texture unit in time");
  const UnitTiming* lead = lead_timing(unit);
  if (lead && !unit.config.counters) {
    add_build(page, unit);
    page +=
        "<p class=\"soft\">The unit is built without counters: its cycles, look-ups and traffic "
        "are not counted.</p>\n";
  } else if (lead) {
    add_tiles(page, unit, *lead);
    add_build(page, unit);
    add_cycle_classes(page, unit);
    add_bandwidth(page, unit);
    add_texture_table(page, unit);
    add_traffic_table(page, unit);
    add_speed_table(page, unit);
    add_unit_counters(page, unit);
  } else {
    add_build(page, unit);
    page += "<p class=\"soft\">No model of time ran.</p>\n";
  }
  page += "</section>\n";
}

}  // namespace ptm::testbench::html
