// Mistakes in the tables of registers, counters and texel formats, each refused with file and line.
#include <gtest/gtest.h>

#include "tests/contract/changed_tables.h"

namespace ptm::tests {
namespace {

struct Mistake {
  const char *name, *table, *from, *to, *said;
};

class PortTables : public testing::TestWithParam<Mistake> {};

TEST_P(PortTables, RefuseWhatDoesNotFit) {
  const Mistake& mistake = GetParam();
  ChangedTables tables;
  const long line = tables.replace(mistake.table, mistake.from, mistake.to);
  const Ended ended = tables.generate();
  EXPECT_EQ(ended.code, 3);
  EXPECT_EQ(ended.said.find(std::string("ptm_contract: ") + mistake.table + ":" +
                            std::to_string(line) + ": " + mistake.said),
            0U)
      << ended.said << "line " << line;
  EXPECT_FALSE(std::filesystem::exists(tables.scratch() / "include"));
}

constexpr const char *kRegisters = "registers.toml", *kCounters = "counters.toml",
                     *kFormats = "formats.toml";

INSTANTIATE_TEST_SUITE_P(
    Tables, PortTables,
    testing::Values(
        Mistake{"FieldsOverlap", kRegisters, "name = \"mip\", low = 3", "name = \"mip\", low = 2",
                "low: bits [3:2] are taken"},
        Mistake{"FieldBeyondTheWord", kRegisters, "name = \"ks\", low = 18, width = 9",
                "name = \"ks\", low = 24, width = 9", "width: found 9, expected 1 to 8"},
        Mistake{"OffsetTaken", kRegisters, "offset = 10\n", "offset = 9\n",
                "offset: offset 9 is taken"},
        Mistake{"RegisterBeyondItsBlock", kRegisters, "offset = 32\n", "offset = 52\n",
                "offset: copy 12 lies at 64, expected less than 64"},
        Mistake{"BlocksOverlap", kRegisters, "address = 0x2800", "address = 0x2000",
                "address: lies on the block 'counter'"},
        Mistake{"BlockNotAligned", kRegisters, "address = 0x2800", "address = 0x2840",
                "address: found 0x2840, 128 long"},
        Mistake{"PlaceTooNarrow", kRegisters, "name = \"palette\", low = 14, width = 2",
                "name = \"palette\", low = 14, width = 3", "in: the place is 2 bits wide"},
        Mistake{"PlaceOfNoName", kRegisters, "in = \"draw.kd\"", "in = \"draw.kq\"",
                "in: found 'kq', no place of the layout 'draw'"},
        Mistake{"PlaceTwice", kRegisters, "in = \"draw.kd\"", "in = \"draw.ka\"",
                "in: the place 'draw.ka' is taken"},
        Mistake{"UnknownParameter", kRegisters, "value = \"tmus\"", "value = \"tmu\"",
                "value: found 'tmu', expected a parameter"},
        Mistake{"NeedOfNoParameter", kRegisters, "needs = \"extra_sets\"", "needs = \"sets\"",
                "needs: found 'sets', no parameter"},
        Mistake{"UnknownKey", kRegisters, "access = \"wo\"", "acces = \"wo\"",
                "unknown key 'acces'"},
        Mistake{"CodesTooMany", kRegisters, "name = \"mip\", low = 3, width = 2",
                "name = \"mip\", low = 3, width = 1", "width: the codes of 'mip' do not fit"},
        Mistake{"NumberTaken", kCounters, "number = 16\n", "number = 15\n",
                "number: 15 is taken by 'duplicate_lines'"},
        Mistake{"CounterOfNoParameter", kCounters, "needs = \"duplicate_lines\"",
                "needs = \"duplicates\"", "needs: found 'duplicates', no parameter"},
        Mistake{"UnknownKind", kFormats, "kind = \"color\"", "kind = \"colour\"",
                "kind: found 'colour', no [[kind]]"},
        Mistake{"FieldsBeyondTheMaps", kFormats, "kind = \"color\", field = 18",
                "kind = \"color\", field = 19", "field: the word's fields end beyond 21"},
        Mistake{"FourCoefficientsAWord", kFormats, "fields = 3", "fields = 4",
                "fields: found 4, expected 3 coefficients"},
        Mistake{"NeedOfNoIndex", kRegisters, "needs = \"coef_bits > 10\"",
                "needs = \"coef_bits > n\"", "needs: found 'n', no index of the register or field"},
        Mistake{"TwoPasses", kFormats, "passes = 3", "passes = 2",
                "passes: found 2, expected 1 or 3"}),
    [](const auto& tested) { return std::string(tested.param.name); });

TEST(PortTablesWhole, RefuseWhatNoRowSaysAlone) {
  ChangedTables tables;
  tables.replace("registers.toml", "{ name = \"ks\", width = 9 },",
                 "{ name = \"ks\", width = 9 },\n  { name = \"kq\", width = 5 },");
  const Ended place = tables.generate();
  EXPECT_EQ(place.code, 3);
  EXPECT_NE(place.said.find("draw.kq: no field of a register fills the place"), std::string::npos)
      << place.said;

  ChangedTables most;
  most.replace("registers.toml", "name = \"extra_passes_max\"\nvalue = 4",
               "name = \"extra_passes_max\"\nvalue = 5");
  const Ended passes = most.generate();
  EXPECT_EQ(passes.code, 3);
  EXPECT_NE(passes.said.find("extra_passes_max = 5, expected 4"), std::string::npos) << passes.said;

  ChangedTables gap;
  gap.replace("counters.toml", "number = 37\n", "number = 38\n");
  const Ended number = gap.generate();
  EXPECT_EQ(number.code, 3);
  EXPECT_NE(number.said.find("no counter has the number 37"), std::string::npos) << number.said;
}

TEST(PortTablesWhole, DealTheCoefficientsOfWordsOutAnewWhereAWordHoldsTwo) {
  ChangedTables tables;
  tables.append("formats.toml", R"(
[[format]]
name = "short"
title = "short"
meaning = "three coefficients, a colour, three more"
words = [
  { kind = "coefficients", field = 0 },
  { kind = "color", field = 18 },
  { kind = "coefficients", field = 3 },
]
polynomials = 1
passes = 1
multiplies = 11
)");
  const Ended ended = tables.generate();
  ASSERT_EQ(ended.code, 0) << ended.said;
  const std::string header = whole_text(tables.scratch() / "include/contract/formats.h");
  const auto words = [&header](const std::string& begin) {
    const std::size_t at = header.find(begin);
    EXPECT_NE(at, std::string::npos) << header;
    std::string text = header.substr(at, header.find("}},", at) - at);
    std::erase(text, ' ');
    std::erase(text, '\n');
    return text;
  };
  EXPECT_EQ(words("FormatWords{3, {  // short"),
            "FormatWords{3,{//shortFormatWord{WordKind::coefficients,0,3},"
            "FormatWord{WordKind::color,18,4},FormatWord{WordKind::coefficients,3,3}");
  EXPECT_EQ(words("FormatWords{5, {  // short"),
            "FormatWords{5,{//shortFormatWord{WordKind::coefficients,0,2},"
            "FormatWord{WordKind::coefficients,2,1},FormatWord{WordKind::color,18,4},"
            "FormatWord{WordKind::coefficients,3,2},FormatWord{WordKind::coefficients,5,1}");
}

}  // namespace
}  // namespace ptm::tests
