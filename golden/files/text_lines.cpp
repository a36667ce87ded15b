#include "golden/files/text_lines.h"

#include <algorithm>
#include <cstdint>
#include <string_view>

namespace ptm::golden {
namespace {

void append_utf8(std::uint32_t code, std::string& out) {
  if (code < 0x80) {
    out += static_cast<char>(code);
    return;
  }
  const int more = code < 0x800 ? 1 : code < 0x10000 ? 2 : 3;
  const std::uint32_t lead = more == 1 ? 0xC0U : more == 2 ? 0xE0U : 0xF0U;
  out += static_cast<char>(lead | code >> (6 * more));
  for (int k = more - 1; k >= 0; --k) out += static_cast<char>(0x80U | (code >> (6 * k) & 0x3FU));
}

/// `text` without its byte order mark. Half a pair of surrogates, which is no character, becomes
/// U+FFFD, as does an odd last byte.
std::string from_utf16(std::string_view text, bool little) {
  const auto unit = [&](std::size_t at) -> std::uint32_t {
    const auto byte = [&](std::size_t k) {
      return std::uint32_t{static_cast<unsigned char>(text[k])};
    };
    if (at + 1 >= text.size()) return 0xFFFD;
    return little ? byte(at + 1) << 8 | byte(at) : byte(at) << 8 | byte(at + 1);
  };
  const auto within = [](std::uint32_t u, std::uint32_t low) {
    return u >= low && u < low + 0x400;
  };
  std::string out;
  for (std::size_t at = 0; at < text.size(); at += 2) {
    std::uint32_t code = unit(at);
    if (within(code, 0xD800) && at + 3 < text.size() && within(unit(at + 2), 0xDC00)) {
      code = 0x10000 + ((code - 0xD800) << 10) + (unit(at + 2) - 0xDC00);
      at += 2;
    } else if (within(code, 0xD800) || within(code, 0xDC00)) {
      code = 0xFFFD;
    }
    append_utf8(code, out);
  }
  return out;
}

std::string plain_text(std::string text) {
  if (text.starts_with("\xEF\xBB\xBF")) return text.substr(3);
  if (text.starts_with("\xFF\xFE")) return from_utf16(std::string_view(text).substr(2), true);
  if (text.starts_with("\xFE\xFF")) return from_utf16(std::string_view(text).substr(2), false);
  return text;
}

}  // namespace

std::vector<std::string> read_text_lines(const std::filesystem::path& path, const std::string& what,
                                         std::uintmax_t most_bytes) {
  const std::string text = plain_text(read_text_file(path, what, most_bytes));
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find_first_of("\r\n", at), text.size());
    lines.push_back(text.substr(at, end - at));
    at = end + (text.compare(end, 2, "\r\n") == 0 ? 2 : 1);
  }
  return lines;
}

}  // namespace ptm::golden
