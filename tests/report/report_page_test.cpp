#include <gtest/gtest.h>

#include <regex>

#include "testbench/report/report_html.h"
#include "tests/report/made_run.h"

namespace ptm::testbench {
namespace {

using tests::made_faulty_run;
using tests::made_run;

std::string page_of(const RunResult& run) {
  PngCache pngs;
  return report_html(run, compare_run(run), pngs);
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

TEST(ReportPage, EscapesHostileNamesWhereverTheyStand) {
  RunResult run = made_run(4, 4, 1);
  const std::string hostile = "<script>alert(1)</script>\"'><img src=x onerror=alert(2)>";
  run.scene_file = run.map_file = run.map_format = run.preset = hostile;
  run.presets[0].preset = run.presets[1].preset = hostile;
  run.notes = {hostile};
  run.models[2].counters = {{hostile, 1}};
  run.probe = [&](const std::string&, int, int, int) {
    return std::vector<NamedValue>{{hostile, hostile}};
  };
  const std::string page = page_of(run);
  EXPECT_EQ(page.find("<script"), std::string::npos);
  EXPECT_EQ(page.find("<img src=x"), std::string::npos);
  EXPECT_GE(count(page, "&lt;script&gt;"), 9U);
}

TEST(ReportPage, SaysTheConfigurationTheCommandAndTheMachine) {
  RunResult run = made_run(4, 4, 1);
  run.config.evaluator.guard = 7;
  run.config.evaluator.rounding = reference::Rounding::truncate;
  const std::string page = page_of(run);
  for (const char* fact :
       {"<dt>guard</dt><dd>7</dd>", "<dt>rounding</dt><dd>truncate</dd>", "<dt>tmus</dt><dd>3</dd>",
        "commit 0123456789abcdef0123456789abcdef01234567</dd>",
        "<dd>build/release/ptmsim run &#39;scenes/a ball&#39;\\&#39;&#39;s.toml&#39; --out "
        "out</dd>",
        "<dt>Date</dt><dd>2026-01-31T23:59:59Z</dd>", "A Processor, 2 cores"}) {
    EXPECT_EQ(count(page, fact), 1U) << fact;
  }
  EXPECT_EQ(page.find("sources changed"), std::string::npos);
  run.made_by.invocation.changed = true;
  EXPECT_NE(page_of(run).find("01234567, sources changed since</dd>"), std::string::npos);
}

TEST(ReportPage, NamesNoAddressAndHoldsNoScript) {
  const std::string page = page_of(made_faulty_run(24, 16, 3));
  for (const char* forbidden : {"http", "//cdn", "<script", "javascript:", "@import", "url("}) {
    // Picture data may hold any letters, so it is cut out first.
    const std::string text = std::regex_replace(page, std::regex("base64,[A-Za-z0-9+/=]*"), "");
    const std::string meta = "http-equiv";  // the one word of HTML that begins so
    EXPECT_EQ(count(text, forbidden), std::string(forbidden) == "http" ? count(text, meta) : 0U)
        << forbidden;
  }
  EXPECT_NE(page.find("default-src 'none'; img-src data:; style-src 'unsafe-inline'"),
            std::string::npos);
}

TEST(ReportPage, ShowsEveryModelsPictureAndTheHeatMap) {
  const std::string page = page_of(made_run(10, 10, 1));
  EXPECT_EQ(count(page, "<img"), 5U);
  EXPECT_EQ(count(page, "alt=\"Picture by"), 4U);
  EXPECT_EQ(count(page, "alt=\"Heat map of errors, reference against golden"), 1U);
  EXPECT_NE(page.find("Sample for sample the same: pipeline against golden, rtl against golden."),
            std::string::npos);
  EXPECT_NE(page.find("reference, pipeline and rtl differ in 0 of 300 samples"), std::string::npos);
}

TEST(ReportPage, SaysHowManyLightsItDoesNotShow) {
  const std::string page = page_of(made_run(6, 6, 14));
  EXPECT_EQ(count(page, "<h3>Light "), 12U);
  EXPECT_NE(page.find("2 more lights are not shown here"), std::string::npos);
  EXPECT_EQ(page_of(made_run(6, 6, 12)).find("not shown here"), std::string::npos);
}

TEST(ReportPage, ReportsModelsThatMustAgreeAndDoNot) {
  const std::string page = page_of(made_faulty_run(30, 20, 2));
  EXPECT_NE(page.find("reference and rtl differ in 3 of 3,600 samples, by up to 3 levels"),
            std::string::npos);
  EXPECT_NE(page.find("pipeline and rtl differ in 3 of 3,600 samples"), std::string::npos);
  EXPECT_EQ(page.find("differ in 0 of"), std::string::npos);
  EXPECT_NE(page.find("All pixels that differ: x 7, y 2 of light 2 by 3; x 7, y 1 of light 2 by 2"),
            std::string::npos);
  EXPECT_NE(page.find("<tr class=\"marked\"><th scope=\"row\"><code>stall_cycles</code>"),
            std::string::npos);
  EXPECT_EQ(page.find("<tr class=\"marked\"><th scope=\"row\"><code>pixels</code>"),
            std::string::npos);
  EXPECT_NE(page.find("<tr class=\"marked\"><th scope=\"row\">acc</th>"), std::string::npos);
  EXPECT_EQ(page.find("<tr class=\"marked\"><th scope=\"row\">lum</th>"), std::string::npos);
}

TEST(ReportPage, IsCompleteForOneModelOfOnePixel) {
  RunResult run = made_run(1, 1, 1);
  run.models.resize(1);
  run.probe = nullptr;
  const std::string page = page_of(run);
  EXPECT_EQ(count(page, "<img"), 1U);
  EXPECT_NE(page.find("</html>"), std::string::npos);
  EXPECT_EQ(page.find("nan"), std::string::npos);
}

/// Base64 of four pictures at full size and twelve rows of small ones bounds the page, however
/// large the map and however many the lights: 4 * 1024^2 * 3 + 12 * 5 * 256^2 * 3 bytes at most,
/// times 4/3, if PNG gained nothing; here it gains about half.
TEST(ReportPage, StaysUnderTwelveMegabytesForALargeMapUnderManyLights) {
  RunResult run = made_run(1100, 800, 2);
  run.presets.clear();
  const std::string page = page_of(run);
  EXPECT_LT(page.size(), 12U << 20);
  EXPECT_NE(page.find("shown 1 : 2, the mean of 2 × 2 pixels"), std::string::npos);
  EXPECT_NE(page.find("shown 1 : 5, the largest of 5 × 5 pixels"), std::string::npos);
}

}  // namespace
}  // namespace ptm::testbench
