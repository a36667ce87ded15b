#pragma once
#include <string>

#include "testbench/report/png_cache.h"
#include "testbench/report/run_comparison.h"

namespace ptm::testbench {

/// report.html: one static page that opens anywhere. No script, no address of another file: its
/// pictures are PNG data, and its content security policy admits nothing else.
[[nodiscard]] std::string report_html(const RunResult& result, const RunComparison& comparison,
                                      PngCache& pngs);

/// At most so many frames are shown; the page says how many are left out and where they are.
inline constexpr std::size_t kFramesShown = 12;
/// Longest side, in pixels, of a picture in the page: the first frame's and the others'. Larger
/// ones are averaged down by a whole factor, which the page states.
inline constexpr int kFirstFrameSide = 1024;
inline constexpr int kOtherFramesSide = 256;

/// The page's sections, each appended to `page`.
namespace html {
[[nodiscard]] std::string style();  ///< the style sheet
void add_summary(std::string& page, const RunResult& result, const RunComparison& comparison);
void add_pictures(std::string& page, const RunResult& result, const RunComparison& comparison,
                  PngCache& pngs);
/// For every pair that differs: heat map of its worst frame, and histogram over all frames.
void add_differences(std::string& page, const RunResult& result, const RunComparison& comparison,
                     PngCache& pngs);
void add_pair_table(std::string& page, const RunComparison& comparison);
void add_preset_table(std::string& page, const RunResult& result, const RunComparison& comparison);
void add_cost_tables(std::string& page, const RunResult& result);
void add_worst_pixels(std::string& page, const RunResult& result, const RunComparison& comparison);
void add_definitions(std::string& page, const RunResult& result);

/// A scale of the heat map's colours from 0 to `full_scale` levels.
void add_heat_legend(std::string& page, double full_scale);
void add_histogram(std::string& page, const PairDifference& pair);
/// The first model that is not golden, or an empty name.
[[nodiscard]] std::string first_hardware(const RunResult& result);
}  // namespace html

}  // namespace ptm::testbench
