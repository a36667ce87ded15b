#include "golden/files/number_text.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <random>

namespace ptm::tests {
namespace {

using golden::format_real;
using golden::parse_integer;
using golden::parse_real;

TEST(NumberText, EveryFiniteDoubleReadsBackAsItself) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 20000; ++i) {
    const auto value = std::bit_cast<double>(random());
    if (!std::isfinite(value)) continue;
    ASSERT_EQ(parse_real(format_real(value)), value) << format_real(value);
  }
  for (const double value : {0.1, -0.1, 1e-5, 9.9e-6, 999999999.0, 1e9, 5e-324, 1.7e308}) {
    ASSERT_EQ(parse_real(format_real(value)), value) << format_real(value);
  }
}

TEST(NumberText, OrdinaryNumbersHaveAPointAndNoExponent) {
  EXPECT_EQ(format_real(2), "2.0");
  EXPECT_EQ(format_real(-0.25), "-0.25");
  EXPECT_EQ(format_real(0.00001), "0.00001");
  EXPECT_EQ(format_real(123456789), "123456789.0");
}

TEST(NumberText, RealsAreWholeWordsAndFinite) {
  EXPECT_EQ(parse_real("+3"), 3);
  EXPECT_EQ(parse_real(".5"), 0.5);
  EXPECT_EQ(parse_real("2."), 2);
  for (const char* bad :
       {"", "+", "nan", "inf", "-inf", "1e999", "1e-999", "2x", "0x10", "1,5", "+-1", "++1"}) {
    EXPECT_FALSE(parse_real(bad)) << bad;
  }
}

TEST(NumberText, IntegersStayInTheirRange) {
  EXPECT_EQ(parse_integer("+7", 0, 9), 7);
  EXPECT_EQ(parse_integer("-715", -1000, 0), -715);
  for (const char* bad : {"", "10", "-1", "1.0", "7 ", "99999999999999999999"}) {
    EXPECT_FALSE(parse_integer(bad, 0, 9)) << bad;
  }
}

TEST(NumberText, QuotedBytesFitOneLine) {
  EXPECT_EQ(golden::quoted("PTM\r\x01"), "\"PTM\\x0d\\x01\"");
  EXPECT_EQ(golden::quoted(std::string(50, 'a')), "\"" + std::string(40, 'a') + "...\"");
}

}  // namespace
}  // namespace ptm::tests
