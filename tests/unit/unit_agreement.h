#pragma once
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "testbench/run/unit_section.h"

/// Scenes under scenes/ through reference, RTL and the timing exact.
namespace ptm::testbench {

/// Files of scenes/ that go through the whole unit, by name.
inline std::vector<std::string> unit_scene_names() {
  std::vector<std::string> names;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::filesystem::path(PTM_SOURCE_DIR) / "scenes")) {
    if (entry.path().extension() == ".toml" && golden::is_unit_scene(entry.path())) {
      names.push_back(entry.path().stem());
    }
  }
  std::sort(names.begin(), names.end());
  return names;
}

inline UnitJob load_unit_scene(const std::string& name) {
  return make_unit_job(
      golden::read_unit_scene(std::filesystem::path(PTM_SOURCE_DIR) / "scenes" / (name + ".toml")));
}

struct TimedPair {
  UnitTimed exact, rtl;
};

/// Both models at once, each in a process of its own.
inline TimedPair run_pair(const UnitJob& job) {
  ChildProcess exact = start_unit_model(job, "pipeline");
  ChildProcess rtl = start_unit_model(job, "rtl");
  return {take_unit_model(exact, "pipeline"), take_unit_model(rtl, "rtl")};
}

/// Tolerance zero: pixels against the reference, cycles and counters against each other.
inline void expect_agreement(const UnitJob& job, const TimedPair& pair) {
  const auto pixels = unit_pixels(job);
  ASSERT_EQ(pair.rtl.frames.size(), pixels.size());
  ASSERT_EQ(pair.exact.frames.size(), pixels.size());
  for (std::size_t n = 0; n < pixels.size(); ++n) {
    SCOPED_TRACE("frame " + std::to_string(n));
    ASSERT_FALSE(pair.rtl.frames[n].fault) << pair.rtl.frames[n].fault->what;
    ASSERT_FALSE(pair.exact.frames[n].fault) << pair.exact.frames[n].fault->what;
    EXPECT_TRUE(pair.rtl.frames[n].pixels == pixels[n]) << "pixels of RTL and reference differ";
    EXPECT_EQ(pair.rtl.frames[n].taken.size(), pixels[n].size());
  }
  EXPECT_EQ(count_late_pixels(pair.exact, pair.rtl), 0U);
  EXPECT_EQ(differing_counters(pair.exact, pair.rtl), std::vector<std::string>{});
}

}  // namespace ptm::testbench
