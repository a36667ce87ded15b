#include "doc_page.h"

#include <cctype>
#include <sstream>

namespace ptm::layering {
namespace {

bool is(int (*of_kind)(int), const std::string& text, std::size_t at) {
  return at < text.size() && of_kind(static_cast<unsigned char>(text[at])) != 0;
}

bool in_word(const std::string& text, std::size_t at) {
  return is(std::isalnum, text, at) || (at < text.size() && text[at] == '_');
}

/// Whether `part` begins `whole` and ends where a word does.
bool begins(const std::string& whole, const std::string& part) {
  return !part.empty() && whole.starts_with(part) && !in_word(whole, part.size());
}

std::string plain(const std::string& marked) {
  std::string text;
  for (const char c : marked) {
    if (c != '`' && c != '*') text += c;
  }
  while (!text.empty() && (text.back() == '.' || text.back() == ':' || text.back() == ' ')) {
    text.pop_back();
  }
  return text;
}

std::string anchor_of(const std::string& heading) {
  std::string anchor;
  for (const char c : heading) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_') {
      anchor += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    } else if (c == ' ') {
      anchor += '-';
    }
  }
  return anchor;
}

void read_heading(DocPage& page, const std::string& line) {
  std::string heading = plain(line.substr(line.find_first_not_of('#')));
  heading.erase(0, heading.find_first_not_of(' '));
  page.anchors.insert(anchor_of(heading));
  const std::size_t digits = heading.find_first_not_of("0123456789");
  if (digits != 0 && digits != std::string::npos && stands_at(heading, digits, ". ")) {
    page.numbers.insert(std::stoi(heading));
    heading.erase(0, digits + 2);
  }
  page.sections.insert(heading);
}

void read_bold(DocPage& page, const std::string& line) {
  for (std::size_t open = line.find("**"); open != std::string::npos;) {
    const std::size_t close = line.find("**", open + 2);
    if (close == std::string::npos) return;
    const std::string term = plain(line.substr(open + 2, close - open - 2));
    page.sections.insert(term);
    const std::string rule = rule_at(term, 0);
    if (!rule.empty() && (rule == term || term[rule.size()] == ' ')) page.rules.insert(rule);
    open = line.find("**", close + 2);
  }
}

void read_rule(DocPage& page, const std::string& line) {
  const bool cell = line.starts_with("| ");
  const std::string rule = rule_at(line, cell ? 2 : 0);
  if (rule.empty()) return;
  if (stands_at(line, (cell ? 2 : 0) + rule.size(), cell ? " |" : ". ")) {
    page.rules.insert(rule);
  }
}

}  // namespace

bool DocPage::has_section(const std::string& words) const {
  for (const std::string& section : sections) {
    if (begins(section, words) || begins(words, section)) return true;
  }
  return false;
}

std::string rule_at(const std::string& text, std::size_t at) {
  if (!is(std::isupper, text, at) || !is(std::isdigit, text, at + 1)) return {};
  if (at != 0 &&
      (in_word(text, at - 1) || std::string("-#$'\".\\").find(text[at - 1]) != std::string::npos)) {
    const bool range = at > 1 && stands_at(text, at - 2, "..");  // D1..D7
    if (!range) return {};
  }
  std::size_t end = at + 2;
  if (is(std::isdigit, text, end)) ++end;
  if (is(std::islower, text, end)) ++end;
  if (in_word(text, end) || (end < text.size() && (text[end] == '\'' || text[end] == '('))) {
    return {};
  }
  if (stands_at(text, end, ".") && is(std::isalnum, text, end + 1)) return {};  // Q8.20
  return text.substr(at, end - at);
}

DocPage read_page(const std::string& text) {
  DocPage page;
  std::istringstream lines(text);
  std::string line;
  bool fenced = false;
  while (std::getline(lines, line)) {
    if (line.starts_with("```")) fenced = !fenced;
    if (fenced) continue;
    if (line.starts_with("#")) read_heading(page, line);
    read_bold(page, line);
    read_rule(page, line);
  }
  return page;
}

}  // namespace ptm::layering
