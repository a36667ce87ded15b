#include <gtest/gtest.h>

#include <regex>
#include <sstream>

#include "testbench/report/html_unit.h"
#include "testbench/report/report_html.h"
#include "tests/report/made_unit.h"

namespace ptm::testbench {
namespace {

using tests::made_late_run;
using tests::made_unit_run;

std::string page_of(const RunResult& run) {
  PngCache pngs;
  return report_html(run, compare_run(run), pngs);
}

bool has(const std::string& page, const std::string& part) {
  return page.find(part) != std::string::npos;
}

std::string tile(const std::string& figure, const std::string& meaning) {
  return "<div class=\"tile\"><b>" + figure + "</b><span>" + meaning;
}

/// The text from `from` to the next `to`, both left out; empty if it is not there.
std::string between(const std::string& page, const std::string& from, const std::string& to) {
  const std::size_t at = page.find(from);
  if (at == std::string::npos) return {};
  const std::size_t begin = at + from.size();
  return page.substr(begin, page.find(to, begin) - begin);
}

TEST(UnitPage, SaysOfEachLightWhatItIsInTheWorld) {
  RunResult run = made_unit_run(4, 4, 3);
  run.lights[1].kind = FrameLight::Kind::position;
  run.lights[2] = {-0.5, 0.25};
  const std::string page = page_of(run);
  EXPECT_TRUE(has(page, "Light 1 of 3: direction (0.600,\u00a0-0.480,\u00a00.640)</h3>"));
  EXPECT_TRUE(has(page, "Light 2 of 3: position (0.600,\u00a0-0.480,\u00a00.640)</h3>"));
  EXPECT_TRUE(has(page, "Light 3 of 3: (lu, lv) = (-0.500,\u00a00.250)</h3>"));
}

TEST(UnitPage, IsAbsentFromAFlatScenesReport) {
  const std::string flat = page_of(tests::made_run(4, 4, 1));
  for (const char* word : {"texture unit", "Fill rate", "Hit rate", "class=\"cycles\"", "Bandwidth",
                           "TMU", "pipeline and rtl agree"}) {
    EXPECT_FALSE(has(flat, word)) << word;
    EXPECT_TRUE(has(page_of(made_unit_run(4, 4, 1)), word)) << word;
  }
}

TEST(UnitPage, ShowsFillRateAndTrafficAsTheRtlsCountersGiveThem) {
  const std::string page = page_of(made_unit_run(4, 4, 1));
  EXPECT_TRUE(has(page, tile("0.5581", "pixels a cycle")));  // 65536 / 117422 = 0.55812
  EXPECT_TRUE(has(page, tile("1.792",
                             "cycles a pixel; with every line a hit, by the formula: "
                             "1.000 to 2.000 by draw")));              // 1.79172
  EXPECT_TRUE(has(page, tile("99.04 %", "of 323,100 look-ups hit")));  // 320000 / 323100
  EXPECT_TRUE(has(page, tile("1.690", "bytes a cycle")));              // 3100 * 64 / 117422
  EXPECT_TRUE(has(page, tile("3.500", "words a pixel")));              // 229376 / 65536
  EXPECT_TRUE(has(page, tile("0.04730", "lines of 64 bytes")));        // 3100 / 65536
  EXPECT_TRUE(has(page, "Taps a pixel</th><td>14.00</td>"));
  EXPECT_TRUE(has(page, "<td>240<small>7.74 % of lines read</small></td>"));
  EXPECT_TRUE(has(page, "<td>320<small>0.36 % of beats</small></td>"));
}

TEST(UnitPage, TakesThePipelinesFiguresWhereNoRtlRan) {
  RunResult run = made_unit_run(4, 4, 1);
  run.unit->timings.pop_back();
  run.unit->timings[0].counters[reference::UnitCounter::cycles] = 131072;
  run.unit->draws.resize(1);
  const std::string page = page_of(run);
  EXPECT_TRUE(has(page, tile("0.5000", "pixels a cycle, the fill rate of pipeline (exact)")));
  EXPECT_TRUE(has(page, "by the formula: 2.000</span>"));
}

TEST(UnitPage, DrawsEachClassAsWideAsItsShareOfTheCycles) {
  const std::string page = page_of(made_unit_run(4, 4, 1));
  const std::string bar =
      between(page, "aria-label=\"Cycles of pipeline (loose) by class", "</svg>");
  const std::regex rect("class=\"cycle([0-4])\" x=\"([0-9.]+)\" y=\"0\" width=\"([0-9.]+)\"");
  const double counts[5] = {90000, 2100, 26188, 900, 112};
  double left = 0;
  int parts = 0;
  for (std::sregex_iterator i(bar.begin(), bar.end(), rect), end; i != end; ++i, ++parts) {
    ASSERT_EQ((*i)[1], std::to_string(parts));
    EXPECT_NEAR(std::stod((*i)[2]), left, 0.011);
    EXPECT_NEAR(std::stod((*i)[3]), 1000 * counts[parts] / 119300, 0.006);
    left += 1000 * counts[parts] / 119300;
  }
  EXPECT_EQ(parts, 5);
  EXPECT_NEAR(left, 1000, 1e-9);
  EXPECT_TRUE(has(bar, "waited for lines 21.95 %"));  // 26188 / 119300
  EXPECT_TRUE(has(page, "<td>20.70 %<small>24,310</small></td><td>21.95 %<small>26,188</small>"));
}

TEST(UnitPage, SaysNothingOfWhatAnEstimateDoesNotKnow) {
  const std::string page = page_of(made_late_run(4, 4));
  EXPECT_FALSE(has(page, "aria-label=\"Cycles of pipeline (loose) by class"));
  EXPECT_TRUE(has(page, "Words a pixel</th><td>3.500</td><td>–</td><td>3.500</td>"));
  EXPECT_TRUE(has(page, "Beats a pixel</th><td>1.373</td><td>1.373</td><td>1.373</td>"));
  EXPECT_TRUE(has(page, "<code>taps</code></th><td>917,504</td><td>–</td><td>917,504</td>"));
}

TEST(UnitPage, HasNoRowOfACounterThatTheUnitIsBuiltWithout) {
  const std::string whole = page_of(made_unit_run(4, 4, 1));
  EXPECT_TRUE(has(whole, "Duplicate lines"));
  EXPECT_TRUE(has(whole, "<code>duplicate_lines</code>"));
  EXPECT_TRUE(has(whole, "in all 38 counters"));
  const std::string part = page_of(tests::made_unit_without_counters(4, 4, true));
  EXPECT_FALSE(has(part, "Duplicate lines"));
  EXPECT_FALSE(has(part, "<code>duplicate_lines</code>"));
  EXPECT_TRUE(has(part, "<dt>Counters</dt><dd>all but duplicate_lines</dd>"));
  EXPECT_TRUE(has(part, "Bank conflicts"));
  EXPECT_TRUE(has(part, "in all 37 counters"));
  const std::string none = page_of(tests::made_unit_without_counters(4, 4, false));
  EXPECT_TRUE(has(none, "<dt>Counters</dt><dd>none</dd>"));
  EXPECT_TRUE(has(none, "agree in the cycle of each pixel; the unit is built without counters"));
  for (const char* figure : {"the fill rate of", "Bank conflicts", "<code>taps</code>",
                             "class=\"cycles\"", "Hit rate of each texture"}) {
    EXPECT_TRUE(has(whole, figure)) << figure;
    EXPECT_FALSE(has(none, figure)) << figure;
  }
}

TEST(UnitPage, ShowsWhenClassesDoNotAddUpToTheCycles) {
  RunResult run = made_unit_run(4, 4, 1);
  EXPECT_TRUE(has(page_of(run), "sum of the classes</th><td>100 %<small>117,422</small>"));
  run.unit->timings[0].counters[reference::UnitCounter::cycles_moved] -= 9000;
  EXPECT_TRUE(has(page_of(run), "sum of the classes</th><td>92.34 %<small>108,422</small>"));
}

TEST(UnitPage, ShowsTheHitRateOfEveryTextureInEveryModel) {
  RunResult run = made_unit_run(4, 4, 1);
  run.unit->timings[1].counters.hits(0, 1) = 6300;
  const std::string page = page_of(run);
  EXPECT_TRUE(has(page,
                  "<th scope=\"row\">0 · floor</th><td>tiles.ptm<small>map</small></td>"
                  "<td>151,500</td><td>1,500</td><td>99.01 %</td><td>99.01 %</td><td>99.01 %</td>"
                  "<td>2.000</td>"));
  EXPECT_TRUE(has(page,
                  "<th scope=\"row\">0 · floor</th><td>grass.png<small>colour</small></td>"
                  "<td>50,700</td><td>700</td><td>98.62 %</td><td>90.00 %</td><td>98.62 %</td>"
                  "<td></td>"));
  EXPECT_TRUE(has(page,
                  "<th scope=\"row\">1 · ball</th><td>ball.ptm<small>map</small></td>"
                  "<td>120,900</td><td>900</td><td>99.26 %</td>"));
}

/// What lies under the drawn line, in lines: the drawing's own axes undone.
double lines_under(const std::string& page, const std::string& kind, double cycles) {
  const std::string path = between(page, "<path class=\"" + kind + "\" d=\"M", "\"");
  const std::string bottom = between(page, "<path class=\"area\" d=\"M64.00 ", "V");
  // Height of one byte a cycle: between the axis (0) and the first grid line, and its label.
  const std::regex grid(
      "<line class=\"grid\" x1=\"64.00\" y1=\"([0-9.]+)\"[^>]*>\\s*"
      "<text[^>]*>([0-9.]+)</text>");
  const std::string drawing = between(page, "aria-label=\"Bytes a cycle", "</svg>");
  std::smatch first;
  if (!std::regex_search(drawing, first, grid)) return -1;
  const double byte = (std::stod(bottom) - std::stod(first[1])) / std::stod(first[2]);
  const std::regex step("V([0-9.]+)H([0-9.]+)");
  double bytes = 0, left = 64;
  for (std::sregex_iterator i(path.begin(), path.end(), step), end; i != end; ++i) {
    const double right = std::stod((*i)[2]);
    bytes += (std::stod(bottom) - std::stod((*i)[1])) / byte * (right - left) / 638 * cycles;
    left = right;
  }
  return bytes / 64;
}

TEST(UnitPage, DrawsEveryLineThatArrivedUnderTheBandwidthCurve) {
  const std::string one = page_of(made_unit_run(4, 4, 1));
  EXPECT_NEAR(lines_under(one, "rate0", 1835 * 64), 3100, 5);
  EXPECT_FALSE(has(one, "<path class=\"rate1\""));
  EXPECT_TRUE(
      has(one, "<b>pipeline (exact) and rtl</b>: at most 4 lines in a window, 4.000 bytes"));
  EXPECT_TRUE(has(one, "each step is the mean of 8 windows"));
  const std::string two = page_of(made_late_run(4, 4));
  EXPECT_NEAR(lines_under(two, "rate1", 1836 * 64), 3100, 5);
}

TEST(UnitPage, SumsUpOnlySoManyWindowsAsAreTooManyToDraw) {
  RunResult run = made_unit_run(4, 4, 1);
  for (UnitTiming& timing : run.unit->timings) {
    if (!timing.lines_per_window.empty()) timing.lines_per_window = {8, 0, 4};
  }
  const std::string page = page_of(run);
  EXPECT_NEAR(lines_under(page, "rate0", 3 * 64), 12, 0.01);
  EXPECT_FALSE(has(page, "each step is"));
  for (UnitTiming& timing : run.unit->timings) timing.lines_per_window.clear();
  EXPECT_FALSE(has(page_of(run), "Bandwidth over time"));
}

TEST(UnitPage, ComparesExactLooseAndRtlInCyclesAndTime) {
  const std::string page = page_of(made_unit_run(4, 4, 1));
  EXPECT_TRUE(
      has(page,
          "<tr><th scope=\"row\">pipeline (exact)</th><td>117,422</td><td>0</td><td>0 %</td>"
          "<td>8.90 ms</td><td>13.19 million</td><td>17.15 ×</td></tr>"));
  EXPECT_TRUE(has(page,
                  "<tr><th scope=\"row\">pipeline (loose)</th><td>119,300</td><td>+1,878</td>"
                  "<td>+1.60 %</td><td>710 µs</td><td>168.0 million</td><td>214.9 ×</td></tr>"));
  EXPECT_TRUE(has(page,
                  "<tr class=\"bold\"><th scope=\"row\">rtl</th><td>117,422</td><td>0</td>"
                  "<td>0 %</td><td>153 ms</td><td>0.7695 million</td><td>1.000 ×</td></tr>"));
}

TEST(UnitPage, SaysAtItsHeadWhetherPipelineAndRtlAgreeInTime) {
  const std::string agree =
      "✓ pipeline and rtl agree in the cycle of each of 65,536 pixels and in "
      "all 38 counters.";
  EXPECT_TRUE(has(page_of(made_unit_run(4, 4, 1)), agree));
  const std::string late = page_of(made_late_run(4, 4));
  const std::string head = late.substr(0, late.find("<main>"));
  EXPECT_TRUE(has(head, "✗ pipeline and rtl differ in time."));
  EXPECT_TRUE(has(head, "2 pixels leave in another cycle."));
  EXPECT_TRUE(has(head, "2 counters differ: <code>cycles</code>, <code>cycles_line_wait</code>."));
  EXPECT_FALSE(has(late, agree));
  EXPECT_TRUE(has(late, "<tr class=\"marked\"><th scope=\"row\"><code>cycles_line_wait</code>"));
  EXPECT_FALSE(has(late, "<tr class=\"marked\"><th scope=\"row\"><code>pixels</code>"));
  for (const bool pixel : {true, false}) {
    RunResult half = made_unit_run(4, 4, 1);
    half.unit->late_pixels = pixel ? 1 : 0;
    if (!pixel) half.unit->differing_counters = {"words"};
    const std::string page = page_of(half);
    EXPECT_FALSE(has(page, agree));
    EXPECT_EQ(has(page, "1 pixel leaves in another cycle."), pixel);
    EXPECT_EQ(has(page, "1 counter differs: <code>words</code>."), !pixel);
  }
  RunResult alone = made_unit_run(4, 4, 1);
  alone.unit->timings.pop_back();
  EXPECT_FALSE(has(page_of(alone), "✓ pipeline and rtl agree"));
}

TEST(UnitPage, LeavesOutWhatTheSceneDoesNotCallFor) {
  std::string page = page_of(made_unit_run(4, 4, 1));
  page.erase(page.find("id=\"made_by\""));  // the whole configuration follows
  for (const char* word : {"alette", "d2_map", "d1_color"}) EXPECT_FALSE(has(page, word)) << word;
  EXPECT_TRUE(has(page, "<code>hits_d0_color</code>"));
  const std::string palette = page_of(made_late_run(4, 4));
  EXPECT_TRUE(has(palette, "Palette look-ups a pixel</th><td>4.000</td>"));
  EXPECT_TRUE(has(palette, "<dt>Palette ports</dt><dd>4 for LRGB, 1 for RGB</dd>"));
}

TEST(UnitPage, EscapesHostileNamesOfObjectsAndTextures) {
  RunResult run = made_unit_run(4, 4, 1);
  const std::string hostile = "<script>alert(1)</script>\"'><svg onload=alert(2)>";
  UnitSection& unit = *run.unit;
  unit.memory = hostile;
  for (UnitDraw& draw : unit.draws) draw.object = draw.texture = draw.color = hostile;
  unit.differing_counters = {hostile};
  const std::string page = page_of(run);
  EXPECT_FALSE(has(page, "<script"));
  EXPECT_FALSE(has(page, "<svg onload"));
  EXPECT_TRUE(has(page, "&lt;svg onload"));
}

TEST(UnitPage, HoldsNoFigureThatIsNoNumberWhenNothingWasCounted) {
  RunResult run = made_unit_run(4, 4, 1);
  for (UnitTiming& timing : run.unit->timings) {
    timing = {
        timing.model,
        0,
        timing.estimate,
        {},
        timing.lines_per_window.empty() ? timing.lines_per_window : std::vector<std::uint32_t>{0}};
  }
  run.unit->draws.resize(5, {"fifth", "e.ptm", "", 1});
  const std::string page = page_of(run);
  std::string text = std::regex_replace(page, std::regex("base64,[A-Za-z0-9+/=]*"), "");
  EXPECT_FALSE(std::regex_search(text, std::regex("[> \"-](nan|inf)[< \"%]")));
  EXPECT_TRUE(has(page, tile("–", "pixels a cycle")));
  EXPECT_TRUE(has(page, "4 · fifth"));
  run.unit->timings.clear();
  EXPECT_TRUE(has(page_of(run), "No model of time ran."));
}

}  // namespace
}  // namespace ptm::testbench
