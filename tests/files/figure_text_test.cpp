#include "golden/files/figure_text.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace ptm::golden
