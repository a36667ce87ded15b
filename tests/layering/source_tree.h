#pragma once
#include <cstddef>
#include <filesystem>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// The repository's text as tests of its references read it.
namespace ptm::layering {

struct TextFile {
  std::string path;  ///< from the tree's root, with '/'
  std::string text;
};

struct SourceTree {
  std::vector<TextFile> files;      ///< those with text that is read
  std::set<std::string> paths;      ///< every file and folder, from the root
  std::set<std::string> basenames;  ///< of those paths

  /// Adds a file, the folders above it, and its text.
  void add(const std::string& path, const std::string& text);
  [[nodiscard]] const TextFile* find(const std::string& path) const;
};

/// The folders in which the project's own files lie; others (the build's, a run's) are not read.
[[nodiscard]] const std::vector<std::string>& source_folders();

/// Reads the source folders and README.md. What a package manager put there is left out.
[[nodiscard]] SourceTree read_tree(const std::filesystem::path& root);

/// Text that belongs together, with its lines: a paragraph of a page, the comments of lines that
/// follow each other, or the code of one line.
struct Passage {
  enum class Kind { page, comment, code };
  Kind kind = Kind::page;
  std::string text;                                ///< lines, each ended by '\n'
  std::vector<std::pair<std::size_t, int>> lines;  ///< where in the text each line begins

  [[nodiscard]] int line_at(std::size_t offset) const;
};

/// Whether `what` stands at that place of the text, which may lie behind its end.
[[nodiscard]] bool stands_at(const std::string& text, std::size_t at, std::string_view what);

[[nodiscard]] bool is_page(const TextFile& file);
[[nodiscard]] std::vector<Passage> passages_of(const TextFile& file);

}  // namespace ptm::layering
