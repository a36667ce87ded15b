#include "source_tree.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <sstream>

namespace ptm::layering {
namespace {

namespace fs = std::filesystem;

std::string ending_of(const std::string& path) { return fs::path(path).extension().string(); }

/// Files whose comments begin with two slashes, and those with a number sign.
bool has_slashes(const std::string& path) {
  static const std::set<std::string> endings{".h",   ".cpp", ".in",  ".inc", ".def",
                                             ".svh", ".sv",  ".mjs", ".c"};
  return endings.contains(ending_of(path));
}

bool has_number_signs(const std::string& path) {
  static const std::set<std::string> endings{".cmake", ".txt", ".toml", ".py"};
  return endings.contains(ending_of(path)) ||
         (path.starts_with("scripts/") && ending_of(path).empty());
}

/// Where the line's comment begins, or npos. A marker inside quotes is none.
std::size_t comment_at(const std::string& line, const std::string& marker) {
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (quoted && line[i] == '\\') {
      ++i;
    } else if (line[i] == '"') {
      quoted = !quoted;
    } else if (!quoted && stands_at(line, i, marker)) {
      return i;
    }
  }
  return std::string::npos;
}

std::string without_marker(const std::string& comment) {
  const std::size_t text = comment.find_first_not_of("/#<!");
  return text == std::string::npos ? "" : comment.substr(text);
}

void append(Passage& passage, const std::string& text, int number) {
  passage.lines.emplace_back(passage.text.size(), number);
  passage.text += text + '\n';
}

std::vector<Passage> paragraphs(const TextFile& file) {
  std::vector<Passage> all;
  bool open = false;
  std::istringstream text(file.text);
  std::string line;
  for (int number = 1; std::getline(text, line); ++number) {
    if (line.empty()) {
      open = false;
      continue;
    }
    if (!open) all.push_back({Passage::Kind::page, {}, {}});
    append(all.back(), line, number);
    open = true;
  }
  return all;
}

std::vector<Passage> comments_and_code(const TextFile& file, const std::string& marker) {
  std::vector<Passage> all, code;
  bool open = false;
  std::istringstream text(file.text);
  std::string line;
  for (int number = 1; std::getline(text, line); ++number) {
    const std::size_t at = comment_at(line, marker);
    const std::string before = line.substr(0, at);
    const bool alone = before.find_first_not_of(" \t") == std::string::npos;
    if (!alone) {
      code.push_back({Passage::Kind::code, {}, {}});
      append(code.back(), before, number);
    }
    if (at == std::string::npos) {
      open = false;
      continue;
    }
    if (!open || !alone) all.push_back({Passage::Kind::comment, {}, {}});
    append(all.back(), without_marker(line.substr(at)), number);
    open = true;
  }
  std::move(code.begin(), code.end(), std::back_inserter(all));
  return all;
}

std::string contents_of(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

void SourceTree::add(const std::string& path, const std::string& text) {
  files.push_back({path, text});
  for (fs::path part = path; !part.empty(); part = part.parent_path()) {
    paths.insert(part.string());
    basenames.insert(part.filename().string());
  }
}

const TextFile* SourceTree::find(const std::string& path) const {
  const auto found =
      std::find_if(files.begin(), files.end(), [&](const TextFile& f) { return f.path == path; });
  return found == files.end() ? nullptr : &*found;
}

const std::vector<std::string>& source_folders() {
  static const std::vector<std::string> all{"bench",   "cmake",     "contract", "docs",
                                            "golden",  "model",     "rtl",      "scenes",
                                            "scripts", "testbench", "tests"};
  return all;
}

SourceTree read_tree(const fs::path& root) {
  SourceTree tree;
  tree.add("README.md", contents_of(root / "README.md"));
  for (const std::string& folder : source_folders()) {
    if (!fs::exists(root / folder)) continue;
    for (auto entry = fs::recursive_directory_iterator(root / folder);
         entry != fs::recursive_directory_iterator(); ++entry) {
      if (entry->path().filename() == "node_modules") entry.disable_recursion_pending();
      if (!entry->is_regular_file()) continue;
      const std::string path = entry->path().lexically_relative(root).generic_string();
      const bool read = has_slashes(path) || has_number_signs(path) || path.ends_with(".md");
      tree.add(path, read ? contents_of(entry->path()) : std::string());
    }
  }
  return tree;
}

int Passage::line_at(std::size_t offset) const {
  const auto after =
      std::upper_bound(lines.begin(), lines.end(), offset,
                       [](std::size_t value, const std::pair<std::size_t, int>& line) {
                         return value < line.first;
                       });
  return after == lines.begin() ? 0 : std::prev(after)->second;
}

bool stands_at(const std::string& text, std::size_t at, std::string_view what) {
  return at <= text.size() && text.compare(at, what.size(), what) == 0;
}

bool is_page(const TextFile& file) { return file.path.ends_with(".md"); }

std::vector<Passage> passages_of(const TextFile& file) {
  if (is_page(file)) return paragraphs(file);
  if (has_slashes(file.path)) return comments_and_code(file, "//");
  if (has_number_signs(file.path)) return comments_and_code(file, "#");
  return {};
}

}  // namespace ptm::layering
