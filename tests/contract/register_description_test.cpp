// The register description in SystemRDL: that it is SystemRDL, and that it says of each address
// what the reference's registers hold.
#include <gtest/gtest.h>

#include <fstream>

#include "model/reference/unit/register_map.h"
#include "model/reference/unit/unit_counters.h"
#include "tests/contract/rdl_reader.h"

namespace ptm::reference {
namespace {

std::string description() {
  std::ifstream file(std::string(PTM_SOURCE_DIR) + "/contract/driver/ptm_unit.rdl");
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(RegisterDescription, SaysOfEveryAddressWhatIsKeptThere) {
  const UnitConfig all{.extra_sets = 4, .extra_passes = 4, .half_vector = true, .stages = 255};
  std::vector<std::uint32_t> kept(0x10000, 0);
  for (const tests::RdlRegister& r : tests::RdlReader(description()).read()) {
    ASSERT_LT(r.address / 4, kept.size()) << r.name;
    for (const tests::RdlField& field : r.fields) {
      if (field.software == "rw" && field.on_write.empty()) kept[r.address / 4] |= field.mask();
    }
  }
  for (unsigned address = 0; address < kept.size(); ++address) {
    ASSERT_EQ(kept[address],
              stored_bits(static_cast<std::uint16_t>(address), all, {.coef_bits = 12}))
        << "word " << address;
  }
}

TEST(RegisterDescription, GivesTheUnitsOwnRegistersAndWhatTheyRead) {
  std::map<std::uint64_t, tests::RdlRegister> at;
  for (const tests::RdlRegister& r : tests::RdlReader(description()).read()) at[r.address / 4] = r;
  const auto reset = [&at](unsigned address) {
    std::uint32_t word = 0;
    for (const tests::RdlField& field : at.at(address).fields) word |= field.reset << field.low;
    return word;
  };
  EXPECT_EQ(reset(registers::kMagic), kRegisterMagic);
  EXPECT_EQ(reset(registers::kVersion), kRegisterMapVersion);
  const auto words = capability_words(kBase, {});
  for (const unsigned n : {3U, 4U, 5U}) {  // those that are the same in every unit
    EXPECT_EQ(reset(registers::kCapabilities + n), words[n]) << n;
  }
  for (const tests::RdlField& field : at.at(registers::kEvents).fields) {
    EXPECT_EQ(field.on_write, "woclr") << field.name;
  }
  EXPECT_EQ(at.at(registers::kEvents).fields.size(), 5U);
  for (const tests::RdlField& field : at.at(registers::kState).fields) {
    EXPECT_EQ(field.software, "r") << field.name;
  }
  for (unsigned n = 0; n < 2 * kUnitCounters; ++n) {
    EXPECT_TRUE(at.contains(registers::kCounters + n)) << n;
  }
  EXPECT_TRUE(at.contains(registers::kRgbPalette + 8 * 4095 + 5));
  EXPECT_FALSE(at.contains(registers::kRgbPalette + 8 * 4095 + 6));
  EXPECT_EQ(at.at(registers::kTables + 256 * 3 + 255).fields[0].software, "w");
}

TEST(RegisterDescription, IsReadByAReaderThatRefusesMistakes) {
  struct Case {
    const char *from, *to, *said;
  };
  for (const Case& c : {Case{"mip[4:3]", "mip[4:2]", "overlaps"},
                        {"onwrite = woclr", "onread = woclr", "is no property of a field"},
                        {"encode = wrap_e", "encode = wraps_e", "no enumeration"},
                        {"+= 0x100;", "+= 0x80;", "overlap"},
                        {"regfile unit_block", "regfile units", "property"},
                        {"draining[2:2] = 0x0", "draining[2:2] = 0x2", "reset of draining"}}) {
    std::string text = description();
    const std::size_t at = text.find(c.from);
    ASSERT_NE(at, std::string::npos) << c.from;
    text.replace(at, std::string(c.from).size(), c.to);
    try {
      (void)tests::RdlReader(text).read();
      ADD_FAILURE() << c.to;
    } catch (const std::runtime_error& error) {
      EXPECT_NE(std::string(error.what()).find(c.said), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace ptm::reference
