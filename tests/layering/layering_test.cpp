// Who may include whom. Headers are named from the project's root, so an include says it all.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iostream>
#include <regex>
#include <string>
#include <vector>

namespace ptm {
namespace {

namespace fs = std::filesystem;

const std::regex kStandard("[a-z_0-9]+|sys/[a-z]+\\.h|unistd\\.h|fcntl\\.h");
const std::regex kOiio("OpenImageIO/.*");
const std::regex kEigen("Eigen/.*");
const std::regex kHighway("hwy/.*");
const std::regex kEffects("effects/[a-z_]+\\.(h|def|inc)");  ///< written by cmake/PtmEffects.cmake
const std::regex kContract("contract/[a-z_]+\\.(h|inc)");    ///< written by contract/generator
const std::regex kPosix("dlfcn\\.h|spawn\\.h");              ///< libraries and programs of its own
const std::regex kSystemC("systemc|tlm|tlm_utils/.*");

struct Layer {
  std::string folder;
  std::vector<std::string> own;       ///< folders of the project it may include from
  std::vector<std::regex> libraries;  ///< beside the standard library
};

const std::vector<Layer>& layers() {
  static const std::vector<Layer> all{
      {"contract/generator", {"contract/generator"}, {std::regex("toml\\+\\+/.*")}},
      {"golden",
       {"golden", "effects"},  // effects/ is what the build writes from the table of effects
       {kOiio, kEigen, std::regex("charls/.*"), std::regex("turbojpeg\\.h"),
        std::regex("toml\\+\\+/.*"), std::regex("tbb/.*|oneapi/tbb.*")}},
      {"model/reference", {"model/reference"}, {kEigen, kHighway, kEffects, kContract}},
      {"model/quantize", {"model/quantize", "model/reference"}, {kEigen, kHighway}},
      {"model/pipeline", {"model/pipeline", "model/reference"}, {kSystemC, kEffects, kContract}},
      {"testbench",
       {"golden", "model", "testbench"},
       {kOiio, kEigen, kHighway, kSystemC, kEffects, kContract, kPosix, std::regex("CLI/.*"),
        std::regex("nlohmann/.*"), std::regex("sqlite3\\.h"), std::regex("verilated.*|V.*\\.h")}},
  };
  return all;
}

std::vector<fs::path> sources(const fs::path& folder) {
  std::vector<fs::path> found;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string ending = entry.path().extension().string();
    if (ending == ".h" || ending == ".cpp" || ending == ".in") found.push_back(entry.path());
  }
  return found;
}

bool allowed(const Layer& layer, const std::string& name, bool quoted) {
  for (const std::string& folder : layer.own) {
    if (quoted && name.starts_with(folder + "/")) return true;
  }
  for (const std::regex& library : layer.libraries) {
    if (std::regex_match(name, library)) return true;
  }
  return !quoted && std::regex_match(name, kStandard);
}

class Layering : public testing::TestWithParam<Layer> {};

TEST_P(Layering, IncludesOnlyWhatTheArchitectureAllows) {
  const Layer& layer = GetParam();
  const std::regex include("^\\s*#\\s*include\\s*([<\"])([^>\"]+)[>\"].*");
  const auto files = sources(fs::path(PTM_SOURCE_DIR) / layer.folder);
  ASSERT_FALSE(files.empty());
  for (const fs::path& file : files) {
    std::ifstream text(file);
    std::string line;
    for (int number = 1; std::getline(text, line); ++number) {
      std::smatch match;
      if (!std::regex_match(line, match, include)) continue;
      EXPECT_TRUE(allowed(layer, match[2], match[1] == "\""))
          << file.string() << ":" << number << ": " << layer.folder << " must not include "
          << match[2];
    }
  }
}

std::string name_of(const testing::TestParamInfo<Layer>& layer) {
  return std::regex_replace(layer.param.folder, std::regex("/"), "_");
}

INSTANTIATE_TEST_SUITE_P(Folders, Layering, testing::ValuesIn(layers()), name_of);

TEST(Layering, OfTheRtlIncludesNothingButItsOwnFiles) {
  const fs::path rtl = fs::path(PTM_SOURCE_DIR) / "rtl";
  const std::regex include("^\\s*`include\\s*\"([^\"]+)\".*");
  int files = 0;
  for (const auto& entry : fs::recursive_directory_iterator(rtl)) {
    const std::string ending = entry.path().extension().string();
    if (ending != ".sv" && ending != ".svh") continue;
    ++files;
    std::ifstream text(entry.path());
    std::string line;
    while (std::getline(text, line)) {
      std::smatch match;
      if (!std::regex_match(line, match, include)) continue;
      EXPECT_TRUE(fs::exists(rtl / match[1].str())) << entry.path() << " includes " << match[1];
    }
  }
  EXPECT_GT(files, 10);
}

}  // namespace
}  // namespace ptm
