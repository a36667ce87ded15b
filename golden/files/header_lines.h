#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "golden/files/input_error.h"

namespace ptm::golden {

/// Reads a header line by line. A line ends with LF; a CR before it and blanks around its words are
/// dropped. The byte after the last line's LF is the payload's first, whatever it is.
class HeaderLines {
 public:
  /// `bytes` are the file's first ones, of `file_bytes` in all.
  HeaderLines(std::span<const std::uint8_t> bytes, std::string file, std::uint64_t file_bytes)
      : bytes_(bytes), file_(std::move(file)), file_bytes_(file_bytes) {}

  /// The words of the next line; `field` names it in errors. Throws InputError where no line end
  /// comes within 4096 bytes or before the end of the file, and for an empty line.
  [[nodiscard]] std::vector<std::string_view> next(const std::string& field,
                                                   const std::string& expected);

  /// Takes back the last line read.
  void step_back() {
    position_ = line_start_;
    saw_crlf_ = saw_crlf_before_;
    --line_;
  }

  /// Refuses the line read last.
  [[noreturn]] void fail(const std::string& field, const std::string& found,
                         const std::string& expected) const;

  [[nodiscard]] std::size_t position() const { return position_; }
  [[nodiscard]] std::uint64_t bytes_left() const { return file_bytes_ - position_; }
  [[nodiscard]] const std::string& file() const { return file_; }
  [[nodiscard]] bool saw_crlf() const { return saw_crlf_; }
  /// The whole line read last, for messages.
  [[nodiscard]] std::string_view text() const { return text_; }
  /// The line read last as "line 5 (scales)".
  [[nodiscard]] std::string place(const std::string& field) const;

 private:
  std::span<const std::uint8_t> bytes_;
  std::string file_;
  std::uint64_t file_bytes_;
  std::string_view text_;
  std::size_t position_ = 0;
  std::size_t line_start_ = 0;
  int line_ = 0;
  bool saw_crlf_ = false;
  bool saw_crlf_before_ = false;
};

}  // namespace ptm::golden
