#include "testbench/report/html_text.h"

#include <gtest/gtest.h>

#include <limits>

namespace ptm::testbench {
namespace {

TEST(HtmlText, EscapesWhatHasMeaningInHtml) {
  EXPECT_EQ(html_escape("<b a=\"1\" c='2'>&amp;"),
            "&lt;b a=&quot;1&quot; c=&#39;2&#39;&gt;&amp;amp;");
  EXPECT_EQ(html_escape("a\x01\n"), "a\xEF\xBF\xBD\n");
}

TEST(HtmlText, EncodesTheTestVectorsOfRfc4648) {
  const char* rows[7][2] = {{"", ""},
                            {"f", "Zg=="},
                            {"fo", "Zm8="},
                            {"foo", "Zm9v"},
                            {"foob", "Zm9vYg=="},
                            {"fooba", "Zm9vYmE="},
                            {"foobar", "Zm9vYmFy"}};
  for (const auto& row : rows) {
    const std::string text = row[0];
    EXPECT_EQ(base64(std::vector<std::uint8_t>(text.begin(), text.end())), row[1]);
  }
  EXPECT_EQ(base64(std::vector<std::uint8_t>{255, 254, 253, 0}), "//79AA==");
}

TEST(HtmlText, GroupsDigitsByThousands) {
  EXPECT_EQ(grouped(0), "0");
  EXPECT_EQ(grouped(999), "999");
  EXPECT_EQ(grouped(1000), "1,000");
  EXPECT_EQ(grouped(18446744073709551615U), "18,446,744,073,709,551,615");
}

TEST(HtmlText, NeverPrintsAFigureThatIsNotZeroAsZeroNorOneThatIsNotOneAsOne) {
  EXPECT_EQ(levels(0), "0");
  EXPECT_EQ(levels(2), "2");
  EXPECT_EQ(levels(0.5), "0.5");
  EXPECT_EQ(levels(16.10826), "16.11");
  EXPECT_EQ(levels(0.00002), "2e-05");
  EXPECT_EQ(similarity(1), "1");
  EXPECT_EQ(similarity(1 - 1e-9), "&gt; 0.99999");
  EXPECT_EQ(similarity(0.997512), "0.99751");
  EXPECT_EQ(share(0), "0 %");
  EXPECT_EQ(share(1), "100 %");
  EXPECT_EQ(share(0.12345), "12.35 %");
  EXPECT_EQ(share(1.0 / 786432), "0.00013 %");
}

TEST(HtmlText, PrintsFourSignificantDigitsOfAMeasuredNumber) {
  EXPECT_EQ(significant(0), "0");
  EXPECT_EQ(significant(1), "1.000");
  EXPECT_EQ(significant(0.55812), "0.5581");
  EXPECT_EQ(significant(0.04730468), "0.04730");
  EXPECT_EQ(significant(9.9996), "10.00");
  EXPECT_EQ(significant(99.996), "100.0");
  EXPECT_EQ(significant(123.456), "123.5");
  EXPECT_EQ(significant(999.96), "1,000");
  EXPECT_EQ(significant(12345.6), "12,346");
  EXPECT_EQ(significant(0.0000012345678), "1.235e-06");
}

TEST(HtmlText, PrintsDecibelsAndDurationsWithUnits) {
  EXPECT_EQ(decibels(57.4949), "57.49 dB");
  EXPECT_EQ(decibels(101.26), "101.3 dB");
  EXPECT_EQ(decibels(-2.5), "-2.500 dB");
  EXPECT_EQ(decibels(std::numeric_limits<double>::infinity()), "∞ dB");
  EXPECT_EQ(duration(75.25), "75.2 s");
  EXPECT_EQ(duration(1.2345), "1.23 s");
  EXPECT_EQ(duration(0.1234), "123 ms");
  EXPECT_EQ(duration(4.5e-5), "45.0 µs");
  EXPECT_EQ(duration(2.5e-8), "25.0 ns");
}

}  // namespace
}  // namespace ptm::testbench
