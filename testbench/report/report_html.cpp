#include "testbench/report/report_html.h"

#include <algorithm>

#include "golden/files/figure_text.h"
#include "testbench/report/html_effects.h"
#include "testbench/report/html_made_by.h"
#include "testbench/report/html_text.h"
#include "testbench/report/html_unit.h"

namespace ptm::testbench {
namespace html {
namespace {

void add_tile(std::string& page, const std::string& figure, const std::string& meaning) {
  page += "<div class=\"tile\"><b>" + figure + "</b><span>" + meaning + "</span></div>\n";
}

std::string list_names(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    text += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
  }
  return text;
}

void add_verdict(std::string& page, const RunResult& result, const RunComparison& comparison) {
  std::vector<std::string> hardware;
  for (const ModelResult& model : result.models) {
    if (model.model != "golden") hardware.push_back(model.model);
  }
  if (hardware.size() < 2) return;
  if (comparison.models_agree()) {
    const std::uint64_t samples = comparison.pairs.front().difference.samples;
    page += "<p class=\"verdict good\"><strong>✓ " + list_names(hardware) + " differ in 0 of " +
            grouped(samples) + " samples.</strong></p>\n";
    return;
  }
  page += "<p class=\"verdict bad\"><strong>✗ Models that must agree do not.</strong>";
  for (const PairDifference& pair : comparison.pairs) {
    if (!pair.must_agree || pair.difference.max == 0) continue;
    page += "<br>" + pair.a + " and " + pair.b + " differ in " +
            grouped(pair.difference.differing) + " of " + grouped(pair.difference.samples) +
            " samples, by up to " + golden::count_of(levels(pair.difference.max), "level") + ".";
  }
  page += "</p>\n";
}

void add_accuracy(std::string& page, const RunResult& result, const RunComparison& comparison) {
  const std::string hardware = first_hardware(result);
  const auto pair =
      std::find_if(comparison.pairs.begin(), comparison.pairs.end(),
                   [&](const PairDifference& p) { return p.a == "golden" && p.b == hardware; });
  if (pair == comparison.pairs.end()) return;
  const PictureDifference& d = pair->difference;
  const std::string against = " of " + hardware + " against golden";
  page += "<div class=\"tiles\">\n";
  add_tile(page, decibels(d.psnr_db), "PSNR" + against);
  add_tile(page, levels(d.max), "largest error" + against + ", in 8-bit levels");
  add_tile(page, share(d.share),
           "samples of " + hardware + " whose 8-bit values differ from golden's");
  add_tile(page, similarity(d.ssim), "SSIM" + against + " (1: the same)");
  page += "</div>\n";
  const std::string edges = edge_sentence(comparison, *pair);
  if (!edges.empty()) page += "<p class=\"edges\">" + html_escape(edges) + "</p>\n";
}

void add_fact(std::string& page, const std::string& name, const std::string& value) {
  if (!value.empty()) page += "<dt>" + name + "</dt><dd>" + html_escape(value) + "</dd>\n";
}

}  // namespace

std::string first_hardware(const RunResult& result) {
  for (const ModelResult& model : result.models) {
    if (model.model != "golden") return model.model;
  }
  return {};
}

void add_summary(std::string& page, const RunResult& result, const RunComparison& comparison) {
  page += "<header>\n<p class=\"over\">ptmsim · one scene through " +
          plural(result.models.size(), "model") + "</p>\n<h1>" + html_escape(result.scene_file) +
          "</h1>\n";
  add_verdict(page, result, comparison);
  add_unit_verdict(page, result);
  add_accuracy(page, result, comparison);
  page += "<dl class=\"facts\">\n";
  add_fact(page, "Map", result.map_file);
  add_fact(page, "Format", result.map_format);
  add_fact(
      page, "Picture",
      std::to_string(result.width) + " × " + std::to_string(result.height) + " pixels, 3 channels");
  add_fact(page, "Preset", result.preset);
  std::string lights;
  for (std::size_t i = 0; i < std::min(kFramesShown, result.lights.size()); ++i) {
    lights += (i ? ", " : "") + light_text(result.lights[i]);
  }
  if (result.lights.size() > kFramesShown) {
    lights += " and " + std::to_string(result.lights.size() - kFramesShown) + " more";
  }
  add_fact(page, plural(result.lights.size(), "light"), lights);
  page += "</dl>\n</header>\n";
}

void add_definitions(std::string& page, const RunResult& result) {
  page += R"(<footer>
<h2>What the figures mean</h2>
<dl>
<dt>Level</dt><dd>One step of an 8-bit sample, 1/255 of full scale. Golden is real-valued and
clamped to 0 to 255; it is rounded only to be shown. The other models give integers.</dd>
<dt>Error</dt><dd>Second model less first; against golden, hardware less golden. Max, mean and RMSE
are of absolute errors over all samples (pixels × channels × lights).</dd>
<dt>Differing</dt><dd>Samples whose 8-bit values, rounded to nearest, differ.</dd>
<dt>PSNR</dt><dd>20 log10(255 / RMSE); ∞ for identical pictures.</dd>
<dt>SSIM</dt><dd>Wang et al. 2004, 11 × 11 Gaussian window of σ 1.5, K1 = 0.01, K2 = 0.03, on
Rec. 709 luma, windows wholly inside the picture, mean over the lights.</dd>
<dt>Time</dt><dd>Wall time of the model alone, all lights,
on the machine that made this report.</dd>
)";
  if (result.unit) add_unit_definitions(page);
  page += R"(</dl>
<p>The same figures, unrounded, or the counts they are made of, are in <code>report.json</code>
beside this page.</p>
</footer>
)";
}

}  // namespace html

std::string report_html(const RunResult& result, const RunComparison& comparison, PngCache& pngs) {
  std::string page = R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy"
 content="default-src 'none'; img-src data:; style-src 'unsafe-inline'">
<meta name="viewport" content="width=device-width, initial-scale=1">
<link rel="icon" href="data:,">
<title>)" + html_escape(result.scene_file) +
                     " - ptmsim report</title>\n<style>" + html::style() +
                     "</style>\n</head>\n<body>\n";
  html::add_summary(page, result, comparison);
  page += "<main>\n";
  if (!result.notes.empty()) {
    page += "<h2>Notes</h2>\n<ul class=\"notes\">\n";
    for (const std::string& note : result.notes) page += "<li>" + html_escape(note) + "</li>\n";
    page += "</ul>\n";
  }
  html::add_pictures(page, result, comparison, pngs);
  html::add_differences(page, result, comparison, pngs);
  html::add_pair_table(page, comparison);
  html::add_preset_table(page, result, comparison);
  html::add_unit(page, result);
  html::add_effect_costs(page, result);
  html::add_cost_tables(page, result);
  html::add_worst_pixels(page, result, comparison);
  html::add_made_by(page, result);
  page += "</main>\n";
  html::add_definitions(page, result);
  page += "</body>\n</html>\n";
  return page;
}

}  // namespace ptm::testbench
