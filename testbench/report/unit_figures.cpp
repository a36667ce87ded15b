#include "testbench/report/unit_figures.h"

#include <algorithm>

#include "testbench/report/html_text.h"

namespace ptm::testbench {
namespace {

using reference::UnitCounter;

double count(const UnitTiming& timing, UnitCounter n) {
  return static_cast<double>(timing.counters[n]);
}

constexpr std::size_t kTextureFirst = static_cast<std::size_t>(reference::kFirstTextureCounter);

std::size_t hits_number(std::size_t draw, std::size_t texture) {
  return kTextureFirst + 4 * draw + 2 * texture;
}

}  // namespace

std::string timing_label(const std::string& model) {
  if (model == "pipeline") return "pipeline (exact)";
  if (model == "loose") return "pipeline (loose)";
  return html_escape(model);
}

bool knows(const UnitTiming& timing, std::size_t counter) {
  constexpr std::array<UnitCounter, 5> kEstimated{UnitCounter::fragments, UnitCounter::pixels,
                                                  UnitCounter::cycles, UnitCounter::beats,
                                                  UnitCounter::lines_read};
  return !timing.estimate || std::find(kEstimated.begin(), kEstimated.end(),
                                       static_cast<UnitCounter>(counter)) != kEstimated.end();
}

const UnitTiming* find_timing(const UnitSection& unit, const std::string& model) {
  for (const UnitTiming& timing : unit.timings) {
    if (timing.model == model) return &timing;
  }
  return nullptr;
}

const UnitTiming* lead_timing(const UnitSection& unit) {
  for (const char* model : {"rtl", "pipeline"}) {
    if (const UnitTiming* timing = find_timing(unit, model)) return timing;
  }
  return unit.timings.empty() ? nullptr : &unit.timings.front();
}

std::optional<double> ratio(double a, double b) {
  return b == 0 ? std::nullopt : std::optional(a / b);
}

std::optional<double> per_pixel(const UnitTiming& timing, UnitCounter n) {
  return ratio(count(timing, n), count(timing, UnitCounter::pixels));
}

std::optional<double> fill_rate(const UnitTiming& timing) {
  return ratio(count(timing, UnitCounter::pixels), count(timing, UnitCounter::cycles));
}

std::optional<double> hit_rate(const UnitTiming& timing) {
  return LookUps{timing.counters[UnitCounter::tag_hits], timing.counters[UnitCounter::tag_misses]}
      .rate();
}

std::optional<double> bytes_per_cycle(const UnitTiming& timing) {
  return ratio(kLineBytes * count(timing, UnitCounter::lines_read),
               count(timing, UnitCounter::cycles));
}

std::optional<double> LookUps::rate() const {
  return ratio(static_cast<double>(hits), static_cast<double>(all()));
}

LookUps look_ups(const UnitTiming& timing, std::size_t draw, std::size_t texture) {
  if (draw >= reference::kDraws) return {};
  const std::size_t n = hits_number(draw, texture);
  return {timing.counters.value[n], timing.counters.value[n + 1]};
}

std::vector<DrawTexture> draw_textures(const UnitSection& unit) {
  std::vector<DrawTexture> textures;
  for (std::size_t i = 0; i < unit.draws.size(); ++i) {
    const UnitDraw& draw = unit.draws[i];
    if (!draw.texture.empty()) textures.push_back({i, 0, draw.object, draw.texture});
    if (!draw.color.empty()) textures.push_back({i, 1, draw.object, draw.color});
  }
  return textures;
}

std::vector<std::size_t> counters_to_show(const UnitSection& unit) {
  std::array<bool, reference::kUnitCounters> show{};
  std::fill_n(show.begin(), kTextureFirst, true);
  show[static_cast<std::size_t>(UnitCounter::palette_lookups)] = false;
  for (const DrawTexture& t : draw_textures(unit)) {
    if (t.draw >= reference::kDraws) continue;
    const std::size_t n = hits_number(t.draw, t.texture);
    show[n] = show[n + 1] = true;
  }
  std::vector<std::size_t> numbers;
  for (std::size_t n = 0; n < show.size(); ++n) {
    const bool counted = std::any_of(unit.timings.begin(), unit.timings.end(),
                                     [n](const UnitTiming& t) { return t.counters.value[n] > 0; });
    if (has_counter(unit.config, n) && (show[n] || counted)) numbers.push_back(n);
  }
  return numbers;
}

}  // namespace ptm::testbench
