#include "references.h"

#include <fnmatch.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <string_view>
#include <unordered_set>

#include "doc_page.h"

namespace ptm::layering {
namespace {

bool word_character(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }
bool path_character(char c) {
  return word_character(c) || std::string_view("./<>*-").find(c) != std::string_view::npos;
}
bool capital(const std::string& text, std::size_t at) {
  return at < text.size() && std::isupper(static_cast<unsigned char>(text[at])) != 0;
}

std::string spaces_joined(const std::string& text) {
  std::string joined;
  for (const char c : text) {
    const bool space = c == '\n' || c == ' ';
    if (!space || joined.empty() || joined.back() != ' ') joined += space ? ' ' : c;
  }
  return joined;
}

/// What follows a page's name, in one line; a line that begins with a capital ends what is cited.
std::string citation(const std::string& text) {
  std::string cut;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const bool next = capital(text, at + 1) || stands_at(text, at + 1, "\n");
    cut += text[at] == '\n' && at != 0 && next ? '.' : text[at];
  }
  return spaces_joined(cut);
}

template <class See>
void for_each_word(const std::string& text, See&& see) {
  for (std::size_t at = 0; at < text.size();) {
    std::size_t end = at;
    while (end < text.size() && word_character(text[end])) ++end;
    if (end != at) see(at, text.substr(at, end - at));
    at = end + 1;
  }
}

/// NAME, <id> and * as a shell's pattern; "" if the path has none of them.
std::string pattern_of(const std::string& path) {
  std::string pattern;
  bool any = false;
  for (std::size_t at = 0; at < path.size();) {
    std::size_t end = at;
    while (end < path.size() && (std::isupper(static_cast<unsigned char>(path[end])) != 0)) ++end;
    const bool name = end - at >= 2;
    const bool slot = path[at] == '<' && path.find('>', at) != std::string::npos;
    if (slot) end = path.find('>', at) + 1;
    if (name || slot || path[at] == '*') {
      pattern += '*';
      any = true;
      at = std::max(end, at + 1);
    } else {
      pattern += path[at++];
    }
  }
  return any ? pattern : std::string();
}

bool mixed_case(const std::string& word) {
  const auto lower = [](char c) { return std::islower(static_cast<unsigned char>(c)) != 0; };
  const auto upper = [](char c) { return std::isupper(static_cast<unsigned char>(c)) != 0; };
  return capital(word, 0) && std::any_of(word.begin(), word.end(), lower) &&
         std::count_if(word.begin(), word.end(), upper) > 1 && word.find('_') == std::string::npos;
}

class Checker {
 public:
  explicit Checker(const SourceTree& tree) : tree_(tree) {
    for (const TextFile& file : tree.files) {
      if (!is_page(file)) {
        read_words(file);
        continue;
      }
      const DocPage& page = pages_[file.path] = read_page(file.text);
      if (!file.path.starts_with("docs/spec/")) continue;
      rules_.insert(page.rules.begin(), page.rules.end());
    }
  }

  std::vector<DeadReference> check() {
    for (const TextFile& file : tree_.files) {
      file_ = &file;
      for (const Passage& passage : passages_of(file)) {
        passage_ = &passage;
        check_pages();
        if (passage.kind == Passage::Kind::code) continue;
        check_paths();
        check_rules();
        check_twins();
        check_tests();
        if (passage.kind == Passage::Kind::page) check_quoted_names();
      }
    }
    return std::move(dead_);
  }

 private:
  void report(std::size_t offset, const std::string& what) {
    dead_.push_back({file_->path, passage_->line_at(offset), what});
  }

  void read_words(const TextFile& file) {
    for (const Passage& passage : passages_of(file)) {
      if (passage.kind != Passage::Kind::code) continue;
      for_each_word(passage.text,
                    [&](std::size_t, const std::string& word) { words_.insert(word); });
    }
    if (!file.path.starts_with("tests/")) return;
    for (std::size_t at = file.text.find("TEST"); at != std::string::npos;
         at = file.text.find("TEST", at + 4)) {
      const std::size_t open = file.text.find('(', at), comma = file.text.find(',', at);
      const std::size_t close = file.text.find(')', at);
      if (close == std::string::npos || !(open < comma && comma < close)) continue;
      std::string suite, test;
      for_each_word(file.text.substr(open, comma - open),
                    [&](std::size_t, const std::string& word) { suite = word; });
      for_each_word(file.text.substr(comma, close - comma),
                    [&](std::size_t, const std::string& word) { test = word; });
      tests_.insert(suite + "." + test);
    }
  }

