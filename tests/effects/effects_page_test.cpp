// docs/spec/effects.md shows the rows of contract/effects.def.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>

#include "testbench/plan/effect_rows.h"

namespace ptm::testbench {
namespace {

std::string page() {
  std::ifstream in(PTM_SOURCE_DIR "/docs/spec/effects.md");
  return {std::istreambuf_iterator<char>(in), {}};
}

/// The page's row of an effect: "| `fresnel` | no | 3 | 3 | `modulate` |".
std::string line_of(const EffectRow& row) {
  std::string stages;
  for (const StageRow& stage : stage_rows()) {
    if ((row.stages >> stage.number & 1U) == 0) continue;
    stages += (stages.empty() ? "`" : ", `") + std::string(stage.id) + "`";
  }
  return "\n| `" + std::string(row.name) + "` | " + (row.half ? "yes" : "no") + " | " +
         std::to_string(row.sets) + " | " + std::to_string(row.passes) + " | " +
         (stages.empty() ? "none" : stages) + " |\n";
}

TEST(EffectsPage, HasTheRowOfEveryEffectOfTheBuild) {
  ASSERT_FALSE(effect_rows().empty());
  const std::string text = page();
  for (const EffectRow& row : effect_rows()) {
    EXPECT_NE(text.find(line_of(row)), std::string::npos) << line_of(row);
  }
}

}  // namespace
}  // namespace ptm::testbench
