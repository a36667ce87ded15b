#include "contract/generator/text.h"

#include <sstream>

namespace ptm::contract {

std::vector<std::string> wrapped(std::string_view words, std::size_t columns) {
  std::vector<std::string> lines;
  std::istringstream in{std::string(words)};
  for (std::string word; in >> word;) {
    if (lines.empty() || lines.back().size() + 1 + word.size() > columns) {
      lines.push_back(word);
    } else {
      lines.back().append(" ").append(word);
    }
  }
  return lines;
}

std::string joined(const std::vector<std::string>& parts, std::string_view between) {
  std::string text;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (i > 0) text.append(between);
    text.append(parts[i]);
  }
  return text;
}

std::string padded(std::string_view text, std::size_t width) {
  std::string full(text);
  if (full.size() < width) full.resize(width, ' ');
  return full;
}

Text& Text::line(std::string_view text) {
  text_.append(text).append("\n");
  return *this;
}

Text& Text::lines(std::string_view text) {
  text_.append(text);
  return *this;
}

Text& Text::comment(std::string_view prefix, std::string_view words) {
  for (const std::string& part : wrapped(words, kColumns - prefix.size())) {
    line(std::string(prefix) + part);
  }
  return *this;
}

Text& Text::list(std::string_view indent, const std::vector<std::string>& parts,
                 std::string_view end) {
  std::string current(indent);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    std::string part = parts[i];
    part.append(i + 1 == parts.size() ? end : std::string_view(","));
    const bool first = current.size() == indent.size();
    if (!first && current.size() + 1 + part.size() > kColumns) {
      line(current);
      current = indent;
    } else if (!first) {
      current += ' ';
    }
    current += part;
  }
  return line(current);
}

}  // namespace ptm::contract
