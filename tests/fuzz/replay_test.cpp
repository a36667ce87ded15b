#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include "tests/fuzz/fuzz_target.h"

// Each fuzz target, built by the usual compiler and given what it is known to have stumbled over,
// its seeds, and simple mutations of them. A crash ends the test program; the asan preset makes
// that strict.
namespace ptm::tests {
namespace {

namespace fs = std::filesystem;

void give(const std::string& bytes) {
  // A copy of exactly that size, so that reading past the end is seen.
  const std::vector<std::uint8_t> copy(bytes.begin(), bytes.end());
  EXPECT_EQ(LLVMFuzzerTestOneInput(copy.data(), copy.size()), 0);
}

bool reads(const std::string& bytes) {
  const std::vector<std::uint8_t> copy(bytes.begin(), bytes.end());
  return fuzz_reads(copy.data(), copy.size());
}

TEST(FuzzReplay, SeedsAreReadUnlessTheyAreToBeRefused) {
  const std::vector<FuzzSeed> seeds = fuzz_seeds();
  ASSERT_GE(seeds.size(), 4U);
  for (const FuzzSeed& seed : seeds) {
    EXPECT_EQ(reads(seed.bytes), !seed.name.starts_with("refused")) << seed.name;
    give(seed.bytes);
  }
}

TEST(FuzzReplay, WhatOnceFailedIsReadOrRefused) {
  const fs::path folder = fs::path(PTM_SOURCE_DIR) / "tests/fuzz/regressions" / PTM_FUZZ_TARGET;
  if (!fs::exists(folder)) GTEST_SKIP() << "nothing has failed this target";
  for (const auto& entry : fs::directory_iterator(folder)) {
    SCOPED_TRACE(entry.path().string());
    std::ifstream in(entry.path(), std::ios::binary);
    give({std::istreambuf_iterator<char>(in), {}});
  }
}

TEST(FuzzReplay, TruncatedAndSpoiltSeedsAreReadOrRefused) {
  std::mt19937 random(2001);
  const auto below = [&random](std::size_t end) {
    return static_cast<std::size_t>(random()) % end;
  };
  const std::vector<FuzzSeed> seeds = fuzz_seeds();
  give("");
  for (const FuzzSeed& seed : seeds) {
    for (int round = 0; round < 40; ++round) {
      std::string bytes = seed.bytes;
      switch (round % 4) {
        case 0:
          bytes.resize(below(bytes.size()));
          break;
        case 1:
          for (std::size_t hits = 1 + below(4); hits > 0; --hits) {
            bytes[below(bytes.size())] = static_cast<char>(random() & 255U);
          }
          break;
        case 2: {  // a piece twice
          const std::size_t first = below(bytes.size()), count = below(bytes.size() - first) + 1;
          bytes.insert(first, bytes.substr(first, count));
          break;
        }
        default: {  // a piece of another seed in place of one's own
          const std::string& other = seeds[below(seeds.size())].bytes;
          const std::size_t first = below(bytes.size()), from = below(other.size());
          bytes.replace(first, below(16), other, from, below(64));
        }
      }
      give(bytes);
    }
  }
}

}  // namespace
}  // namespace ptm::tests
