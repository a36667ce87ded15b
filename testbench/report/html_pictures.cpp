#include <algorithm>

#include "golden/files/figure_text.h"
#include "testbench/compare/heat_map.h"
#include "testbench/report/html_text.h"
#include "testbench/report/level_picture.h"
#include "testbench/report/report_html.h"

namespace ptm::testbench::html {
namespace {

constexpr int kTinySide = 200;  // below this the page enlarges, and pixels should be seen as such

const ModelResult* find_model(const RunResult& result, const std::string& name) {
  for (const ModelResult& model : result.models) {
    if (model.model == name) return &model;
  }
  return nullptr;
}

const PairDifference* find_pair(const RunComparison& comparison, const std::string& a,
                                const std::string& b) {
  for (const PairDifference& pair : comparison.pairs) {
    if (pair.a == a && pair.b == b) return &pair;
  }
  return nullptr;
}

bool same_pictures(const RunComparison& comparison, const std::string& a, const std::string& b) {
  if (a == b) return true;
  const PairDifference* pair = find_pair(comparison, a, b);
  if (!pair) pair = find_pair(comparison, b, a);
  return pair && pair->difference.max == 0;
}

std::string light_of(const RunResult& result, std::size_t frame) {
  return light_text(result.lights[frame]);
}

std::string reduction_note(int block, const char* how) {
  if (block == 1) return {};
  const std::string n = std::to_string(block);
  return "; shown 1 : " + n + ", the " + how + " of " + n + " × " + n + " pixels";
}

/// A picture as data; tiny ones keep hard pixel edges when the page enlarges them.
void add_figure(std::string& page, PngCache& pngs, const golden::Image8& image,
                const std::string& alt, const std::string& caption_html) {
  const bool tiny = std::max(image.width, image.height) < kTinySide;
  page += "<figure><img" + std::string(tiny ? " class=\"tiny\"" : "") + " width=\"" +
          std::to_string(image.width) + "\" height=\"" + std::to_string(image.height) +
          "\" alt=\"" + html_escape(alt) + "\" src=\"" + png_uri(*pngs.encode(image)) +
          "\"><figcaption>" + caption_html + "</figcaption></figure>\n";
}

void add_heat_figure(std::string& page, PngCache& pngs, const RunResult& result,
                     const PairDifference& pair, std::size_t frame, int side) {
  const golden::ImageReal& a = find_model(result, pair.a)->frames[frame];
  const golden::ImageReal& b = find_model(result, pair.b)->frames[frame];
  const int block = reduction_to(a.width, a.height, side);
  const double full = pair.difference.max;
  add_figure(
      page, pngs, heat_map(a, b, full, block),
      "Heat map of errors, " + pair.b + " against " + pair.a + ", light " + light_of(result, frame),
      "<b>|" + pair.b + " − " + pair.a + "|</b>, largest of the channels; black 0, pale yellow " +
          golden::count_of(levels(full), "level") + reduction_note(block, "largest"));
}

void add_frame(std::string& page, PngCache& pngs, const RunResult& result, std::size_t frame,
               int side, const PairDifference* heat) {
  page += "<div class=\"row\">\n";
  for (const ModelResult& model : result.models) {
    const int block = reduction_to(result.width, result.height, side);
    add_figure(page, pngs, level_picture(model.frames[frame], block),
               "Picture by " + model.model + ", light " + light_of(result, frame),
               "<b>" + model.model + "</b>" +
                   (model.model == "golden" ? ", rounded to 8 bits" : "") +
                   reduction_note(block, "mean"));
  }
  if (heat) add_heat_figure(page, pngs, result, *heat, frame, side);
  page += "</div>\n";
}

/// Pairs that differ, less those that show what an earlier one has shown because their models'
/// pictures are the same; these are named in `same`.
struct ShownPair {
  const PairDifference* pair;
  std::vector<const PairDifference*> same;
};

std::vector<ShownPair> pairs_to_show(const RunComparison& comparison) {
  std::vector<ShownPair> shown;
  for (const PairDifference& pair : comparison.pairs) {
    if (pair.difference.max == 0) continue;
    const auto earlier = std::find_if(shown.begin(), shown.end(), [&](const ShownPair& s) {
      return same_pictures(comparison, s.pair->a, pair.a) &&
             same_pictures(comparison, s.pair->b, pair.b);
    });
    if (earlier == shown.end()) {
      shown.push_back({&pair, {}});
    } else {
      earlier->same.push_back(&pair);
    }
  }
  return shown;
}

void add_same_pairs(std::string& page, const std::vector<const PairDifference*>& same) {
  if (same.empty()) return;
  page += "<p class=\"soft\">Sample for sample the same: ";
  for (std::size_t i = 0; i < same.size(); ++i) {
    page += (i ? ", " : "") + same[i]->b + " against " + same[i]->a;
  }
  page += ".</p>\n";
}

/// A few wrong pixels are hard to see in a large map, so they are named: fewer than ten worst
/// pixels are all there are.
void add_few_pixels(std::string& page, const PictureDifference& difference) {
  if (difference.worst.size() >= 10) return;
  page += "<p class=\"soft\">All pixels that differ: ";
  for (std::size_t i = 0; i < difference.worst.size(); ++i) {
    const WorstPixel& at = difference.worst[i];
    page += std::string(i ? "; " : "") + "x " + std::to_string(at.x) + ", y " +
            std::to_string(at.y) + " of light " + std::to_string(at.frame + 1) + " by " +
            levels(at.error);
  }
  page += ".</p>\n";
}

}  // namespace

void add_pictures(std::string& page, const RunResult& result, const RunComparison& comparison,
                  PngCache& pngs) {
  const std::size_t frames = result.lights.size();
  page += "<section aria-labelledby=\"pictures\">\n<h2 id=\"pictures\">Pictures</h2>\n";
  if (frames == 1) {
    page += "<p class=\"soft\">Light: " + light_of(result, 0) + ".</p>\n";
    add_frame(page, pngs, result, 0, kFirstFrameSide, nullptr);
    page += "</section>\n";
    return;
  }
  const std::vector<ShownPair> pairs = pairs_to_show(comparison);
  for (std::size_t f = 0; f < std::min(frames, kFramesShown); ++f) {
    page += "<h3>Light " + std::to_string(f + 1) + " of " + std::to_string(frames) + ": " +
            light_of(result, f) + "</h3>\n";
    add_frame(page, pngs, result, f, f == 0 ? kFirstFrameSide : kOtherFramesSide,
              pairs.empty() ? nullptr : pairs.front().pair);
  }
  if (frames > kFramesShown) {
    page += "<p class=\"remainder\">" + plural(frames - kFramesShown, "more light") +
            (frames - kFramesShown == 1 ? " is" : " are") +
            " not shown here; all pictures lie beside this page as PNG files.</p>\n";
  }
  page += "</section>\n";
}

void add_differences(std::string& page, const RunResult& result, const RunComparison& comparison,
                     PngCache& pngs) {
  if (comparison.pairs.empty()) return;
  page += "<section aria-labelledby=\"where\">\n<h2 id=\"where\">Where they differ</h2>\n";
  const std::vector<ShownPair> pairs = pairs_to_show(comparison);
  if (pairs.empty()) page += "<p>Nowhere: every picture of every model is the same.</p>\n";
  for (const ShownPair& shown : pairs) {
    const PairDifference& pair = *shown.pair;
    const std::size_t frame = static_cast<std::size_t>(pair.difference.worst.front().frame);
    page += "<h3>" + pair.b + " against " + pair.a + "</h3>\n";
    add_same_pairs(page, shown.same);
    page += "<div class=\"duo\">\n<div>\n";
    add_heat_figure(page, pngs, result, pair, frame, kFirstFrameSide);
    add_heat_legend(page, pair.difference.max);
    if (result.lights.size() > 1) {
      page += "<p class=\"soft\">Light " + std::to_string(frame + 1) + ", " +
              light_of(result, frame) + ", which holds the largest error.</p>\n";
    }
    add_few_pixels(page, pair.difference);
    page += "</div>\n";
    add_histogram(page, pair);
    page += "</div>\n";
  }
  page += "</section>\n";
}

}  // namespace ptm::testbench::html
