#include <sstream>
#include <vector>

#include "tests/run_program.h"

namespace ptm {
namespace {

using VectorsCommand = tests::Program;

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

TEST_F(VectorsCommand, PrintsTheStatedHeaderAndOneRowAVector) {
  const auto lines = lines_of(run("vectors --preset base --count 25 --seed 3").out);
  ASSERT_EQ(lines.size(), 26U);
  EXPECT_EQ(lines[0],
            "coef0,coef1,coef2,coef3,coef4,coef5,bias0,bias1,bias2,bias3,bias4,bias5,"
            "shift0,shift1,shift2,shift3,shift4,shift5,r,g,b,lu,lv,lum,lum_saturated,"
            "out_r,out_g,out_b,color_saturated");
  EXPECT_EQ(lines_of(run("vectors --unit lerp --count 0").out),
            (std::vector<std::string>{"a,b,f,out"}));
}

TEST_F(VectorsCommand, GivesEveryModelTheSameOperandsAndGetsTheSameResults) {
  for (const std::string kind : {"--format lrgb", "--format rgb", "--unit lerp"}) {
    for (const std::string preset : {"paper8", "base", "wide"}) {
      const std::string command = "vectors --count 2000 --seed 9 --preset " + preset + " " + kind;
      const std::string reference = run(command + " --model reference").out;
      EXPECT_EQ(lines_of(reference).size(), 2001U);
      EXPECT_EQ(run(command + " --model rtl").out, reference) << kind << " " << preset;
      EXPECT_EQ(run(command + " --model pipeline").out, reference) << kind << " " << preset;
    }
  }
}

TEST_F(VectorsCommand, DrawsOtherOperandsFromAnotherSeed) {
  EXPECT_NE(run("vectors --count 5 --seed 1").out, run("vectors --count 5 --seed 2").out);
}

TEST_F(VectorsCommand, EndsWithTwoWhenUsedWrongly) {
  EXPECT_EQ(run("vectors --preset base --model golden").code, 2);
  EXPECT_EQ(run("vectors --count minus").code, 2);
}

}  // namespace
}  // namespace ptm
