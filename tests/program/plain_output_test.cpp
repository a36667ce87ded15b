// What commands print for people: counts of one in the singular, and figures of at most four
// significant digits.
#include <cmath>
#include <regex>

#include "golden/files/ptm_file.h"
#include "tests/program/small_map.h"
#include "tests/run_program.h"

namespace ptm {
namespace {

using tests::quoted;

/// "1 levels" and the like; not "4097 x 1 texels", whose 1 is no count of them.
std::string plural_of_one(const std::string& text) {
  static const std::regex wrong(
      "(?:^|\\n|[^x][ (])1 (?:[a-z]+ )?(?:levels|passes|words|texels|entries|rounds|lights|samples|"
      "photographs|coefficients|cycles|bytes|lines|draws|pictures|degrees|elements)\\b");
  std::smatch found;
  return std::regex_search(text, found, wrong) ? found.str() : std::string();
}

/// The first number with a point that has more than four significant digits.
std::string long_figure(const std::string& text) {
  static const std::regex figure("[0-9]+\\.[0-9]+");
  for (std::sregex_iterator at(text.begin(), text.end(), figure), end; at != end; ++at) {
    std::string digits;
    for (const char c : at->str()) {
      if (c != '.' && (c != '0' || !digits.empty())) digits += c;
    }
    if (digits.size() > 4) return at->str();
  }
  return {};
}

class PlainOutput : public tests::Program {
 protected:
  std::string expect_plain(const std::string& arguments) const {
    const tests::Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, 0) << arguments << '\n' << outcome.err;
    EXPECT_EQ(plural_of_one(outcome.out), "") << outcome.out;
    EXPECT_EQ(long_figure(outcome.out), "") << outcome.out;
    return outcome.out;
  }
};

TEST(PlainOutputChecks, FindPluralsOfOneAndLongFigures) {
  EXPECT_NE(plural_of_one("off by 1 levels"), "");
  EXPECT_NE(plural_of_one("1 saturated samples"), "");
  EXPECT_NE(plural_of_one("a\n1 passes"), "");
  EXPECT_EQ(plural_of_one("1 level, 21 levels, 0.1 levels, found 4097 x 1 texels"), "");
  EXPECT_NE(long_figure("mean 115.873"), "");
  EXPECT_EQ(long_figure("mean 115.9, 0.005774, 1.2e-05"), "");
}

TEST_F(PlainOutput, OfFittingSaysWhatItsDecibelsMean) {
  const std::string made =
      expect_plain("synthesize --size 16 --lights 1 --out " + quoted(file("one")));
  EXPECT_NE(made.find("1 photograph of 16 x 16"), std::string::npos) << made;
  expect_plain("synthesize --size 32 --lights 20 --out " + quoted(file("c")));
  const std::string text =
      expect_plain("fit " + quoted(file("c/capture.lp")) + " --out " + quoted(file("m.ptm")));
  const std::regex meaning(
      "what that means: ([0-9.]+) dB is an RMS error of ([0-9.]+) % of white\n");
  std::smatch found;
  ASSERT_TRUE(std::regex_search(text, found, meaning)) << text;
  const double decibels = std::stod(found[1]), percent = std::stod(found[2]);
  // Half of the fourth digit of decibels, 0.005 dB, is 0.06 % of the error.
  EXPECT_NEAR(percent, 100 * std::pow(10, -decibels / 20), 0.001 * percent);
  EXPECT_NE(text.find("as stored:   "), std::string::npos);
  EXPECT_NE(text.find(", " + found[1].str() + " dB, "), std::string::npos) << text;
}

TEST_F(PlainOutput, OfMapsHasCountsOfOneInTheSingular) {
  const auto map = file("m.ptm");
  golden::write_ptm(map, tests::small_map(golden::MapKind::lrgb, 1, 1));
  expect_plain("info --all " + quoted(map));
  const std::string palette =
      expect_plain("convert " + quoted(map) + " --palette 2 " + quoted(file("p.ptm")));
  EXPECT_NE(palette.find("a palette of 1 entry after"), std::string::npos) << palette;
  expect_plain("convert " + quoted(map) + " --format jpeg " + quoted(file("j.ptm")));
  golden::write_ptm(map, tests::small_map(golden::MapKind::lrgb, 8, 8));
  expect_plain("info --all " + quoted(map));
  expect_plain("convert " + quoted(map) + " --palette 4 " + quoted(file("p.ptm")));
}

TEST_F(PlainOutput, OfAPlanHasCountsOfOneInTheSingular) {
  const std::string scene = quoted(
      write("scene.toml",
            "[[texture]]\nname = \"m\"\ngenerate = \"studs\"\nsize = [16, 16]\npalette = true\n"
            "[[object]]\nkind = \"sphere\"\ntexture = \"m\"\n"
            "[[light]]\ndirection = [0, -1, 1]\n"));
  const std::string text = expect_plain("plan " + scene);
  EXPECT_NE(text.find("1 word a texel, 1 pass of the map's and 0 of effects"), std::string::npos)
      << text;
}

}  // namespace
}  // namespace ptm
