#pragma once
#include <map>
#include <set>
#include <string>

#include "source_tree.h"

/// What can be cited of a page of the documentation.
namespace ptm::layering {

struct DocPage {
  std::set<std::string> sections;  ///< headings and terms in bold, without marks and numbers
  std::set<int> numbers;           ///< of headings that have one
  std::set<std::string> anchors;   ///< of headings, as web pages make them
  std::set<std::string> rules;  ///< "D1", "F1a": defined by a table's first cell, a bold label or
                                ///< the beginning of a line

  /// Whether the words begin a section's name, or it begins them ("Tags" is "Tags: T, the miss
  /// ring, requests"; "Time and more" is "Time").
  [[nodiscard]] bool has_section(const std::string& words) const;
};

[[nodiscard]] DocPage read_page(const std::string& text);

/// A letter, one or two digits and perhaps a small letter at `at`, standing alone; else "".
[[nodiscard]] std::string rule_at(const std::string& text, std::size_t at);

}  // namespace ptm::layering