  /// What the contract's tables make is included as "contract/..." from rtl/ or the build's folder.
  [[nodiscard]] bool made_of_tables(const std::string& path) const {
    if (!path.starts_with("contract/")) return false;
    if (tree_.paths.contains("rtl/" + path)) return true;
    const TextFile* rules = tree_.find("contract/CMakeLists.txt");
    return rules != nullptr && rules->text.find(path.substr(9)) != std::string::npos;
  }

  [[nodiscard]] bool path_exists(const std::string& path) const {
    if (tree_.paths.contains(path) || made_of_tables(path)) return true;
    const std::string pattern = pattern_of(path);
    return !pattern.empty() &&
           std::any_of(tree_.paths.begin(), tree_.paths.end(), [&](const std::string& one) {
             return fnmatch(pattern.c_str(), one.c_str(), FNM_PATHNAME) == 0;
           });
  }

  /// Paths and names of files in some text: where they begin, and they themselves.
  static std::vector<std::pair<std::size_t, std::string>> path_tokens(const std::string& text) {
    std::vector<std::pair<std::size_t, std::string>> tokens;
    for (std::size_t at = 0; at < text.size();) {
      std::size_t end = at;
      while (end < text.size() && path_character(text[end])) ++end;
      std::string token = text.substr(at, end - at);
      const bool prefix = end < text.size() && (text[end] == '{' || text[end] == '$');
      while (!token.empty() && std::string_view("./-").find(token.back()) != std::string_view::npos)
        token.pop_back();
      if (!prefix && token.size() > 3) tokens.emplace_back(at, token);
      at = end + 1;
    }
    return tokens;
  }

  static bool from_root(const std::string& token) {
    return std::any_of(source_folders().begin(), source_folders().end(),
                       [&](const std::string& top) { return token.starts_with(top + "/"); });
  }

  void check_paths() {
    for (const auto& [at, token] : path_tokens(passage_->text)) {
      if (from_root(token)) {
        if (!path_exists(token)) report(at, "no file or folder " + token);
        continue;
      }
      if (token.find('/') != std::string::npos || !names_a_source(token)) continue;
      const bool there = tree_.basenames.contains(token) || !pattern_of(token).empty();
      if (!there) report(at, "no file " + token);
    }
  }

  static bool names_a_source(const std::string& token) {
    const std::size_t dot = token.rfind('.');
    return dot != 0 && dot != std::string::npos &&
           std::set<std::string>{".sv", ".svh", ".md", ".def"}.contains(token.substr(dot));
  }

  /// The page that is named by text which ends at `end`, from the root or by its name alone.
  [[nodiscard]] const DocPage* page_before(std::size_t end, std::string& name) const {
    const std::string& text = passage_->text;
    std::size_t begin = end;
    while (begin != 0 && path_character(text[begin - 1])) --begin;
    name = text.substr(begin, end - begin);
    const std::filesystem::path beside = std::filesystem::path(file_->path).parent_path() / name;
    for (const std::string& path : {name, beside.lexically_normal().generic_string()}) {
      if (const auto found = pages_.find(path); found != pages_.end()) return &found->second;
    }
    const DocPage* found = nullptr;
    for (const auto& [path, page] : pages_) {
      const bool normative = path == "docs/spec/" + name;
      if (normative || (found == nullptr && path.ends_with("/" + name))) found = &page;
    }
    return found;
  }

