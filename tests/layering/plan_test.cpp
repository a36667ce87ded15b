// The verification plan names tests that exist.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>

namespace ptm {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& path) {
  std::ifstream in(path);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// "Suite" and "Suite.Test" of every TEST in tests/.
std::set<std::string> tests_in_the_tree() {
  std::set<std::string> names;
  const std::regex test(R"(TEST(?:_F|_P)?\(\s*(\w+),\s*(\w+)\s*\))");
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(PTM_SOURCE_DIR) / "tests")) {
    if (entry.path().extension() != ".cpp") continue;
    const std::string text = text_of(entry.path());
    for (std::sregex_iterator match(text.begin(), text.end(), test), end; match != end; ++match) {
      names.insert((*match)[1]);
      names.insert((*match)[1].str() + "." + (*match)[2].str());
    }
  }
  return names;
}

/// The second column of every row of the page's tables.
std::string second_columns(const std::string& page) {
  std::string columns;
  const std::regex row(R"(\n\|[^|\n]+\|([^|\n]+)\|)");
  for (std::sregex_iterator match(page.begin(), page.end(), row), end; match != end; ++match) {
    columns.append((*match)[1]).append("\n");
  }
  return columns;
}

void expect_named_tests_exist(const fs::path& page, const std::string& text,
                              const std::regex& name) {
  const std::set<std::string> there = tests_in_the_tree();
  int named = 0;
  for (std::sregex_iterator match(text.begin(), text.end(), name), end; match != end; ++match) {
    ++named;
    EXPECT_TRUE(there.contains((*match)[1])) << page << " names " << (*match)[1];
  }
  EXPECT_GT(named, 0) << page;
}

TEST(VerificationPlan, NamesOnlyTestsThatExist) {
  const fs::path docs = fs::path(PTM_SOURCE_DIR) / "docs";
  // In the plan's table tests are what stands in back quotes in the second column.
  const fs::path plan = docs / "verification" / "plan.md";
  expect_named_tests_exist(plan, second_columns(text_of(plan)), std::regex(R"(`(\w+(?:\.\w+)?)`)"));
  const fs::path datapath = docs / "spec" / "datapath.md";
  expect_named_tests_exist(datapath, text_of(datapath), std::regex(R"(`([A-Z]\w+\.[A-Z]\w+)`)"));
}

}  // namespace
}  // namespace ptm
