#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "model/reference/unit/unit_memory.h"
#include "testbench/run/run_result.h"

/// Figures of the whole texture unit, as docs/spec/report.md defines them, from its counters.
namespace ptm::testbench {

inline constexpr double kLineBytes = reference::kLineWords * sizeof(std::uint32_t);

/// The five classes into which every cycle falls; docs/spec/unit-timing.md, counters 3 to 7.
struct CycleClass {
  reference::UnitCounter counter;
  const char* name;
  const char* meaning;
};
inline constexpr std::array<CycleClass, 5> kCycleClasses{{
    {reference::UnitCounter::cycles_moved, "moved", "a beat left the commit stage"},
    {reference::UnitCounter::cycles_output_blocked, "output blocked",
     "what follows the commit stage accepted nothing"},
    {reference::UnitCounter::cycles_line_wait, "waited for lines",
     "the commit stage held a beat: lines missing, or still to be written"},
    {reference::UnitCounter::cycles_ring_full, "miss ring full",
     "no beat to commit: the tag stage lacked slots"},
    {reference::UnitCounter::cycles_input_empty, "input empty", "no beat to commit, none waiting"},
}};

/// "pipeline (exact)", "pipeline (loose)"; any other model by its name, as HTML.
[[nodiscard]] std::string timing_label(const std::string& model);
/// Whether the model says anything of a counter: an estimate knows few.
[[nodiscard]] bool knows(const UnitTiming& timing, std::size_t counter);
[[nodiscard]] inline bool knows(const UnitTiming& timing, reference::UnitCounter n) {
  return knows(timing, static_cast<std::size_t>(n));
}
/// nullptr if the model did not run.
[[nodiscard]] const UnitTiming* find_timing(const UnitSection& unit, const std::string& model);
/// Whose figures stand for the unit: rtl, else pipeline, else the first; nullptr if none ran.
[[nodiscard]] const UnitTiming* lead_timing(const UnitSection& unit);

/// a / b, or nothing for b = 0.
[[nodiscard]] std::optional<double> ratio(double a, double b);
[[nodiscard]] std::optional<double> per_pixel(const UnitTiming& timing, reference::UnitCounter n);
[[nodiscard]] std::optional<double> fill_rate(const UnitTiming& timing);  ///< pixels a cycle
/// Tag hits to look-ups of the whole run.
[[nodiscard]] std::optional<double> hit_rate(const UnitTiming& timing);
[[nodiscard]] std::optional<double> bytes_per_cycle(const UnitTiming& timing);

struct LookUps {
  std::uint64_t hits = 0, misses = 0;
  [[nodiscard]] std::uint64_t all() const { return hits + misses; }
  [[nodiscard]] std::optional<double> rate() const;
};
/// Of texture 0 (map) or 1 (colour) of a draw; none of a draw from kDraws on, which has no
/// counters.
[[nodiscard]] LookUps look_ups(const UnitTiming& timing, std::size_t draw, std::size_t texture);

/// One row of the page's table of textures.
struct DrawTexture {
  std::size_t draw = 0, texture = 0;  ///< as look_ups() takes them
  std::string object, name;           ///< as the scene names them
};
/// Every texture of every draw; a draw without texture has none.
[[nodiscard]] std::vector<DrawTexture> draw_textures(const UnitSection& unit);

/// Numbers of the counters that the scene calls for: not those of textures that no draw has, nor
/// the palette's without look-ups, nor those that the unit is built without. Of the others one that
/// is not 0 in some model is always there.
[[nodiscard]] std::vector<std::size_t> counters_to_show(const UnitSection& unit);

}  // namespace ptm::testbench