  void check_pages() {
    const std::string& text = passage_->text;
    for (std::size_t dot = text.find(".md"); dot != std::string::npos;
         dot = text.find(".md", dot + 3)) {
      std::size_t end = dot + 3;
      if (end < text.size() && word_character(text[end])) continue;
      std::string name;
      const DocPage* page = page_before(end, name);
      const std::size_t begin = end - name.size();
      const bool link = begin >= 2 && stands_at(text, begin - 2, "](");
      if (page == nullptr) {
        // A comment's or a page's name alone is looked at as a path.
        const bool told = passage_->kind == Passage::Kind::code && name.starts_with("docs/");
        if (link || told) report(begin, "no page " + name);
        continue;
      }
      if (end < text.size() && text[end] == '#') {
        std::size_t stop = end + 1;
        while (stop < text.size() && (word_character(text[stop]) || text[stop] == '-')) ++stop;
        const std::string anchor = text.substr(end + 1, stop - end - 1);
        if (!page->anchors.contains(anchor)) report(begin, name + " has no anchor #" + anchor);
        end = stop;
      }
      while (end < text.size() && (text[end] == '`' || (link && text[end] == ')'))) ++end;
      if (stands_at(text, end, ",")) {
        check_citation(begin, name, *page, citation(text.substr(end + 1, 200)));
      }
    }
    check_links();
  }

  /// Links of a page to files that are no pages.
  void check_links() {
    if (passage_->kind != Passage::Kind::page) return;
    const std::string& text = passage_->text;
    for (std::size_t at = text.find("]("); at != std::string::npos; at = text.find("](", at + 2)) {
      std::string target = text.substr(at + 2, text.find_first_of(")#", at) - at - 2);
      if (target.find("://") != std::string::npos) continue;
      if (target.empty()) {
        check_own_anchor(at);
        continue;
      }
      const auto path = std::filesystem::path(file_->path).parent_path() / target;
      if (!tree_.paths.contains(path.lexically_normal().generic_string())) {
        report(at, "the link leads to no file: " + target);
      }
    }
  }

  void check_own_anchor(std::size_t at) {
    const std::string& text = passage_->text;
    const std::string anchor = text.substr(at + 3, text.find(')', at) - at - 3);
    if (!pages_[file_->path].anchors.contains(anchor)) {
      report(at, "the page has no anchor #" + anchor);
    }
  }

  /// What follows a page's name and a comma: sections in quotes or with a capital, rules, numbers.
  void check_citation(std::size_t at, const std::string& name, const DocPage& page,
                      std::string rest) {
    bool more = true;
    while (more) {
      rest.erase(0, std::min(rest.find_first_not_of(' '), rest.size()));
      if (rest.starts_with("section")) {
        const std::size_t digit = rest.find_first_of("0123456789");
        if (digit == std::string::npos || digit > 9) return;
        const int number = std::stoi(rest.substr(digit));
        if (!page.numbers.contains(number)) {
          report(at, name + " has no section " + std::to_string(number));
        }
        return;
      }
      const std::size_t taken = take_section(at, name, page, rest);
      rest.erase(0, taken);
      more = false;
      for (const std::string joint : {" and ", " to ", ", "}) {
        const bool rule = !rule_at(rest, joint.size()).empty();
        const bool words = joint == " and " && (capital(rest, 5) || stands_at(rest, 5, "\""));
        if (taken == 0 || !rest.starts_with(joint) || !(rule || words)) continue;
        rest.erase(0, joint.size());
        more = true;
        break;
      }
    }
  }

  std::size_t take_section(std::size_t at, const std::string& name, const DocPage& page,
                           const std::string& rest) {
    if (const std::string rule = rule_at(rest, 0); !rule.empty()) {
      const bool stage = page.has_section(rule);
      if (!page.rules.contains(rule) && !stage) report(at, name + " has no rule " + rule);
      return rule.size();
    }
    const bool quoted = rest.starts_with("\"") || rest.starts_with("'");
    std::string words;
    if (quoted) {
      words = rest.substr(1, rest.find(rest[0], 1) - 1);
    } else if (capital(rest, 0)) {
      words = rest.substr(0, rest.find_first_of(".,;:()"));
      for (std::size_t joint = words.find(" and "); joint != std::string::npos;
           joint = words.find(" and ", joint + 1)) {
        if (capital(words, joint + 5)) words.erase(joint);
      }
      while (words.ends_with(" ")) words.pop_back();
    }
    if (words.empty()) return 0;
    if (!page.has_section(words)) report(at, name + " has no section \"" + words + "\"");
    return words.size() + (quoted ? 2 : 0);
  }

  /// Labels of others: options of compilers, kinds of PNM files, the constants of SSIM's paper.
  static bool is_no_rule(const std::string& label) {
    static const std::set<std::string> all{"O1", "O2", "O3", "P1", "P6", "K1", "K2", "C11"};
    return all.contains(label);
  }

