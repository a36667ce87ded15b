#pragma once
#include <ostream>
#include <string>
#include <vector>

#include "source_tree.h"

/// References of one part of the repository to another that lead nowhere.
namespace ptm::layering {

struct DeadReference {
  std::string file;
  int line = 0;
  std::string what;  ///< what is named, and what is missing

  friend std::ostream& operator<<(std::ostream& out, const DeadReference& dead) {
    return out << dead.file << ":" << dead.line << ": " << dead.what;
  }
};

/// Looks in pages and comments, and for pages in all text, at
/// - paths from the root, and names of files: they exist. <id>, * and NAME stand for any;
/// - links of a page, and anchors behind a page's name;
/// - sections, numbered sections and rules cited after a page ("docs/spec/unit.md, Registers");
/// - rules by their labels (a letter and a number): some page of docs/spec defines each;
/// - what follows "Twin": a file or folder, and functions that stand in there;
/// - tests ("Suite.Test"): they exist in tests/;
/// - names in mixed case in a page's back quotes: some source has that word.
[[nodiscard]] std::vector<DeadReference> dead_references(const SourceTree& tree);

}  // namespace ptm::layering
