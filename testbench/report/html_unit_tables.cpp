#include <algorithm>

#include "testbench/report/html_table.h"
#include "testbench/report/html_text.h"
#include "testbench/report/html_unit.h"

namespace ptm::testbench::html {
namespace {

using reference::UnitCounter;

std::string cell(std::optional<double> value) { return value ? significant(*value) : "–"; }

std::string percent(std::optional<double> part) { return part ? share(*part) : "–"; }

Row timing_heads(const UnitSection& unit, const std::string& first) {
  Row heads = {first};
  for (const UnitTiming& timing : unit.timings) heads.push_back(timing_label(timing.model));
  return heads;
}

template <class Figure>
void add_figure_row(std::string& page, const UnitSection& unit, const std::string& head,
                    Figure figure) {
  Row row = {head};
  for (const UnitTiming& timing : unit.timings) row.push_back(figure(timing));
  add_row(page, "", row);
}

/// A count, and beneath it its share of another.
std::string count_of(const UnitTiming& timing, UnitCounter n, UnitCounter whole,
                     const char* whose) {
  if (!knows(timing, n)) return "–";
  const auto part =
      ratio(static_cast<double>(timing.counters[n]), static_cast<double>(timing.counters[whole]));
  return grouped(timing.counters[n]) + "<small>" + percent(part) + " of " + whose + "</small>";
}

void add_texture_row(std::string& page, const UnitSection& unit, const DrawTexture& texture,
                     bool first_of_draw) {
  const UnitTiming& lead = *lead_timing(unit);
  const LookUps found = look_ups(lead, texture.draw, texture.texture);
  Row row = {std::to_string(texture.draw) + " · " + html_escape(texture.object),
             html_escape(texture.name) + "<small>" + (texture.texture == 0 ? "map" : "colour") +
                 "</small>",
             grouped(found.all()), grouped(found.misses)};
  for (const UnitTiming& timing : unit.timings) {
    if (timing.estimate) continue;
    row.push_back(percent(look_ups(timing, texture.draw, texture.texture).rate()));
  }
  row.push_back(first_of_draw ? significant(unit.draws[texture.draw].cycles_per_pixel) : "");
  add_row(page, "", row);
}

std::string difference_cell(const UnitTiming& timing, const UnitTiming& base, bool relative) {
  const std::uint64_t a = base.counters[UnitCounter::cycles];
  const std::uint64_t b = timing.counters[UnitCounter::cycles];
  const std::uint64_t size = a > b ? a - b : b - a;
  const std::string sign = size == 0 ? "" : b > a ? "+" : "−";
  if (!relative) return sign + grouped(size);
  const auto part = ratio(static_cast<double>(size), static_cast<double>(a));
  return part ? sign + share(*part) : "–";
}

}  // namespace

void add_texture_table(std::string& page, const UnitSection& unit) {
  const std::vector<DrawTexture> textures = draw_textures(unit);
  if (textures.empty()) return;
  const std::string lead = timing_label(lead_timing(unit)->model);
  page += "<h3>Hit rate of each texture</h3>\n";
  Row heads = {"Draw", "Texture", "Look-ups<small>" + lead + "</small>",
               "Misses<small>" + lead + "</small>"};
  for (const UnitTiming& timing : unit.timings) {
    if (timing.estimate) continue;
    heads.push_back("Hit rate<small>" + timing_label(timing.model) + "</small>");
  }
  heads.push_back("Cycles a pixel<small>all hits, formula</small>");
  open_table(page, "timed textures",
             "Tag look-ups of each draw and texture, over all frames; the formula is of "
             "the draw, with every line a hit",
             heads);
  for (std::size_t i = 0; i < textures.size(); ++i) {
    add_texture_row(page, unit, textures[i], i == 0 || textures[i - 1].draw != textures[i].draw);
  }
  close_table(page);
}

void add_traffic_table(std::string& page, const UnitSection& unit) {
  page += "<h3>What a pixel costs</h3>\n";
  open_table(page, "timed traffic", "Fetches, lines and multiplies a pixel, over all frames",
             timing_heads(unit, "Figure"));
  struct Line {
    const char* head;
    UnitCounter counter;
  };
  constexpr std::array<Line, 10> kLines{{
      {"Words a pixel", UnitCounter::words},
      {"Taps a pixel", UnitCounter::taps},
      {"Lines read a pixel", UnitCounter::lines_read},
      {"Beats a pixel", UnitCounter::beats},
      {"Palette look-ups a pixel", UnitCounter::palette_lookups},
      {"Address multiplies a pixel", UnitCounter::multiplies_address},
      {"Filter multiplies a pixel", UnitCounter::multiplies_filter},
      {"Evaluator multiplies a pixel", UnitCounter::multiplies_eval},
      {"Combine multiplies a pixel", UnitCounter::multiplies_combine},
      {"Cycles a pixel", UnitCounter::cycles},
  }};
  const std::vector<std::size_t> shown = counters_to_show(unit);
  for (const Line& line : kLines) {
    const auto number = static_cast<std::size_t>(line.counter);
    if (std::find(shown.begin(), shown.end(), number) == shown.end()) continue;
    add_figure_row(page, unit, line.head, [&](const UnitTiming& t) {
      return knows(t, line.counter) ? cell(per_pixel(t, line.counter)) : "–";
    });
  }
  if (has_counter(unit.config, UnitCounter::duplicate_lines)) {
    add_figure_row(page, unit, "Duplicate lines<small>also in another TMU's cache</small>",
                   [](const UnitTiming& t) {
                     return count_of(t, UnitCounter::duplicate_lines, UnitCounter::lines_read,
                                     "lines read");
                   });
  }
  add_figure_row(page, unit,
                 "Bank conflicts<small>sub-beats beyond a beat's first, at a seam</small>",
                 [](const UnitTiming& t) {
                   return count_of(t, UnitCounter::bank_conflicts, UnitCounter::beats, "beats");
                 });
  close_table(page);
}

void add_speed_table(std::string& page, const UnitSection& unit) {
  const UnitTiming& base = *lead_timing(unit);
  const std::string against = timing_label(base.model);
  page += "<h3>Exact, loose and RTL</h3>\n";
  open_table(page, "timed speed",
             "Cycles by each model of time and the wall time it took, all frames; speed is wall "
             "time of " +
                 against + " to the model's own",
             {"Model", "Cycles", "Difference<small>to " + against + "</small>",
              "Difference<small>share</small>", "Wall time", "Cycles simulated a second",
              "Speed<small>" + against + " = 1</small>"});
  for (const UnitTiming& t : unit.timings) {
    const auto cycles = static_cast<double>(t.counters[UnitCounter::cycles]);
    const auto rate = ratio(cycles / 1e6, t.seconds);
    const auto speed = ratio(base.seconds, t.seconds);
    add_row(
        page, &t == &base ? "bold" : "",
        {timing_label(t.model), grouped(t.counters[UnitCounter::cycles]),
         difference_cell(t, base, false), difference_cell(t, base, true), duration(t.seconds),
         rate ? significant(*rate) + " million" : "–", speed ? significant(*speed) + " ×" : "–"});
  }
  close_table(page);
}

void add_unit_counters(std::string& page, const UnitSection& unit) {
  page += "<details class=\"counters\"><summary>All counters of the unit</summary>\n";
  open_table(page, "timed unitcounters",
             "Counters over all frames; ≠ marks one in which pipeline and rtl differ",
             timing_heads(unit, "Counter"));
  for (const std::size_t n : counters_to_show(unit)) {
    const std::string name(reference::unit_counter_names()[n]);
    const std::vector<std::string>& differing = unit.differing_counters;
    const bool marked = std::find(differing.begin(), differing.end(), name) != differing.end();
    Row row = {"<code>" + name + "</code>"};
    for (const UnitTiming& t : unit.timings) {
      row.push_back(knows(t, n) ? grouped(t.counters.value[n]) : "–");
    }
    add_row(page, marked ? "marked" : "", row);
  }
  close_table(page);
  page += "</details>\n";
}

}  // namespace ptm::testbench::html
