// Pages, comments and links name what exists: docs pages and their sections, rules, files, twins,
// tests. Each kind of dead reference is planted in a small tree, beside a live one.
#include "references.h"

#include <gtest/gtest.h>

namespace ptm::layering {
namespace {

TEST(References, OfTheRepositoryLeadSomewhere) {
  const SourceTree tree = read_tree(PTM_SOURCE_DIR);
  ASSERT_GT(tree.files.size(), 500U);
  for (const DeadReference& dead : dead_references(tree)) {
    // This file's are planted.
    EXPECT_EQ(dead.file, "tests/layering/references_test.cpp") << dead;
  }
}

const char* const kPage =
    "# The unit\n"
    "\n"
    "## Steps and times\n"
    "\n"
    "- **U1** The first step.\n"
    "- **U2** The second, by `UnitConfig`.\n"
    "\n"
    "| step | what |\n"
    "|---|---|\n"
    "| D1 | subtract |\n"
    "\n"
    "## 3. Registers: the port\n"
    "\n"
    "**Legal.** What a draw may be.\n";

/// A tree in which every reference is alive.
SourceTree small_tree() {
  SourceTree tree;
  tree.add("docs/spec/unit.md", kPage);
  tree.add("docs/README.md", "See [the unit](spec/unit.md#steps-and-times) and `Unit.Draws`.\n");
  tree.add("rtl/ptm_step.sv", "// Twin: step() in model/step.h.\nmodule ptm_step;\nendmodule\n");
  tree.add("model/step.h",
           "/// U1. Twin: rtl/ptm_step.sv.\nint step(int x);\nstruct UnitConfig {};\n");
  tree.add("tests/unit_test.cpp", "TEST(Unit, Draws) {}\nTEST_P(Unit, DrawsTwice) {}\n");
  return tree;
}

/// What is found in a file of the small tree; each entry is "line: what".
std::vector<std::string> found_in(const std::string& path, const std::string& text) {
  SourceTree tree = small_tree();
  tree.add(path, text);
  std::vector<std::string> found;
  for (const DeadReference& dead : dead_references(tree)) {
    EXPECT_EQ(dead.file, path) << dead;
    found.push_back(std::to_string(dead.line) + ": " + dead.what);
  }
  return found;
}

using Found = std::vector<std::string>;

TEST(References, OfALiveTreeAreNotReported) {
  EXPECT_EQ(dead_references(small_tree()).size(), 0U);
  EXPECT_EQ(found_in("model/a.h",
                     "/// docs/spec/unit.md, Steps and times; rtl/ptm_<id>.sv,\n"
                     "/// rtl/ptm_NAME.sv, rtl/*.sv; unit.md, \"Legal\" and U1 to U2,\n"
                     "/// docs/spec/unit.md, section 3; `unit.md`, Registers.\n"
                     "/// Q8.20 and D1..D1 and U2's, \"Z9\" and x = Z9(1), -O3.\n"
                     "int a;  // rtl/ptm_step.sv, Unit.DrawsTwice\n"),
            Found{});
}

TEST(References, ToAMissingFileIsFound) {
  EXPECT_EQ(
      found_in("model/a.h", "int a;\n/// As rtl/ptm_absent.sv\n/// and model/absent/b.h.\n"),
      (Found{"2: no file or folder rtl/ptm_absent.sv", "3: no file or folder model/absent/b.h"}));
  EXPECT_EQ(found_in("model/a.h", "int a;  ///< ptm_absent.sv\n"),
            Found{"1: no file ptm_absent.sv"});
  EXPECT_EQ(found_in("rtl/x.sv", "// rtl/effects/ptm_<id>.sv\n"),
            Found{"1: no file or folder rtl/effects/ptm_<id>.sv"});
  EXPECT_EQ(found_in("scripts/go", "# reads model/absent.h\n"),
            Found{"1: no file or folder model/absent.h"});
}

TEST(References, ToAMissingPageIsFound) {
  EXPECT_EQ(found_in("model/a.h", "/// As docs/spec/absent.md says.\n"),
            Found{"1: no file or folder docs/spec/absent.md"});
  EXPECT_EQ(found_in("model/a.cpp",
                     "auto help = \"Scene (docs/spec/"
                     "absent.md)\";\n"),
            Found{"1: no page docs/spec/absent.md"});
  EXPECT_EQ(found_in("model/a.h", "/// See absent.md.\n"), Found{"1: no file absent.md"});
}

TEST(References, ToAMissingSectionIsFound) {
  EXPECT_EQ(found_in("model/a.h", "/// docs/spec/unit.md, \"Old\n/// name\".\n"),
            Found{"1: docs/spec/unit.md has no section \"Old name\""});
  EXPECT_EQ(found_in("rtl/x.sv", "// y = a      docs/spec/unit.md, Ports and Legal\n// More.\n"),
            Found{"1: docs/spec/unit.md has no section \"Ports\""});
  EXPECT_EQ(found_in("rtl/x.sv", "// docs/spec/unit.md, Legal and Ports.\n"),
            Found{"1: docs/spec/unit.md has no section \"Ports\""});
  EXPECT_EQ(found_in("model/a.h", "/// docs/spec/unit.md, section 4\n"),
            Found{"1: docs/spec/unit.md has no section 4"});
}

TEST(References, ToAMissingAnchorOrLinkIsFound) {
  EXPECT_EQ(found_in("docs/a.md", "[here](spec/unit.md#step)\n"),
            Found{"1: spec/unit.md has no anchor #step"});
  EXPECT_EQ(found_in("docs/a.md", "# A\n\n[here](#b) and [there](#a)\n"),
            Found{"3: the page has no anchor #b"});
  EXPECT_EQ(found_in("docs/a.md", "[here](../rtl/absent.sv)\n"),
            (Found{"1: the link leads to no file: ../rtl/absent.sv"}));
  EXPECT_EQ(found_in("model/a.h", "/// docs/spec/unit.md#step\n"),
            Found{"1: docs/spec/unit.md has no anchor #step"});
}

TEST(References, ToAMissingRuleIsFound) {
  EXPECT_EQ(found_in("model/a.h", "/// docs/spec/unit.md, T6\n"),
            (Found{"1: docs/spec/unit.md has no rule T6", "1: no page defines rule T6"}));
  EXPECT_EQ(found_in("rtl/x.sv", "logic a;  // kept (U3), else D1\n"),
            Found{"1: no page defines rule U3"});
  EXPECT_EQ(found_in("docs/a.md", "By `U1` to U7.\n"), Found{"1: no page defines rule U7"});
}

TEST(References, ToAMissingTwinIsFound) {
  EXPECT_EQ(found_in("rtl/x.sv", "// Twin: leap() in model/step.h. Combinational.\n"),
            Found{"1: the twin leap() is not in model/step.h"});
  EXPECT_EQ(
      found_in("rtl/x.sv", "// Twins: step() in\n// model/leap.h.\n"),
      (Found{"2: no file or folder model/leap.h", "1: the twin step() is not in model/leap.h"}));
  EXPECT_EQ(found_in("model/a.h", "/// Twin      the register block\n/// Error     none\n"),
            Found{"1: the twin names no file or folder:      the register block"});
}

TEST(References, ToAMissingTestIsFound) {
  EXPECT_EQ(found_in("docs/verification/a.md", "`Unit.Draws`, `Unit.DrawsThrice`\n"),
            Found{"1: no test Unit.DrawsThrice"});
}

TEST(References, ToAMissingNameIsFound) {
  EXPECT_EQ(found_in("docs/a.md", "By `UnitConfig` and `UnitConfiguration`.\n"),
            Found{"1: no source has the name UnitConfiguration"});
}

}  // namespace
}  // namespace ptm::layering
