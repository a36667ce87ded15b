#include "contract/generator/table.h"

#include <algorithm>
#include <fstream>
#include <iterator>

namespace ptm::contract {
namespace {

std::string kind_of(const toml::node& node) {
  if (node.is_table()) return "a table";
  if (node.is_array()) return "an array";
  if (node.is_string()) return "a text";
  if (node.is_integer()) return "an integer";
  if (node.is_boolean()) return "a boolean";
  return "something else";
}

std::string at(const std::string& file, const toml::source_region& source) {
  return file + ":" + std::to_string(source.begin.line) + ": ";
}

void refuse_others(const std::string& file, const toml::table& table,
                   std::initializer_list<std::string_view> known) {
  for (const auto& [key, node] : table) {
    if (std::find(known.begin(), known.end(), key.str()) != known.end()) continue;
    std::string list;
    for (const std::string_view name : known) list.append(list.empty() ? "" : ", ").append(name);
    throw TableError(at(file, key.source()) + "unknown key '" + std::string(key.str()) +
                     "', expected one of " + list);
  }
}

}  // namespace

void Row::only(std::initializer_list<std::string_view> known) const {
  refuse_others(file_, *table_, known);
}

void Row::fail(std::string_view key, const std::string& what) const {
  const toml::node* found = table_->get(key);
  const toml::source_region& source = found ? found->source() : table_->source();
  throw TableError(at(file_, source) + std::string(key) + ": " + what);
}

const toml::node& Row::node(std::string_view key) const {
  const toml::node* found = table_->get(key);
  if (!found) fail(key, "found nothing, expected a value");
  return *found;
}

const toml::array& Row::array(std::string_view key) const {
  const toml::array* found = node(key).as_array();
  if (!found) fail(key, "found " + kind_of(node(key)) + ", expected an array");
  return *found;
}

std::string Row::text(std::string_view key) const {
  const auto* found = node(key).as_string();
  if (!found) fail(key, "found " + kind_of(node(key)) + ", expected a text");
  return found->get();
}

std::int64_t Row::integer(std::string_view key) const {
  const auto* found = node(key).as_integer();
  if (!found) fail(key, "found " + kind_of(node(key)) + ", expected an integer");
  return found->get();
}

std::string Row::expression(std::string_view key) const {
  return node(key).is_integer() ? std::to_string(integer(key)) : text(key);
}

std::vector<std::string> Row::expressions(std::string_view key) const {
  std::vector<std::string> all;
  for (const toml::node& element : array(key)) {
    if (const auto* number = element.as_integer()) {
      all.push_back(std::to_string(number->get()));
    } else if (const auto* words = element.as_string()) {
      all.push_back(words->get());
    } else {
      fail(key, "found " + kind_of(element) + ", expected integers or expressions");
    }
  }
  return all;
}

std::vector<std::string> Row::texts(std::string_view key) const {
  std::vector<std::string> all;
  for (const toml::node& element : array(key)) {
    const auto* words = element.as_string();
    if (!words) fail(key, "found " + kind_of(element) + ", expected texts");
    all.push_back(words->get());
  }
  return all;
}

std::vector<std::int64_t> Row::integers(std::string_view key) const {
  std::vector<std::int64_t> all;
  for (const toml::node& element : array(key)) {
    const auto* number = element.as_integer();
    if (!number) fail(key, "found " + kind_of(element) + ", expected integers");
    all.push_back(number->get());
  }
  return all;
}

Row Row::table(std::string_view key) const {
  const toml::table* found = node(key).as_table();
  if (!found) fail(key, "found " + kind_of(node(key)) + ", expected a table");
  return {file_, *found};
}

std::vector<std::string> Row::keys() const {
  // toml++ keeps keys sorted, so that their places in the file say their order.
  std::vector<std::pair<toml::source_position, std::string>> places;
  for (const auto& [key, node] : *table_) places.emplace_back(key.source().begin, key.str());
  std::sort(places.begin(), places.end(),
            [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<std::string> all;
  for (auto& [place, name] : places) all.push_back(std::move(name));
  return all;
}

std::vector<Row> Row::rows(std::string_view key) const {
  std::vector<Row> all;
  if (!has(key)) return all;
  for (const toml::node& element : array(key)) {
    const toml::table* found = element.as_table();
    if (!found) fail(key, "found " + kind_of(element) + ", expected tables");
    all.emplace_back(file_, *found);
  }
  return all;
}

std::string Row::text_or(std::string_view key, std::string_view otherwise) const {
  return has(key) ? text(key) : std::string(otherwise);
}

std::int64_t Row::integer_or(std::string_view key, std::int64_t otherwise) const {
  return has(key) ? integer(key) : otherwise;
}

bool Row::flag_or(std::string_view key, bool otherwise) const {
  if (!has(key)) return otherwise;
  const auto* found = node(key).as_boolean();
  if (!found) fail(key, "found " + kind_of(node(key)) + ", expected true or false");
  return found->get();
}

TableFile::TableFile(const std::filesystem::path& path) : name_(path.filename().string()) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw TableError(path.string() + ": cannot be read");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  try {
    root_ = toml::parse(text, name_);
  } catch (const toml::parse_error& error) {
    throw TableError(at(name_, error.source()) + std::string(error.description()));
  }
}

void TableFile::only(std::initializer_list<std::string_view> known) const {
  refuse_others(name_, root_, known);
}

std::vector<Row> TableFile::rows(std::string_view name) const {
  std::vector<Row> all;
  const toml::node* found = root_.get(name);
  if (!found) return all;
  const toml::array* array = found->as_array();
  if (!array) {
    throw TableError(at(name_, found->source()) + std::string(name) + ": found " + kind_of(*found) +
                     ", expected tables [[" + std::string(name) + "]]");
  }
  for (const toml::node& element : *array) {
    const toml::table* table = element.as_table();
    if (!table) {
      throw TableError(at(name_, element.source()) + std::string(name) + ": found " +
                       kind_of(element) + ", expected a table");
    }
    all.emplace_back(name_, *table);
  }
  return all;
}

}  // namespace ptm::contract
