#include "golden/files/figure_text.h"

#include <gtest/gtest.h>

#include <string>

namespace ptm::golden {
namespace {

TEST(CountOf, TakesTheSingularForOneAlone) {
  EXPECT_EQ(count_of(1, "level"), "1 level");
  EXPECT_EQ(count_of(0, "level"), "0 levels");
  EXPECT_EQ(count_of(2U, "level"), "2 levels");
  EXPECT_EQ(count_of(11, "level"), "11 levels");
  EXPECT_EQ(count_of(std::uint64_t{1}, "level"), "1 level");
  EXPECT_EQ(count_of(-1, "level"), "-1 levels");
}

TEST(CountOf, LooksAtANumberAsItIsPrinted) {
  EXPECT_EQ(count_of("1", "level"), "1 level");
  EXPECT_EQ(count_of("1.5", "level"), "1.5 levels");
  EXPECT_EQ(count_of("1,000", "pixel"), "1,000 pixels");
  EXPECT_EQ(count_of(std::string("0.25"), "level"), "0.25 levels");
}

TEST(CountOf, FormsPluralsOfNounsThatHissOrEndInY) {
  EXPECT_EQ(count_of(3, "evaluator pass"), "3 evaluator passes");
  EXPECT_EQ(count_of(1, "evaluator pass"), "1 evaluator pass");
  EXPECT_EQ(count_of(2, "index"), "2 indexes");
  EXPECT_EQ(count_of(2, "palette entry"), "2 palette entries");
  EXPECT_EQ(count_of(1, "palette entry"), "1 palette entry");
  EXPECT_EQ(count_of(2, "day"), "2 days");
}

TEST(FourDigits, AreSignificantOnesWithoutZerosAtTheEnd) {
  EXPECT_EQ(four_digits(16.10826), "16.11");
  EXPECT_EQ(four_digits(0.57741), "0.5774");
  EXPECT_EQ(four_digits(0.5), "0.5");
  EXPECT_EQ(four_digits(72), "72");
  EXPECT_EQ(four_digits(123456), "1.235e+05");
  EXPECT_EQ(four_digits(0.000012), "1.2e-05");
  EXPECT_EQ(four_digits(-255.04), "-255");
}

TEST(FourDigits, OfABoundAreRoundedUp) {
  EXPECT_EQ(four_digits_bound(3.08841), "3.089");
  EXPECT_EQ(four_digits_bound(3.08849), "3.089");
  EXPECT_EQ(four_digits_bound(3.08851), "3.089");
  EXPECT_EQ(four_digits_bound(9.99901), "10");
  EXPECT_EQ(four_digits_bound(1000.2), "1001");
  EXPECT_EQ(four_digits_bound(2.5), "2.5");
  EXPECT_EQ(four_digits_bound(0), "0");
  for (double bound = 1e-6; bound < 1e6; bound *= 1.0137) {
    const double printed = std::stod(four_digits_bound(bound));
    EXPECT_GE(printed, bound);
    // A unit of the fourth digit is at most a thousandth of the number.
    EXPECT_LE(printed, bound * 1.001) << bound;
  }
}

}  // namespace
}  // namespace ptm::golden
