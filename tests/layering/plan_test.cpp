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

void expect_named_tests_exist(const fs::path& page, const std::regex& name) {
  const std::set<std::string> there = tests_in_the_tree();
  const std::string text = text_of(page);
  int named = 0;
  for (std::sregex_iterator match(text.begin(), text.end(), name), end; match != end; ++match) {
    ++named;
    EXPECT_TRUE(there.contains((*match)[1])) << page << " names " << (*match)[1];
  }
  EXPECT_GT(named, 0) << page;
}

TEST(VerificationPlan, NamesOnlyTestsThatExist) {
  const fs::path docs = fs::path(PTM_SOURCE_DIR) / "docs";
  // In the plan's table the test is what stands in back quotes in the second column.
  expect_named_tests_exist(docs / "verification" / "plan.md",
                           std::regex(R"(\n\|[^|]+\| `(\w+(?:\.\w+)?)` \|)"));
  expect_named_tests_exist(docs / "spec" / "datapath.md", std::regex(R"(`([A-Z]\w+\.[A-Z]\w+)`)"));
}

}  // namespace
}  // namespace ptm