  void check_rules() {
    const std::string& text = passage_->text;
    for (std::size_t at = 0; at + 1 < text.size(); ++at) {
      const std::string rule = rule_at(text, at);
      if (!rule.empty() && !rules_.contains(rule) && !is_no_rule(rule))
        report(at, "no page defines rule " + rule);
    }
  }

  void check_twins() {
    const std::string& text = passage_->text;
    for (std::size_t at = text.find("win"); at != std::string::npos;
         at = text.find("win", at + 3)) {
      if (at == 0 || (text[at - 1] != 'T' && text[at - 1] != 't')) continue;
      const std::size_t after = at + 3 + (stands_at(text, at + 3, "s") ? 1 : 0);
      std::size_t end = text.size();
      if (stands_at(text, after, "  ")) {
        end = text.find('\n', after);  // "Twin      rtl/arith/ptm_arith_lerp.sv"
      } else if (stands_at(text, after, ":") || stands_at(text, after, " of ")) {
        const std::string sentence = spaces_joined(text.substr(after));
        check_twin(at - 1, sentence.substr(0, sentence.find(". ")));
        continue;
      } else {
        continue;
      }
      check_twin(at - 1, text.substr(after, end - after));
    }
  }

  void check_twin(std::size_t at, const std::string& sentence) {
    std::vector<std::string> places;
    for (const auto& [ignored, token] : path_tokens(sentence)) {
      if (from_root(token)) places.push_back(token);
    }
    if (places.empty()) {
      report(at, "the twin names no file or folder:" + sentence);
      return;
    }
    for (std::size_t open = sentence.find("()"); open != std::string::npos;
         open = sentence.find("()", open + 2)) {
      std::size_t begin = open;
      while (begin != 0 && word_character(sentence[begin - 1])) --begin;
      const std::string function = sentence.substr(begin, open - begin);
      const bool there = std::any_of(places.begin(), places.end(), [&](const std::string& place) {
        return defines(place, function);
      });
      if (!there) report(at, "the twin " + function + "() is not in " + places.front());
    }
  }

  /// Whether a file, or one below a folder, has the function's name before a parenthesis.
  [[nodiscard]] bool defines(const std::string& place, const std::string& function) const {
    for (const TextFile& file : tree_.files) {
      if (file.path != place && !file.path.starts_with(place + "/")) continue;
      for (std::size_t at = file.text.find(function + "("); at != std::string::npos;
           at = file.text.find(function + "(", at + 1)) {
        if (at == 0 || !word_character(file.text[at - 1])) return true;
      }
    }
    return false;
  }

  void check_tests() {
    const std::string& text = passage_->text;
    for_each_word(text, [&](std::size_t at, const std::string& suite) {
      const std::size_t dot = at + suite.size();
      if (!mixed_case_or_word(suite) || !stands_at(text, dot, ".") || !capital(text, dot + 1)) {
        return;
      }
      std::size_t end = dot + 1;
      while (end < text.size() && word_character(text[end])) ++end;
      const std::string test = text.substr(dot + 1, end - dot - 1);
      if (!mixed_case(test) || tests_.contains(suite + "." + test)) return;
      report(at, "no test " + suite + "." + test);
    });
  }

  static bool mixed_case_or_word(const std::string& word) {
    return capital(word, 0) && word.size() > 1 &&
           std::islower(static_cast<unsigned char>(word[1])) != 0;
  }

  void check_quoted_names() {
    const std::string& text = passage_->text;
    for_each_word(text, [&](std::size_t at, const std::string& word) {
      const std::size_t end = at + word.size();
      if (at == 0 || text[at - 1] != '`' || !stands_at(text, end, "`")) return;
      if (mixed_case(word) && !words_.contains(word)) report(at, "no source has the name " + word);
    });
  }

  const SourceTree& tree_;
  std::map<std::string, DocPage> pages_;
  std::set<std::string> rules_, tests_;
  std::unordered_set<std::string> words_;
  const TextFile* file_ = nullptr;
  const Passage* passage_ = nullptr;
  std::vector<DeadReference> dead_;
};

}  // namespace

std::vector<DeadReference> dead_references(const SourceTree& tree) { return Checker(tree).check(); }

}  // namespace ptm::layering
