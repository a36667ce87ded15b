// What it takes to add to the contract: a parameter, a field of a register, a counter and a texel
// format are added to a copy of its tables and to nothing else, and found in all that is made of
// them: C++ that the compiler takes, with the reference's own files on top; SystemVerilog that
// Verilator takes as the whole unit; the driver's header, the register description, JSON, TOML and
// the pages.
#include <gtest/gtest.h>

#include <sstream>

#include "tests/contract/changed_tables.h"
#include "tests/contract/rdl_reader.h"

namespace ptm::tests {
namespace {

namespace fs = std::filesystem;

const fs::path kRoot = PTM_SOURCE_DIR;

class ContractGrowth : public testing::Test {
 protected:
  void SetUp() override {
    tables_.append("parameters.toml", R"(
[[parameter]]
of = "unit"
name = "sample_fifo"
rtl = "SampleFifo"
range = [2, 60]
default = 5
unit = "samples"
meaning = "samples that wait for their line"
)");
    tables_.replace("registers.toml", "{ name = \"ks\", width = 9 },",
                    "{ name = \"ks\", width = 9 },\n  { name = \"kq\", width = 5 },");
    tables_.replace(
        "registers.toml", "{ name = \"ks\", low = 18,",
        "{ name = \"kq\", low = 27, width = 5, in = \"draw.kq\", meaning = \"of the quartic\" },\n"
        "  { name = \"ks\", low = 18,");
    tables_.replace("registers.toml", "{ name = \"miss_fifo\", low = 16,",
                    "{ name = \"sample_fifo\", low = 26, width = 6, value = \"sample_fifo\" },\n"
                    "  { name = \"miss_fifo\", low = 16,");
    tables_.append("counters.toml",
                   "\n[[counter]]\nnumber = 38\nname = \"lines_kept\"\n"
                   "meaning = \"lines that stayed for a second frame\"\n");
    tables_.append("formats.toml", R"(
[[format]]
name = "luminance"
title = "luminance"
meaning = "a luminance polynomial"
layout = "(a0 a1 a2), (a3 a4 a5), grey"
words = [{ kind = "coefficients", field = 0 }, { kind = "coefficients", field = 3 }]
polynomials = 1
passes = 1
multiplies = 8
)");
    const Ended made = tables_.generate();
    ASSERT_EQ(made.code, 0) << made.said;
  }

  [[nodiscard]] Ended run(const std::string& command) const { return tables_.run(command); }
  [[nodiscard]] fs::path committed(const std::string& path) const {
    return tables_.committed(path);
  }
  /// A page's or the schema's part that is made of the tables.
  [[nodiscard]] std::string block(const std::string& page, const std::string& name) const {
    return whole_text(committed("docs/spec/" + page) / name);
  }

