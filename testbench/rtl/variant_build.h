#pragma once
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// What units outside the build are built from and with: this build's own tools, and a copy of its
/// sources within the program, so that it needs no folder to stay where it was. Written by
/// cmake/PtmVariantBuild.cmake.
namespace ptm::testbench {

struct VariantBuild {
  std::string source_root;           ///< where the sources were when this was built
  std::vector<std::string> options;  ///< of cmake
  std::string compiler, generator;
  std::string tools;  ///< names and versions
  /// The chain of this build's effect stages, then the stages, as embedded_sources() names them.
  std::vector<std::string> effect_files;
};

[[nodiscard]] const VariantBuild& variant_build();

struct EmbeddedSource {
  std::string_view name;  ///< from the project's root; generated/... and extra/... from theirs
  std::string_view text;
};

/// All that a unit is made of: the RTL, its test bench, the headers, and the files for cmake.
[[nodiscard]] std::span<const EmbeddedSource> embedded_sources();

/// Writes them into a folder. Throws golden::InputError where it cannot.
void unpack_sources(const std::filesystem::path& folder);

}  // namespace ptm::testbench
