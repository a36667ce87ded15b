#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "testbench/compare/run_difference.h"

namespace ptm::testbench {

/// How far numbers, or a model's pictures, may differ. What is not given sets no limit of its own:
/// without `absolute` and `relative` numbers may not differ, without `share` and `levels` pictures.
struct Limits {
  std::optional<double> absolute, relative;  ///< |b - a| <= absolute + relative |a|
  bool decrease = false;                     ///< b may be below a by anything
  std::optional<double> share, levels;       ///< of differing samples; the largest error
};

/// What may differ between two runs: docs/spec/compare.md, "The tolerance file". Empty: nothing.
struct Tolerance {
  struct Rule {
    std::string path;  ///< '*' stands for any characters
    Limits limits;
  };

  std::string file;
  std::vector<std::string> ignore;  ///< paths, as a rule's
  std::vector<Rule> rules;          ///< the first that fits a path holds, before its kind's limits
  std::map<DifferenceKind, Limits> kinds;
  bool lists = false;

  [[nodiscard]] bool allows(const RunDifference& difference) const;
};

/// Throws golden::InputError with the line for what is no TOML, keys that are not known and values
/// that mean nothing.
[[nodiscard]] Tolerance read_tolerance(const std::filesystem::path& path);

/// Whether a text is as a pattern says, in which '*' stands for any characters or none.
[[nodiscard]] bool fits(std::string_view pattern, std::string_view text);

}  // namespace ptm::testbench
