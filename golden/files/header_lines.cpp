#include "golden/files/header_lines.h"

#include <algorithm>

#include "golden/files/number_text.h"

namespace ptm::golden {
namespace {

/// Longer than any header line (18 numbers of 20 characters), far shorter than a payload.
constexpr std::size_t longest_line = 4096;

std::vector<std::string_view> words_of(std::string_view text) {
  constexpr std::string_view blanks = " \t";
  std::vector<std::string_view> words;
  std::size_t begin = text.find_first_not_of(blanks);
  while (begin != std::string_view::npos) {
    const std::size_t end = std::min(text.find_first_of(blanks, begin), text.size());
    words.push_back(text.substr(begin, end - begin));
    begin = text.find_first_not_of(blanks, end);
  }
  return words;
}

}  // namespace

std::vector<std::string_view> HeaderLines::next(const std::string& field,
                                                const std::string& expected) {
  line_start_ = position_;
  saw_crlf_before_ = saw_crlf_;
  ++line_;
  const auto rest = bytes_.subspan(position_);
  const auto window = rest.first(std::min(rest.size(), longest_line));
  const auto end = std::find(window.begin(), window.end(), std::uint8_t{'\n'});
  const auto length = static_cast<std::size_t>(end - window.begin());
  // Bytes are read as characters; both are one byte wide.
  text_ = {reinterpret_cast<const char*>(window.data()), length};
  if (end == window.end()) {
    const bool at_end = window.size() == rest.size();
    fail(field,
         at_end ? "the end of the file at byte " + std::to_string(bytes_.size())
                : "no line end within " + std::to_string(longest_line) + " bytes",
         expected);
  }
  position_ += length + 1;
  if (text_.ends_with('\r')) {
    saw_crlf_ = true;
    text_.remove_suffix(1);
  }
  std::vector<std::string_view> words = words_of(text_);
  if (words.empty()) fail(field, "an empty line", expected);
  return words;
}

void HeaderLines::fail(const std::string& field, const std::string& found,
                       const std::string& expected) const {
  throw InputError(file_, place(field), found, expected);
}

std::string HeaderLines::place(const std::string& field) const {
  return "line " + std::to_string(line_) + " (" + field + ")";
}

}  // namespace ptm::golden
