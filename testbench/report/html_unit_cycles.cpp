#include "testbench/report/html_table.h"
#include "testbench/report/html_text.h"
#include "testbench/report/html_unit.h"
#include "testbench/report/svg.h"

namespace ptm::testbench::html {
namespace {

using reference::UnitCounter;

// The bar is stretched to the page's width: 1000 units are all the cycles.
constexpr double kBarWidth = 1000, kBarHeight = 26;

double cycles_of(const UnitTiming& timing) {
  return static_cast<double>(timing.counters[UnitCounter::cycles]);
}

std::string class_share(const UnitTiming& timing, UnitCounter n) {
  const auto part = ratio(static_cast<double>(timing.counters[n]), cycles_of(timing));
  return part ? share(*part) : "–";
}

/// One bar, parts in the order of the classes; what they are worth stands in the table below, so
/// that no text is squeezed into it.
void add_bar(std::string& page, const UnitTiming& timing) {
  const std::string label = timing_label(timing.model);
  std::string spoken = "Cycles of " + label + " by class";
  std::string parts;
  double left = 0;
  for (std::size_t i = 0; i < kCycleClasses.size(); ++i) {
    const CycleClass& c = kCycleClasses[i];
    const std::string value = std::string(c.name) + " " + class_share(timing, c.counter);
    spoken += (i ? ", " : ": ") + value;
    const double part =
        ratio(static_cast<double>(timing.counters[c.counter]), cycles_of(timing)).value_or(0);
    if (part == 0) continue;
    parts += "<rect class=\"cycle" + std::to_string(i) + "\" x=\"" + svg::number(left) +
             "\" y=\"0\" width=\"" + svg::number(kBarWidth * part) + "\" height=\"26\"><title>" +
             value + "</title></rect>\n";
    left += kBarWidth * part;
  }
  page += "<p class=\"barname\"><b>" + label + "</b> " +
          grouped(timing.counters[UnitCounter::cycles]) +
          " cycles</p>\n<svg class=\"cycles\" viewBox=\"0 0 " + fixed(kBarWidth, 0) + " " +
          fixed(kBarHeight, 0) + "\" preserveAspectRatio=\"none\" role=\"img\" aria-label=\"" +
          spoken + "\">\n" + parts + "</svg>\n";
}

Row class_row(const UnitSection& unit, std::size_t i) {
  const CycleClass& c = kCycleClasses[i];
  Row row = {"<i class=\"swatch cycle" + std::to_string(i) + "\"></i>" + c.name + "<small>" +
             c.meaning + "</small>"};
  for (const UnitTiming& timing : unit.timings) {
    if (timing.estimate) continue;
    row.push_back(class_share(timing, c.counter) + "<small>" + grouped(timing.counters[c.counter]) +
                  "</small>");
  }
  return row;
}

/// The sum of the classes, not the counter `cycles`: a model that loses a cycle shows it here.
Row sum_row(const UnitSection& unit) {
  Row row = {"sum of the classes"};
  for (const UnitTiming& timing : unit.timings) {
    if (timing.estimate) continue;
    std::uint64_t sum = 0;
    for (const CycleClass& c : kCycleClasses) sum += timing.counters[c.counter];
    const auto part = ratio(static_cast<double>(sum), cycles_of(timing));
    row.push_back((part ? share(*part) : "–") + "<small>" + grouped(sum) + "</small>");
  }
  return row;
}

}  // namespace

void add_cycle_classes(std::string& page, const UnitSection& unit) {
  page += "<h3>Where the cycles went</h3>\n<div class=\"bars\">\n";
  for (const UnitTiming& timing : unit.timings) {
    if (!timing.estimate) add_bar(page, timing);
  }
  page += "</div>\n";
  Row heads = {"Class"};
  for (const UnitTiming& timing : unit.timings) {
    if (!timing.estimate) heads.push_back(timing_label(timing.model));
  }
  open_table(page, "timed cycles",
             "Colours of the bars, and shares of all cycles; a cycle falls in the first class that "
             "holds, judged at the commit stage",
             heads);
  for (std::size_t i = 0; i < kCycleClasses.size(); ++i) add_row(page, "", class_row(unit, i));
  add_row(page, "bold", sum_row(unit));
  close_table(page);
}

}  // namespace ptm::testbench::html
