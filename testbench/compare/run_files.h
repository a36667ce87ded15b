#pragma once
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace ptm::testbench {

/// What `ptmsim run` left in a folder, read back.
struct RunFiles {
  std::filesystem::path report;  ///< report.json
  std::filesystem::path folder;  ///< in which it and its pictures lie
  bool named_alone = false;      ///< the report was named, not its folder
  nlohmann::ordered_json json;

  /// File names of a model's pictures, one a light.
  [[nodiscard]] std::vector<std::string> pictures(const std::string& model) const;
  [[nodiscard]] std::vector<std::string> models() const;
  /// The report stands for its pictures: it was named, and none of them lies beside it.
  [[nodiscard]] bool has_no_pictures() const;
};

/// Reads a folder's report.json, or a report by its own name. Throws golden::InputError where there
/// is none, where it is no JSON (with line and column), and where what names scene, models and
/// pictures is missing or of a wrong type. Its version may be any: see require_versions().
[[nodiscard]] RunFiles read_run(const std::filesystem::path& path);

/// Throws golden::InputError that names both versions unless both are kReportVersion.
void require_versions(const RunFiles& a, const RunFiles& b);

}  // namespace ptm::testbench
