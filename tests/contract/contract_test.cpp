// The generator of what the contract's tables say, as a program.
#include <sys/wait.h>

#include <cstdlib>

#include "tests/scratch_folder.h"

namespace ptm::tests {
namespace {

namespace fs = std::filesystem;

const fs::path kTables = fs::path(PTM_SOURCE_DIR) / "contract";

std::string text_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

struct Ended {
  int code = -1;
  std::string said;
};

/// Runs the generator.
Ended generate(const ScratchFolder& scratch, const fs::path& tables, const std::string& arguments) {
  const fs::path log = scratch / "log";
  const std::string command = std::string(PTM_CONTRACT) + " '" + tables.string() + "' " +
                              arguments + " >'" + log.string() + "' 2>&1";
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, text_of(log)};
}

/// The tables, with one text in one of them replaced.
fs::path changed_tables(const ScratchFolder& scratch, const std::string& table,
                        const std::string& from, const std::string& to) {
  const fs::path folder = scratch / "tables";
  fs::create_directories(folder);
  for (const auto& entry : fs::directory_iterator(kTables)) {
    if (entry.path().extension() == ".toml") {
      fs::copy_file(entry.path(), folder / entry.path().filename(),
                    fs::copy_options::overwrite_existing);
    }
  }
  std::string text = text_of(folder / table);
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  std::ofstream(folder / table, std::ios::binary) << text.replace(at, from.size(), to);
  return folder;
}

TEST(Contract, CommittedFilesAreWhatTheTablesSay) {
  const ScratchFolder scratch;
  const Ended check = generate(scratch, kTables, std::string("--check ") + PTM_SOURCE_DIR);
  EXPECT_EQ(check.code, 0) << check.said;
  EXPECT_EQ(check.said, "");
}

TEST(Contract, TellsOfEveryFileThatDiffersWhichCommandMendsIt) {
  const ScratchFolder scratch;
  const fs::path tables =
      changed_tables(scratch, "parameters.toml", "presets = { paper8 = 8 }\nunit", "unit");
  const Ended check = generate(scratch, tables, std::string("--check ") + PTM_SOURCE_DIR);
  EXPECT_EQ(check.code, 1);
  EXPECT_NE(check.said.find("rtl/presets.txt is not what the tables say\n"), std::string::npos)
      << check.said;
  EXPECT_NE(check.said.find("run scripts/contract\n"), std::string::npos) << check.said;
}

TEST(Contract, WhatIsWrittenIsWhatIsChecked) {
  const ScratchFolder scratch;
  const Ended written = generate(scratch, kTables, "'" + (scratch / "out").string() + "'");
  ASSERT_EQ(written.code, 0) << written.said;
  EXPECT_EQ(text_of(scratch / "out/committed/rtl/presets.txt"),
            text_of(fs::path(PTM_SOURCE_DIR) / "rtl/presets.txt"));
  // A second time nothing is touched, so that nothing is built again.
  const auto before = fs::last_write_time(scratch / "out/committed/rtl/presets.txt");
  ASSERT_EQ(generate(scratch, kTables, "'" + (scratch / "out").string() + "'").code, 0);
  EXPECT_EQ(fs::last_write_time(scratch / "out/committed/rtl/presets.txt"), before);
}

TEST(Contract, RefusesATableWithTheFileAndTheLine) {
  struct Case {
    const char *table, *from, *to, *said;
  };
  for (const Case& c : {
           Case{"parameters.toml", "range = [4, 12]", "rang = [4, 12]", "unknown key 'rang'"},
           {"parameters.toml", "range = [4, 12]", "range = [4]", "range: expected the least"},
           {"parameters.toml", "\"2 * light_frac\"", "\"2 * light_fraction\"",
            "range: found 'light_fraction', which is no parameter of these"},
           {"parameters.toml", "name = \"delta_bits\"", "name = \"coef_bits\"",
            "name: found 'coef_bits' twice"},
           {"parameters.toml", "default = \"nearest\"", "default = \"up\"",
            "default: found 'up', which is no choice"},
           {"parameters.toml", "default = 9", "default = 9 9", ""},
           {"variants.toml", "kind = \"evaluator\"", "kind = \"evaluators\"",
            "kind: found 'evaluators', expected evaluator, unit, back or netlist"},
       }) {
    const ScratchFolder scratch;
    const fs::path tables = changed_tables(scratch, c.table, c.from, c.to);
    const std::string text = text_of(kTables / c.table);
    const auto at = static_cast<std::ptrdiff_t>(text.find(c.from));
    const auto line = 1 + std::count(text.begin(), text.begin() + at, '\n');
    const Ended ended = generate(scratch, tables, "'" + (scratch / "out").string() + "'");
    EXPECT_EQ(ended.code, 3) << c.to;
    EXPECT_EQ(ended.said.rfind(std::string("ptm_contract: ") + c.table + ":" +
                                   std::to_string(line) + ": " + c.said,
                               0),
              0U)
        << ended.said << c.to << " in line " << line;
    EXPECT_FALSE(fs::exists(scratch / "out"));
  }
}

}  // namespace
}  // namespace ptm::tests
