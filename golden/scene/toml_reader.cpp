#include "golden/scene/toml_reader.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <string_view>

#include "golden/files/figure_text.h"
#include "golden/files/whole_file.h"

namespace ptm::golden {
namespace {

std::string shown(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

/// The parser descends once a part of a dotted key, and a long one would end its stack.
void refuse_deep_keys(const std::filesystem::path& path, std::string_view text) {
  constexpr int most_parts = 64;
  int line = 1, dots = 0;
  char quote = 0;
  bool comment = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '\n') {
      ++line, dots = 0, quote = 0, comment = false;
    } else if (comment) {
      continue;
    } else if (quote != 0) {
      if (c == '\\' && quote == '"') ++i;
      if (c == quote) quote = 0;
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '#') {
      comment = true;
    } else if (std::string_view("=,{}[]").find(c) != std::string_view::npos) {
      dots = 0;
    } else if (c == '.' && ++dots >= most_parts) {
      throw InputError(path.string(), "line " + std::to_string(line),
                       "a key of more than " + std::to_string(most_parts) + " parts",
                       "at most that many");
    }
  }
}

}  // namespace

toml::table parse_toml(const std::filesystem::path& path, const std::string& what) {
  const std::string text = read_text_file(path, what);
  refuse_deep_keys(path, text);
  try {
    return toml::parse(text, path.string());
  } catch (const toml::parse_error& problem) {
    throw InputError(path.string(),
                     "line " + std::to_string(problem.source().begin.line) + ", column " +
                         std::to_string(problem.source().begin.column),
                     std::string(problem.description()), "TOML");
  }
}

std::string Reader::kind_of(const toml::node& node) {
  switch (node.type()) {
    case toml::node_type::table:
      return "a table";
    case toml::node_type::array:
      return "an array";
    case toml::node_type::string:
      return "a string";
    case toml::node_type::integer:
      return "an integer";
    case toml::node_type::floating_point:
      return "a number";
    case toml::node_type::boolean:
      return "a boolean";
    default:
      return "a date or time";
  }
}

std::string Reader::place(const toml::node& node, const std::string& key) {
  return "line " + std::to_string(node.source().begin.line) + " (" + key + ")";
}

void Reader::fail(const toml::node& node, const std::string& key, const std::string& found,
                  const std::string& expected) const {
  throw InputError(file_, place(node, key), found, expected);
}

void Reader::only(const toml::table& table, const std::string& prefix,
                  std::span<const std::string_view> known) const {
  for (const auto& [key, node] : table) {
    if (std::find(known.begin(), known.end(), key.str()) != known.end()) continue;
    std::string list;
    for (const std::string_view name : known) {
      list += (list.empty() ? "" : ", ") + std::string(name);
    }
    throw InputError(file_, "line " + std::to_string(key.source().begin.line),
                     "unknown key '" + prefix + std::string(key.str()) + "'", "one of " + list);
  }
}

const toml::table& Reader::table(const toml::node& node, const std::string& key) const {
  const toml::table* found = node.as_table();
  if (!found) fail(node, key, kind_of(node), "a table");
  return *found;
}

const toml::array& Reader::array(const toml::node& node, const std::string& key) const {
  const toml::array* found = node.as_array();
  if (!found) fail(node, key, kind_of(node), "an array");
  return *found;
}

const toml::array& Reader::array(const toml::node& node, const std::string& key,
                                 std::size_t count) const {
  const toml::array& found = array(node, key);
  if (found.size() != count) {
    fail(node, key, count_of(found.size(), "element"), count_of(count, "element"));
  }
  return found;
}

std::string Reader::text(const toml::node& node, const std::string& key) const {
  const auto* found = node.as_string();
  if (!found) fail(node, key, kind_of(node), "a string");
  return found->get();
}

bool Reader::flag(const toml::node& node, const std::string& key) const {
  const auto* found = node.as_boolean();
  if (!found) fail(node, key, kind_of(node), "true or false");
  return found->get();
}

std::int64_t Reader::integer(const toml::node& node, const std::string& key, std::int64_t low,
                             std::int64_t high) const {
  const std::string range =
      "an integer from " + std::to_string(low) + " to " + std::to_string(high);
  const auto* found = node.as_integer();
  if (!found) fail(node, key, kind_of(node), range);
  const std::int64_t value = found->get();
  if (value < low || value > high) fail(node, key, std::to_string(value), range);
  return value;
}

double Reader::number(const toml::node& node, const std::string& key) const {
  if (const auto* whole = node.as_integer()) return static_cast<double>(whole->get());
  const auto* found = node.as_floating_point();
  if (!found) fail(node, key, kind_of(node), "a finite number");
  if (!std::isfinite(found->get())) {
    fail(node, key, std::isnan(found->get()) ? "nan" : "inf", "a finite number");
  }
  return found->get();
}

std::string TableReader::name(std::string_view key) const {
  if (key.empty() && !prefix_.empty()) return prefix_.substr(0, prefix_.size() - 1);
  return prefix_ + std::string(key);
}

std::string TableReader::place(std::string_view key) const {
  const toml::node* node = find(key);
  return Reader::place(node ? *node : *table_, name(key));
}

void TableReader::fail(std::string_view key, const std::string& found,
                       const std::string& expected) const {
  const toml::node* node = find(key);
  reader_->fail(node ? *node : *table_, name(key), found, expected);
}

void TableReader::read(std::string_view key, std::string& value) const {
  if (const toml::node* node = find(key)) value = reader_->text(*node, name(key));
}

void TableReader::read(std::string_view key, bool& value) const {
  if (const toml::node* node = find(key)) value = reader_->flag(*node, name(key));
}

void TableReader::read(std::string_view key, int& value, int low, int high) const {
  const toml::node* node = find(key);
  if (node) value = static_cast<int>(reader_->integer(*node, name(key), low, high));
}

void TableReader::read(std::string_view key, std::uint64_t& value) const {
  const toml::node* node = find(key);
  if (!node) return;
  constexpr std::int64_t most = std::numeric_limits<std::int64_t>::max();
  value = static_cast<std::uint64_t>(reader_->integer(*node, name(key), 0, most));
}

void TableReader::read(std::string_view key, double& value, double low, double high) const {
  const toml::node* node = find(key);
  if (!node) return;
  const double found = reader_->number(*node, name(key));
  if (found < low || found > high) {
    fail(key, shown(found), "a number from " + shown(low) + " to " + shown(high));
  }
  value = found;
}

void TableReader::read(std::string_view key, std::span<double> values, double low,
                       double high) const {
  const toml::node* node = find(key);
  if (!node) return;
  const toml::array& found = reader_->array(*node, name(key), values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::string element = name(key) + "[" + std::to_string(i) + "]";
    values[i] = reader_->number(found[i], element);
    if (values[i] < low || values[i] > high) {
      reader_->fail(found[i], element, shown(values[i]),
                    "a number from " + shown(low) + " to " + shown(high));
    }
  }
}

void TableReader::read(std::string_view key, Vec3& value) const {
  read(key, std::span<double>(value.data(), 3), -1e9, 1e9);
}

TableReader TableReader::table(std::string_view key) const {
  return {*reader_, reader_->table(*find(key), name(key)), name(key) + "."};
}

}  // namespace ptm::golden
