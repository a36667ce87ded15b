#include <algorithm>
#include <cmath>

#include "testbench/report/html_text.h"
#include "testbench/report/html_unit.h"
#include "testbench/report/svg.h"

namespace ptm::testbench::html {
namespace {

// The drawing's own units; the page scales it.
constexpr double kWidth = 720, kLeft = 64, kRight = 18, kTop = 12, kPlot = 190, kHeight = 254;
constexpr double kPlotWidth = kWidth - kLeft - kRight;

/// Bytes a cycle in each step, a step being `group` windows (the last one perhaps fewer).
struct Series {
  std::string label;
  const std::vector<std::uint32_t>* windows;
  std::vector<double> steps;
};

std::vector<double> steps_of(const std::vector<std::uint32_t>& windows, std::size_t group,
                             std::uint64_t window) {
  std::vector<double> steps;
  for (std::size_t first = 0; first < windows.size(); first += group) {
    const std::size_t end = std::min(first + group, windows.size());
    double lines = 0;
    for (std::size_t i = first; i < end; ++i) lines += windows[i];
    steps.push_back(kLineBytes * lines /
                    (static_cast<double>(end - first) * static_cast<double>(window)));
  }
  return steps;
}

/// Models with the same windows share a line, as pipeline and rtl should.
std::vector<Series> series_of(const UnitSection& unit) {
  std::vector<Series> all;
  for (const UnitTiming& timing : unit.timings) {
    const std::string label = timing_label(timing.model);
    if (timing.lines_per_window.empty()) continue;
    const auto same = std::find_if(all.begin(), all.end(), [&](const Series& s) {
      return *s.windows == timing.lines_per_window;
    });
    if (same == all.end()) {
      all.push_back({label, &timing.lines_per_window, {}});
    } else {
      same->label += " and " + label;
    }
  }
  return all;
}

struct Axes {
  double cycles, bytes;  ///< at the right and upper edge
  [[nodiscard]] double x(double cycle) const { return kLeft + kPlotWidth * cycle / cycles; }
  [[nodiscard]] double y(double rate) const { return kTop + kPlot * (1 - rate / bytes); }
};

void add_axes(std::string& page, const Axes& axes) {
  const double rate_step = svg::tick_step(axes.bytes, 5);
  for (int i = 0; i * rate_step <= axes.bytes * (1 + 1e-9); ++i) {
    const double y = axes.y(i * rate_step);
    page += svg::line(i == 0 ? "axis" : "grid", kLeft, y, kWidth - kRight, y);
    page +=
        svg::text_at(kLeft - 8, y + 4, "end", fixed(i * rate_step, svg::tick_digits(rate_step)));
  }
  const double cycle_step = std::max(1.0, svg::tick_step(axes.cycles, 6));
  for (int i = 0; i * cycle_step <= axes.cycles; ++i) {
    const double x = axes.x(i * cycle_step);
    page += svg::line("axis", x, kTop + kPlot, x, kTop + kPlot + 5);
    page += svg::text_at(x, kTop + kPlot + 20, i == 0 ? "start" : "middle",
                         grouped(static_cast<std::uint64_t>(std::llround(i * cycle_step))));
  }
  page += svg::text_at(kLeft + kPlotWidth / 2, kHeight - 6, "middle", "cycle");
  page += "<text transform=\"rotate(-90)\" x=\"" + svg::number(-(kTop + kPlot / 2)) +
          "\" y=\"14\" text-anchor=\"middle\">bytes a cycle</text>\n";
}

/// A level line for each step; with `area`, closed along the axis.
std::string step_path(const Series& series, const Axes& axes, double step_cycles, bool area) {
  std::string path = "M";  // appended to: GCC 12 warns of `"V" + number(...)` without cause
  path += svg::number(kLeft) + ' ';
  path += svg::number(area ? kTop + kPlot : axes.y(series.steps.front()));
  for (std::size_t i = 0; i < series.steps.size(); ++i) {
    const double right = std::min(axes.cycles, step_cycles * static_cast<double>(i + 1));
    path += 'V';
    path += svg::number(axes.y(series.steps[i])) + 'H';
    path += svg::number(axes.x(right));
  }
  if (area) {
    path += 'V';
    path += svg::number(kTop + kPlot) + 'Z';
  }
  return path;
}

void add_series(std::string& page, const Series& series, const Axes& axes, double step_cycles,
                std::size_t rank) {
  const std::string kind = "rate" + std::to_string(rank);
  if (rank == 0) {
    page += "<path class=\"area\" d=\"" + step_path(series, axes, step_cycles, true) + "\"/>\n";
  }
  page += "<path class=\"" + kind + "\" d=\"" + step_path(series, axes, step_cycles, false) +
          "\"><title>" + series.label + "</title></path>\n";
}

void add_caption(std::string& page, const UnitSection& unit, const std::vector<Series>& all,
                 std::size_t group) {
  page += "<figcaption>";
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::uint32_t most = *std::max_element(all[i].windows->begin(), all[i].windows->end());
    page += "<span class=\"key\"><i class=\"swatch line" + std::to_string(i) + "\"></i><b>" +
            all[i].label + "</b>: at most " + plural(most, "line") + " in a window, " +
            significant(kLineBytes * most / static_cast<double>(unit.window)) +
            " bytes a cycle</span>";
  }
  if (const UnitTiming* lead = lead_timing(unit)) {
    if (const auto mean = bytes_per_cycle(*lead)) {
      page += "<span class=\"key\"><i class=\"swatch mean\"></i><b>" + timing_label(lead->model) +
              ", mean of the run</b>: " + significant(*mean) + " bytes a cycle</span>";
    }
  }
  page +=
      "A window is " + plural(unit.window, "cycle") + ", a line " + fixed(kLineBytes, 0) + " bytes";
  if (group > 1) page += "; each step is the mean of " + plural(group, "window");
  page +=
      "; frames stand one after another, and a frame's last window may not be full."
      "</figcaption></figure>\n";
}

}  // namespace

