#include "model/quantize/import.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "model/quantize/quantize.h"
#include "tests/shared_data.h"

namespace ptm::quantize {
namespace {

using reference::EvalConfig;

const std::vector<std::uint8_t> kBytes{10, 20, 30, 40, 50, 60, 255, 0, 128, 127, 1, 254};

FileCoefficients file() {
  return {.width = 2,
          .height = 1,
          .polynomials = 1,
          .coef = kBytes,
          .scale = {2, 1, 0.5, 16, 0.25, std::ldexp(1.0, -15)},
          .bias = {0, 128, 255, 1, 2, 3}};
}

/// The reason for refusing, or "" if the map was taken.
std::string refusal(const FileCoefficients& f, const EvalConfig& config = {}) {
  const Import import = import_verbatim(f, config);
  EXPECT_NE(import.map.has_value(), !import.why_not.empty());
  return import.why_not;
}

TEST(ImportVerbatim, KeepsEveryIntegerAndTurnsScalesIntoShifts) {
  const Import import = import_verbatim(file(), EvalConfig{});
  ASSERT_TRUE(import.map) << import.why_not;
  EXPECT_EQ(import.map->coef, std::vector<std::uint16_t>(kBytes.begin(), kBytes.end()));
  EXPECT_EQ(import.map->shift, (Six<int>{-1, 0, 1, -4, 2, 15}));
  EXPECT_EQ(import.map->bias, (Six<int>{0, 128, 255, 1, 2, 3}));
  EXPECT_EQ(import.map->origin, Origin::verbatim);
  EXPECT_EQ(import.map->rms_error, 0);
  const std::vector<double> real = dequantize(*import.map);
  EXPECT_EQ(real[0], 20.0);
  EXPECT_EQ(real[8], (128 - 255) * 0.5);
}

TEST(ImportVerbatim, RefusesScalesThatAreNoPowersOfTwoOrOutOfRange) {
  for (const double bad :
       {3.0, -2.0, 0.0, 1.9999, double(INFINITY), double(NAN), 32.0, std::ldexp(1.0, -16)}) {
    FileCoefficients f = file();
    f.scale[4] = bad;
    EXPECT_NE(refusal(f).find("scale 4"), std::string::npos) << bad;
  }
}

TEST(ImportVerbatim, RefusesBiasesThatDoNotFit) {
  for (const int bad : {-1, 256, -715, 527}) {
    FileCoefficients f = file();
    f.bias[3] = bad;
    EXPECT_NE(refusal(f).find("bias 3"), std::string::npos) << bad;
  }
}

TEST(ImportVerbatim, RefusesDeltasThatWouldSaturateOnTheActualData) {
  EvalConfig narrow;
  narrow.delta_bits = 8;
  FileCoefficients f = file();
  f.bias = {128, 128, 128, 128, 128, 128};
  EXPECT_EQ(refusal(f, narrow), "");
  f.bias[0] = 127;  // 255 - 127 = 128 does not fit
  EXPECT_NE(refusal(f, narrow).find("coefficient 0 less its bias reaches 128"), std::string::npos);
  f.bias[0] = 128;
  f.bias[1] = 129;  // 0 - 129 does not fit
  EXPECT_NE(refusal(f, narrow).find("coefficient 1 less its bias reaches -129"), std::string::npos);
}

TEST(ImportVerbatim, RefusesBytesWiderThanTheStoredCoefficient) {
  EvalConfig narrow;
  narrow.coef_bits = 7;
  FileCoefficients f = file();
  f.bias = {};
  EXPECT_NE(refusal(f, narrow).find("coefficient 0 reaches 255"), std::string::npos);
}

TEST(ImportVerbatim, WantsEqualScalesWithinTheGroupsOfThreeShifts) {
  EvalConfig three;
  three.shift_groups = 3;
  FileCoefficients f = file();
  f.scale = {2, 2, 2, 1, 1, 4};
  EXPECT_EQ(refusal(f, three), "");
  f.scale[2] = 1;
  EXPECT_NE(refusal(f, three).find("scales 0 and 2"), std::string::npos);
  f.scale = {2, 2, 2, 1, 2, 4};
  EXPECT_NE(refusal(f, three).find("scales 3 and 4"), std::string::npos);
}

TEST(ImportVerbatim, RejectsWrongSizesAsACallersMistake) {
  FileCoefficients f = file();
  f.width = 3;
  EXPECT_THROW((void)import_verbatim(f, EvalConfig{}), std::invalid_argument);
  EvalConfig bad;
  bad.coef_bits = 13;
  EXPECT_THROW((void)import_verbatim(file(), bad), std::invalid_argument);
}

TEST(ImportVerbatim, TakesHewlettPackardsTabletAsItIsOnBase) {
  PTM_SHARED_DATA_OR_SKIP(path, "tablet2/tablet2_LRGB.ptm");
  std::ifstream in(path, std::ios::binary);
  const std::vector<char> all((std::istreambuf_iterator<char>(in)), {});
  constexpr std::size_t kCoefficients = 512UL * 512 * 6, kColour = 512UL * 512 * 3;
  ASSERT_GT(all.size(), kCoefficients + kColour);
  const char* first = all.data() + (all.size() - kCoefficients - kColour);
  const std::vector<std::uint8_t> coef(first, first + kCoefficients);
  const FileCoefficients tablet{.width = 512,
                                .height = 512,
                                .polynomials = 1,
                                .coef = coef,
                                .scale = {2, 2, 2, 2, 2, 2},
                                .bias = {149, 151, 68, 77, 77, 0}};
  EXPECT_EQ(refusal(tablet), "");
  // Its own integers are also what quantising its real coefficients gives back, to the last one.
  const Import import = import_verbatim(tablet, EvalConfig{});
  const std::vector<double> real = dequantize(*import.map);
  const StoredMap again =
      quantize({512, 512, 1, real}, EvalConfig{}, Method::nearest_plane, hemisphere_gram());
  EXPECT_EQ(again.rms_error, 0);
}

}  // namespace
}  // namespace ptm::quantize
