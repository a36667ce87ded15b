#pragma once
#include <string>
#include <vector>

/// What units outside the build are built from and with: this build's own places and tools, written
/// by cmake/PtmVariantBuild.cmake.
namespace ptm::testbench {

struct VariantBuild {
  std::string source_root;
  std::vector<std::string> options;  ///< of cmake
  std::string compiler, generator;
  std::string tools;                 ///< names and versions
  /// The chain of this build's effect stages, then the stages; absolute.
  std::vector<std::string> effect_files;
};

[[nodiscard]] const VariantBuild& variant_build();

}  // namespace ptm::testbench