void add_bandwidth(std::string& page, const UnitSection& unit) {
  std::vector<Series> all = series_of(unit);
  if (all.empty()) return;
  std::size_t windows = 0;
  for (const Series& s : all) windows = std::max(windows, s.windows->size());
  const std::size_t group = (windows + kBandwidthSteps - 1) / kBandwidthSteps;
  double peak = 0;
  for (Series& s : all) {
    s.steps = steps_of(*s.windows, group, unit.window);
    peak = std::max(peak, *std::max_element(s.steps.begin(), s.steps.end()));
  }
  const Axes axes{static_cast<double>(windows) * static_cast<double>(unit.window),
                  peak > 0 ? 1.05 * peak : 1};
  page +=
      "<h3>Bandwidth over time</h3>\n<figure class=\"rate\"><div class=\"scroll\" "
      "role=\"region\" tabindex=\"0\" aria-label=\"Bandwidth over time\"><svg viewBox=\"0 0 " +
      fixed(kWidth, 0) + " " + fixed(kHeight, 0) +
      "\" role=\"img\" aria-label=\"Bytes a cycle from memory over " +
      grouped(windows * unit.window) + " cycles\">\n";
  add_axes(page, axes);
  const double step_cycles = static_cast<double>(group) * static_cast<double>(unit.window);
  for (std::size_t i = 0; i < all.size(); ++i) add_series(page, all[i], axes, step_cycles, i);
  if (const UnitTiming* lead = lead_timing(unit)) {
    const double y = axes.y(bytes_per_cycle(*lead).value_or(0));
    page += svg::line("mean", kLeft, y, kWidth - kRight, y);
  }
  page += "</svg></div>";
  add_caption(page, unit, all, group);
}

}  // namespace ptm::testbench::html
