#include <algorithm>
#include <cmath>

#include "golden/files/figure_text.h"
#include "testbench/compare/heat_map.h"
#include "testbench/report/html_text.h"
#include "testbench/report/report_html.h"
#include "testbench/report/svg.h"

namespace ptm::testbench::html {
namespace {

using svg::line;
using svg::number;
using svg::text_at;

// The drawing's own units; the page scales it.
constexpr double kWidth = 600, kLeft = 84, kRight = 12, kTop = 14, kPlot = 250, kHeight = 322;
constexpr double kPlotWidth = kWidth - kLeft - kRight;

/// Count to height: log10, one unit of it below 1 so that a single sample shows as a bar.
struct CountAxis {
  int decades;
  [[nodiscard]] double y(double count) const {
    const double part = (std::log10(count) + 0.5) / (decades + 0.5);
    return kTop + kPlot * (1 - part);
  }
};

std::string power_of_ten(int exponent) {
  return exponent < 6
             ? grouped(static_cast<std::uint64_t>(std::llround(std::pow(10, exponent))))
             : "10<tspan dy=\"-5\" font-size=\"10\">" + std::to_string(exponent) + "</tspan>";
}

void add_count_axis(std::string& page, const CountAxis& axis) {
  for (int e = 0; e <= axis.decades; ++e) {
    const double y = axis.y(std::pow(10, e));
    page += line("grid", kLeft, y, kWidth - kRight, y);
    page += text_at(kLeft - 8, y + 4, "end", power_of_ten(e));
  }
  page += line("axis", kLeft, kTop + kPlot, kWidth - kRight, kTop + kPlot);
}

struct ErrorAxis {
  double reach;  ///< levels from the middle to the edge
  [[nodiscard]] double x(double error) const {
    return kLeft + kPlotWidth * (error + reach) / (2 * reach);
  }
};

void add_error_axis(std::string& page, const ErrorAxis& axis) {
  const double step = svg::tick_step(axis.reach);
  const int digits = svg::tick_digits(step);
  const int most = static_cast<int>(axis.reach / step);
  for (int i = -most; i <= most; ++i) {
    const double x = axis.x(i * step);
    page += line("axis", x, kTop + kPlot, x, kTop + kPlot + 5);
    const std::string sign = i < 0 ? "−" : i > 0 ? "+" : "";
    page += text_at(x, kTop + kPlot + 20, "middle", sign + fixed(std::abs(i) * step, digits));
  }
}

void add_bars(std::string& page, const ErrorHistogram& histogram, const CountAxis& counts,
              const ErrorAxis& errors) {
  const double half = histogram.bin_width / 2;
  for (std::size_t i = 0; i < histogram.counts.size(); ++i) {
    if (histogram.counts[i] == 0) continue;
    const double center = histogram.center(i);
    const double left = errors.x(center - half), right = errors.x(center + half);
    const double top = counts.y(static_cast<double>(histogram.counts[i]));
    const double gap = std::min(1.0, (right - left) / 6);
    page += "<rect class=\"bar\" x=\"" + number(left + gap / 2) + "\" y=\"" + number(top) +
            "\" width=\"" + number(right - left - gap) + "\" height=\"" +
            number(kTop + kPlot - top) + "\"><title>" + golden::count_of(levels(center), "level") +
            ": " + plural(histogram.counts[i], "sample") + "</title></rect>\n";
  }
}

}  // namespace

void add_histogram(std::string& page, const PairDifference& pair) {
  const ErrorHistogram& histogram = pair.difference.histogram;
  const std::uint64_t most = *std::max_element(histogram.counts.begin(), histogram.counts.end());
  const CountAxis counts{static_cast<int>(std::ceil(std::log10(static_cast<double>(most)) - 1e-9))};
  const ErrorAxis errors{(std::max(histogram.half_bins, 1) + 0.5) * histogram.bin_width};
  const std::string label = "Histogram of signed errors, " + pair.b + " less " + pair.a;
  page += "<figure class=\"histogram\"><svg viewBox=\"0 0 600 322\" role=\"img\" aria-label=\"" +
          label + "\">\n";
  add_count_axis(page, counts);
  add_bars(page, histogram, counts, errors);
  add_error_axis(page, errors);
  page += text_at(kLeft + kPlotWidth / 2, kHeight - 12, "middle",
                  "error, " + pair.b + " − " + pair.a + " (8-bit levels)");
  page += "<text transform=\"rotate(-90)\" x=\"" + number(-(kTop + kPlot / 2)) +
          "\" y=\"13\" text-anchor=\"middle\">samples (log scale)</text>\n";
  page += "</svg><figcaption><b>Signed errors</b> of all " + grouped(pair.difference.samples) +
          " samples, in bins of " +
          (histogram.bin_width >= 1 ? fixed(histogram.bin_width, 0)
                                    : "1/" + fixed(1 / histogram.bin_width, 0)) +
          " level" + (histogram.bin_width > 1 ? "s" : "") +
          "; an empty bin has no bar.</figcaption></figure>\n";
}

void add_heat_legend(std::string& page, double full_scale) {
  constexpr int kSteps = 149;
  constexpr double kStep = 596.0 / kSteps;
  page +=
      "<svg class=\"legend\" viewBox=\"0 0 600 46\" role=\"img\" aria-label=\"Colour scale of "
      "the heat map, from 0 to " +
      golden::count_of(levels(full_scale), "level") + "\">\n";
  for (int i = 0; i < kSteps; ++i) {
    const Rgb8 c = heat_color(static_cast<double>(i) / (kSteps - 1));
    page += "<rect x=\"" + fixed(2 + kStep * i, 0) + "\" y=\"6\" width=\"" + fixed(kStep, 0) +
            "\" height=\"14\" shape-rendering=\"crispEdges\" fill=\"rgb(" + std::to_string(c[0]) +
            "," + std::to_string(c[1]) + "," + std::to_string(c[2]) + ")\"/>";
  }
  page += '\n';
  for (int i = 0; i <= 4; ++i) {
    const char* anchor = i == 0 ? "start" : i == 4 ? "end" : "middle";
    page += text_at(
        2 + 149.0 * i, 37, anchor,
        i == 4 ? golden::count_of(levels(full_scale), "level") : levels(full_scale * i / 4));
  }
  page += "</svg>\n";
}

}  // namespace ptm::testbench::html
