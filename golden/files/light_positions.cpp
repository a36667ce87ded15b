#include "golden/files/light_positions.h"

#include <charconv>
#include <iomanip>
#include <optional>
#include <sstream>
#include <string_view>

#include "golden/files/light_directions.h"
#include "golden/files/number_text.h"
#include "golden/files/pending_file.h"
#include "golden/files/whole_file.h"

namespace ptm::golden {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kBlanks = " \t\r\f\v";

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

/// Takes the last field off `text`.
std::string_view pop_field(std::string_view& text) {
  const std::size_t blank = text.find_last_of(kBlanks);
  const std::string_view field = blank == std::string_view::npos ? text : text.substr(blank + 1);
  text = trimmed(blank == std::string_view::npos ? std::string_view{} : text.substr(0, blank));
  return field;
}

class Reader {
 public:
  explicit Reader(const fs::path& path) : path_(path) {}

  LightPositions read() {
    std::istringstream in(read_text_file(path_, "a light position file (.lp)"));
    for (std::string line; std::getline(in, line);) {
      ++line_;
      std::string_view text = line;
      if (line_ == 1 && text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
      text = trimmed(text);
      if (!text.empty() && !take_count(text)) take_light(text);
    }
    finish();
    return std::move(result_);
  }

 private:
  [[noreturn]] void fail(const std::string& found, const std::string& expected) const {
    throw InputError(path_.string(), "line " + std::to_string(line_), found, expected);
  }

  /// The first line that is not blank may be a lone whole number.
  bool take_count(std::string_view text) {
    if (seen_++ > 0) return false;
    std::size_t count = 0;
    const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), count);
    if (error != std::errc{} || stop != text.data() + text.size()) return false;
    count_ = count;
    return true;
  }

  void take_light(std::string_view text) {
    const std::string whole(text);
    std::array<std::string_view, 3> fields;
    for (std::size_t i = 3; i-- > 0;) fields[i] = pop_field(text);
    if (text.empty()) fail("'" + whole + "'", "a picture's name and three numbers");
    LitPicture lit;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto value = parse_real(fields[i]);
      if (!value) fail("coordinate '" + std::string(fields[i]) + "'", "a finite number");
      lit.direction[i] = *value;
    }
    lit.line = line_;
    lit.picture = find_picture(std::string(text));
    ++lights_;
    if (directions_.take(lit.direction, path_.string(), "line " + std::to_string(line_),
                         result_.notes)) {
      result_.pictures.push_back(std::move(lit));
    }
  }

  fs::path find_picture(std::string name) const {
    const fs::path folder = path_.parent_path();
    for (char& c : name) c = c == '\\' ? '/' : c;
    for (const fs::path& candidate : {folder / name, folder / fs::path(name).filename()}) {
      std::error_code ignored;
      if (fs::is_regular_file(candidate, ignored)) return candidate;
    }
    fail("no picture '" + name + "'", "an existing file beside the light positions");
  }

  void finish() {
    directions_.finish(result_.notes);
    if (count_ && *count_ != lights_) {
      result_.notes.push_back("the first line says " + std::to_string(*count_) +
                              " lights, the file has " + std::to_string(lights_));
    }
    if (result_.pictures.empty()) {
      throw InputError(path_.string(), "file", "no light above the horizon",
                       "lines of a picture's name and three numbers");
    }
  }

  fs::path path_;
  LightPositions result_;
  int line_ = 0;
  int seen_ = 0;
  std::optional<std::size_t> count_;
  std::size_t lights_ = 0;
  LightDirections directions_;
};

}  // namespace

LightPositions read_light_positions(const fs::path& path) { return Reader(path).read(); }

std::string format_light_positions(const fs::path& path, const std::vector<LitPicture>& pictures) {
  std::ostringstream out;
  out << pictures.size() << '\n' << std::setprecision(17);
  for (const LitPicture& lit : pictures) {
    out << lit.picture.lexically_proximate(path.parent_path()).generic_string();
    for (const double c : lit.direction) out << ' ' << c;
    out << '\n';
  }
  return std::move(out).str();
}

void write_light_positions(const fs::path& path, const std::vector<LitPicture>& pictures) {
  PendingFile file(path);
  file.write(format_light_positions(path, pictures));
  file.commit();
}

}  // namespace ptm::golden