  ChangedTables tables_;
  const ScratchFolder& scratch_ = tables_.scratch();
};

TEST_F(ContractGrowth, IsFoundInCppWithTheReferencesOwnFiles) {
  const fs::path source = scratch_.write("grown.cpp", R"(
#include <cstdio>

#include "model/reference/unit/register_map.h"
#include "model/reference/unit/unit_counters.h"

using namespace ptm::reference;

static_assert(fields::draw_weights::kKq.low == 27 && fields::draw_weights::kKq.width == 5);
static_assert(static_cast<int>(UnitCounter::lines_kept) == 38 && kUnitCounters == 39);
static_assert(unit_counter_names()[38] == "lines_kept");
static_assert(static_cast<int>(TextureFormat::luminance) == 5);
static_assert(map_planes(TextureFormat::luminance, EvalConfig{}) == 2);
static_assert(format_row(TextureFormat::luminance).multiplies == 8);

int main() {
  UnitConfig unit;
  const auto before = capability_words({}, unit);
  unit.sample_fifo = 44;
  const auto words = capability_words({}, unit);
  Draw draw{.format = TextureFormat::luminance};
  draw.map = {.width = 8, .height = 8, .levels = 1};
  std::printf("default %u, set %u, formats %x, weights %x, lines %u %u\n", before[1] >> 26,
              words[1] >> 26, words[3] & 255, stored_bits(10, unit), check_draw(draw, 8, unit),
              check_draw(draw, 7, unit));
  return 0;
}
)");
  const Ended built =
      run(std::string(PTM_CXX) + " -std=c++20 -O0 -I'" + (scratch_ / "include").string() +
          "' -I. " + "'" + source.string() + "' model/reference/unit/register_map.cpp " +
          "model/reference/unit/draw.cpp -o '" + (scratch_ / "grown").string() + "'");
  ASSERT_EQ(built.code, 0) << built.said;
  // Two planes of 2 x 2 tiles are eight lines.
  EXPECT_EQ(run("'" + (scratch_ / "grown").string() + "'").said,
            "default 5, set 44, formats 3f, weights ffffffff, lines 0 4\n");
}

TEST_F(ContractGrowth, IsFoundInTheRtlWhichStillIsAUnit) {
  const fs::path top = scratch_.write("grown.sv", R"(
module grown (
  input  logic [ptm_unit_pkg::DrawW-1:0] draw_i,
  output logic [4:0] kq_o,
  output logic [3:0] planes_o,
  output logic [5:0] number_o
);
  ptm_unit_pkg::draw_t draw;
  assign draw     = draw_i;
  assign kq_o     = draw.kq;
  assign planes_o = ptm_format_pkg::planes(3, ptm_register_pkg::FormatLuminance);
  assign number_o = 6'(ptm_register_pkg::CountLinesKept);
  if (ptm_register_pkg::DrawWeightsKqLow != 27 || ptm_register_pkg::Counters != 39) begin : gen_bad
    kq_is_not_where_the_table_says u_bad ();
  end
endmodule
)");
  // The lists, with the grown contract's files in place of the committed ones.
  std::string list;
  for (const char* name : {"rtl/files.f", "rtl/unit.f"}) {
    std::istringstream lines(whole_text(kRoot / name));
    for (std::string line; std::getline(lines, line);) {
      if (line.starts_with("//")) continue;
      const bool grown = fs::exists(committed(line));
      list += (grown ? committed(line).string() : (kRoot / line).string()) + "\n";
    }
  }
  const fs::path files = scratch_.write("grown.f", list);
  const std::string lint = "verilator --lint-only -Wall -Wno-UNUSEDSIGNAL -Wno-UNUSEDPARAM '-I" +
                           committed("rtl").string() + "' -Irtl -y rtl/effects rtl/lint.vlt -f '" +
                           files.string() + "' ";
  const Ended constants = run(lint + "'" + top.string() + "' --top-module grown");
  EXPECT_EQ(constants.code, 0) << constants.said;
  const Ended unit = run(lint + "--top-module ptm_unit -GSampleFifo=44 -GStages=7 -GExtraPasses=1");
  EXPECT_EQ(unit.code, 0) << unit.said;
  const Ended refused = run(lint + "--top-module ptm_unit -GSampleFifo=61");
  EXPECT_NE(refused.said.find("ptm_illegal_SampleFifo_not_2_to_60"), std::string::npos)
      << refused.said;
  EXPECT_NE(whole_text(committed("rtl/contract/ptm_capability_words.svh")).find("6'(SampleFifo)"),
            std::string::npos);
  EXPECT_NE(whole_text(committed("rtl/contract/ptm_draw_write.svh")).find("reg_wdata_i[31:27]"),
            std::string::npos);
}

TEST_F(ContractGrowth, IsFoundInTheDriversHeaderAndTheRegisterDescription) {
  const fs::path source = scratch_.write("grown.c", R"(
#include "contract/driver/ptm_unit.h"
_Static_assert(PTM_UNIT_DRAW_WEIGHTS_KQ_MASK == 0xf8000000u, "field");
_Static_assert(PTM_UNIT_COUNT_LINES_KEPT == 38 && PTM_UNIT_COUNTERS == 39, "counter");
_Static_assert(PTM_UNIT_FORMAT_LUMINANCE == 5, "format");
_Static_assert(PTM_UNIT_BUILT_FIFOS_SAMPLE_FIFO_SHIFT == 26, "parameter");
int grown;
)");
  const Ended built =
      run(std::string(PTM_CC) + " -std=c11 -Wall -Wextra -Wpedantic -Werror -c -I'" +
          committed("").string() + "' '" + source.string() + "' -o '" +
          (scratch_ / "grown.o").string() + "'");
  EXPECT_EQ(built.code, 0) << built.said;

  int found = 0;
  const std::string text = whole_text(committed("contract/driver/ptm_unit.rdl"));
  for (const RdlRegister& r : RdlReader(text).read()) {
    for (const RdlField& field : r.fields) {
      if (field.name == "kq") found += r.name == "draw.weights" && field.mask() == 0xf8000000U;
      if (field.name == "sample_fifo") found += field.software == "r" && field.low == 26;
    }
  }
  EXPECT_EQ(found, 4 + 1) << "of each draw, and the capability";
  EXPECT_NE(text.find("luminance_code = 5"), std::string::npos);
}

TEST_F(ContractGrowth, IsFoundInJsonTomlAndPages) {
  EXPECT_NE(block("report.schema.json", "counters").find("\"lines_kept\""), std::string::npos);
  EXPECT_NE(block("report.schema.json", "counters").find("\"maxProperties\": 39"),
            std::string::npos);
  EXPECT_NE(block("unit-timing.md", "counters").find("| 38 | `lines_kept` | lines that stayed"),
            std::string::npos);
  EXPECT_NE(
      block("unit.md", "formats").find("| 5 | luminance | 2 (3) | (a0 a1 a2), (a3 a4 a5), grey"),
      std::string::npos);
  EXPECT_NE(block("unit.md", "registers").find("`kq` [31:27] (of the quartic)"), std::string::npos);
  EXPECT_NE(block("unit.md", "capabilities").find("`SampleFifo` [31:26]"), std::string::npos);
  EXPECT_NE(whole_text(scratch_ / "include/contract/unit_config.cpp").find("\"sample_fifo\""),
            std::string::npos)
      << "a key of [hardware] and of the report's configuration";
  EXPECT_NE(block("unit-timing.md", "unit parameters").find("| `sample_fifo` | `SampleFifo` | "),
            std::string::npos);
}

}  // namespace
}  // namespace ptm::tests
