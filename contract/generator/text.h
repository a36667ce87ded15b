#pragma once
#include <string>
#include <string_view>
#include <vector>

/// Text that is written line by line.
namespace ptm::contract {

inline constexpr std::size_t kColumns = 100;

/// The words in lines of at most that many characters.
[[nodiscard]] std::vector<std::string> wrapped(std::string_view words, std::size_t columns);

/// "a, b, c"
[[nodiscard]] std::string joined(const std::vector<std::string>& parts,
                                 std::string_view between = ", ");

/// Blanks up to a width.
[[nodiscard]] std::string padded(std::string_view text, std::size_t width);

class Text {
 public:
  Text& line(std::string_view text = {});
  /// Lines that have their ends.
  Text& lines(std::string_view text);
  /// Words as a comment: each line begins with `prefix` ("// ", "  /// ").
  Text& comment(std::string_view prefix, std::string_view words);
  /// Parts with commas between and `end` behind the last, as many a line as go in, each line begun
  /// with `indent`.
  Text& list(std::string_view indent, const std::vector<std::string>& parts, std::string_view end);
  [[nodiscard]] const std::string& str() const { return text_; }

 private:
  std::string text_;
};

}  // namespace ptm::contract
