#include <algorithm>
#include <set>

#include "testbench/report/html_text.h"
#include "testbench/report/report_html.h"

namespace ptm::testbench::html {
namespace {

constexpr const char* kChannels[3] = {"picture R", "picture G", "picture B"};

const NamedValue* find_value(const PixelValues& model, const std::string& name) {
  for (const NamedValue& value : model.values) {
    if (value.name == name) return &value;
  }
  return nullptr;
}

/// All models' names, each where its own model has it: after the name that stands before it there.
std::vector<std::string> names_in_order(const ProbedPixel& pixel) {
  std::vector<std::string> names;
  for (const PixelValues& model : pixel.models) {
    auto place = names.begin();
    for (const NamedValue& value : model.values) {
      const auto found = std::find(names.begin(), names.end(), value.name);
      place = (found == names.end() ? names.insert(place, value.name) : found) + 1;
    }
  }
  return names;
}

/// Golden's values are real, the others' codes: only the others can be expected to be equal.
bool hardware_disagrees(const ProbedPixel& pixel, const std::string& name) {
  std::set<std::string> seen;
  for (const PixelValues& model : pixel.models) {
    const NamedValue* value = find_value(model, name);
    if (value && model.model != "golden") seen.insert(value->value);
  }
  return seen.size() > 1;
}

bool levels_disagree(const ProbedPixel& pixel, std::size_t channel) {
  std::set<int> seen;
  for (const PixelValues& model : pixel.models) seen.insert(level8(model.rgb[channel]));
  return seen.size() > 1;
}

void add_row(std::string& page, const std::string& name, bool marked,
             const std::vector<std::string>& cells) {
  page += marked ? "<tr class=\"marked\">" : "<tr>";
  page += "<th scope=\"row\">" + html_escape(name) + "</th>";
  for (const std::string& cell : cells)
    page += "<td class=\"value\">" + html_escape(cell) + "</td>";
  page += "</tr>\n";
}

void add_pixel_table(std::string& page, const ProbedPixel& pixel, const std::string& where) {
  page += "<div class=\"scroll\" role=\"region\" tabindex=\"0\" aria-label=\"Values at " + where +
          "\">\n<table class=\"values\">\n<caption>Operands and intermediate values at " + where +
          "</caption>\n<thead><tr><th scope=\"col\">Value</th>";
  for (const PixelValues& model : pixel.models)
    page += "<th scope=\"col\">" + model.model + "</th>";
  page += "</tr></thead>\n<tbody>\n";
  for (const std::string& name : names_in_order(pixel)) {
    std::vector<std::string> cells;
    for (const PixelValues& model : pixel.models) {
      const NamedValue* value = find_value(model, name);
      cells.push_back(value ? value->value : "–");
    }
    add_row(page, name, hardware_disagrees(pixel, name), cells);
  }
  for (std::size_t c = 0; c < 3; ++c) {
    std::vector<std::string> cells;
    for (const PixelValues& model : pixel.models) cells.push_back(levels(model.rgb[c]));
    add_row(page, kChannels[c], levels_disagree(pixel, c), cells);
  }
  page += "</tbody>\n</table>\n</div>\n";
}

void add_pixel(std::string& page, const RunResult& result, const ProbedPixel& pixel,
               std::size_t rank) {
  const FrameLight& light = result.lights[static_cast<std::size_t>(pixel.where.frame)];
  std::string where = "x " + std::to_string(pixel.where.x) + ", y " + std::to_string(pixel.where.y);
  if (result.lights.size() > 1) where += ", light " + std::to_string(pixel.where.frame + 1);
  page += std::string("<details") + (rank == 1 ? " open" : "") + ">\n<summary><b>" +
          std::to_string(rank) + ".</b> error " + levels(pixel.where.error) + " at " + where +
          " <span class=\"soft\">· " + pixel.b + " against " + pixel.a + ", " + light_text(light) +
          "</span></summary>\n";
  add_pixel_table(page, pixel, where);
  page += "</details>\n";
}

}  // namespace

void add_worst_pixels(std::string& page, const RunResult& result, const RunComparison& comparison) {
  if (comparison.worst.empty()) return;
  page +=
      "<section aria-labelledby=\"worst\">\n<h2 id=\"worst\">The " +
      (comparison.worst.size() == 1 ? std::string("worst pixel")
                                    : plural(comparison.worst.size(), "worst pixel")) +
      "</h2>\n<p class=\"soft\">Pixels in which models that must agree differ come first, then by "
      "error in levels. x runs to the right, y down, both from 0. ≠ marks a value in which "
      "the hardware models differ, and a channel of which the 8-bit values differ. "
      "Golden's values are real numbers, the others' are codes.</p>\n";
  for (std::size_t i = 0; i < comparison.worst.size(); ++i) {
    add_pixel(page, result, comparison.worst[i], i + 1);
  }
  page += "</section>\n";
}

}  // namespace ptm::testbench::html
