#pragma once
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ptm::testbench {

/// What two runs may differ in, the weightiest first; docs/spec/compare.md says what belongs to
/// each.
enum class DifferenceKind : std::uint8_t {
  structure,      ///< there in one run only
  configuration,  ///< scene and parameters
  agreement,      ///< whether the models of one run agree
  pixels,
  cycles,
  counters,
  figures,
  lists,  ///< long ones that follow from pictures and cycles
  notes
};
inline constexpr std::size_t kDifferenceKinds = 9;
[[nodiscard]] std::string_view kind_name(DifferenceKind kind);

/// How the pictures of one name differ.
struct FilePixels {
  std::string picture;
  std::uint64_t samples = 0, differing = 0;
  double max = 0;    ///< levels
  int x = 0, y = 0;  ///< of a sample that differs most
};

/// How the pictures of a model differ, all lights.
struct ModelPixels {
  std::size_t pictures = 0;  ///< that were compared
  std::uint64_t samples = 0, differing = 0;
  double max = 0;
  std::vector<FilePixels> files;  ///< those that differ, the largest error first
};

struct RunDifference {
  DifferenceKind kind = DifferenceKind::figures;
  std::string path;                   ///< in the report: "models.rtl.cycles"
  std::vector<std::string> also;      ///< paths that differ in the same way
  nlohmann::ordered_json a, b;        ///< values; null where `only` says that there is none
  std::string only;                   ///< "A" or "B" if the other has nothing there
  std::optional<ModelPixels> pixels;  ///< pictures of one size that were both read
  std::string what;                   ///< of pictures: a sentence
  bool allowed = false;

  /// b less a where both are numbers.
  [[nodiscard]] std::optional<double> amount() const;
  /// The same as a part of a; infinite where a is 0.
  [[nodiscard]] std::optional<double> relative() const;
};

}  // namespace ptm::testbench
