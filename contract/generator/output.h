#pragma once
#include <filesystem>
#include <string>
#include <vector>

/// What the generator writes.
namespace ptm::contract {

struct Output {
  enum class Kind {
    build,      ///< part of the build alone: under the output folder
    committed,  ///< kept in the repository
    block       ///< part of a page that is kept there, between "<!-- contract: NAME -->" and
                ///< "<!-- end -->", each on a line of its own; of a JSON file between lines
                ///< "$comment": "contract: NAME", and "description": "contract: end"
  };
  Kind kind = Kind::build;
  /// Of `build` within the output folder, else within the repository.
  std::string path;
  std::string text;
  std::string block{};  ///< its name
};
using Outputs = std::vector<Output>;

/// Writes everything under a folder: what is for the build at its place; a committed file PATH to
/// committed/PATH; a block to committed/PATH/NAME. Files whose content is right already are not
/// touched, so that nothing is built again for them. Throws std::runtime_error if a file cannot be
/// written.
void write_outputs(const Outputs& outputs, const std::filesystem::path& folder);

/// Brings what the repository keeps up to date. Throws std::runtime_error if a page lacks a block's
/// marks or a file cannot be written.
void refresh_committed(const Outputs& outputs, const std::filesystem::path& repository);

/// What differs from the repository, a line each; none if all is up to date.
[[nodiscard]] std::vector<std::string> stale_committed(const Outputs& outputs,
                                                       const std::filesystem::path& repository);

}  // namespace ptm::contract
