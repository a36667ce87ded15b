#pragma once
#include <toml++/toml.h>

#include <array>
#include <filesystem>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "golden/files/input_error.h"
#include "golden/scene/shape.h"

namespace ptm::golden {

/// The file as a table; `what` names the kind of file that is expected. Throws InputError with line
/// and column.
[[nodiscard]] toml::table parse_toml(const std::filesystem::path& path,
                                     const std::string& what = "a scene in TOML");

/// Reads nodes; every error is an InputError that names the file, the line and the key.
class Reader {
 public:
  explicit Reader(std::string file) : file_(std::move(file)) {}

  /// "line 12 (light[0].direction)"
  [[nodiscard]] static std::string place(const toml::node& node, const std::string& key);
  /// "an integer", "a table"
  [[nodiscard]] static std::string kind_of(const toml::node& node);
  [[noreturn]] void fail(const toml::node& node, const std::string& key, const std::string& found,
                         const std::string& expected) const;
  /// Refuses keys that are not among `known`.
  void only(const toml::table& table, const std::string& prefix,
            std::span<const std::string_view> known) const;
  void only(const toml::table& table, const std::string& prefix,
            std::initializer_list<std::string_view> known) const {
    only(table, prefix, std::span(known.begin(), known.size()));
  }

  [[nodiscard]] const toml::table& table(const toml::node& node, const std::string& key) const;
  [[nodiscard]] const toml::array& array(const toml::node& node, const std::string& key) const;
  /// An array of `count` elements.
  [[nodiscard]] const toml::array& array(const toml::node& node, const std::string& key,
                                         std::size_t count) const;
  [[nodiscard]] std::string text(const toml::node& node, const std::string& key) const;
  [[nodiscard]] bool flag(const toml::node& node, const std::string& key) const;
  [[nodiscard]] std::int64_t integer(const toml::node& node, const std::string& key,
                                     std::int64_t low, std::int64_t high) const;
  /// Finite.
  [[nodiscard]] double number(const toml::node& node, const std::string& key) const;

 private:
  std::string file_;
};

template <class Value>
using Choices = std::span<const std::pair<std::string_view, Value>>;

/// A table whose keys may be absent: then the value handed in stays. `prefix` is what the keys'
/// names begin with in errors: "object[1].".
class TableReader {
 public:
  TableReader(const Reader& reader, const toml::table& table, std::string prefix)
      : reader_(&reader), table_(&table), prefix_(std::move(prefix)) {}

  [[nodiscard]] bool has(std::string_view key) const { return table_->contains(key); }
  [[nodiscard]] const toml::node* find(std::string_view key) const { return table_->get(key); }
  /// A key's full name; of no key, the table's.
  [[nodiscard]] std::string name(std::string_view key) const;
  /// About a key, or about the table if the key is absent.
  [[nodiscard]] std::string place(std::string_view key) const;
  [[noreturn]] void fail(std::string_view key, const std::string& found,
                         const std::string& expected) const;
  void only(std::span<const std::string_view> known) const {
    reader_->only(*table_, prefix_, known);
  }
  void only(std::initializer_list<std::string_view> known) const {
    reader_->only(*table_, prefix_, known);
  }

  void read(std::string_view key, std::string& value) const;
  void read(std::string_view key, bool& value) const;
  void read(std::string_view key, int& value, int low, int high) const;
  void read(std::string_view key, std::uint64_t& value) const;  ///< 0..2^63 - 1
  void read(std::string_view key, double& value, double low, double high) const;
  void read(std::string_view key, std::span<double> values, double low, double high) const;
  void read(std::string_view key, Vec3& value) const;  ///< each within +-1e9
  /// One of the names; the value that goes with it.
  template <class Value>
  void choose(std::string_view key, Value& value, Choices<Value> choices) const {
    const toml::node* node = find(key);
    if (!node) return;
    const std::string found = reader_->text(*node, name(key));
    std::string names;
    for (const auto& [choice, meaning] : choices) {
      if (choice == found) {
        value = meaning;
        return;
      }
      names += (names.empty() ? "" : ", ") + std::string(choice);
    }
    fail(key, "'" + found + "'", "one of " + names);
  }
  /// Calls f(key, where it stands, value) for each key, in the order of names.
  template <class F>
  void each(F&& f) const {
    for (const auto& [key, node] : *table_) f(key.str(), key.source(), node);
  }
  /// A table within this one.
  [[nodiscard]] TableReader table(std::string_view key) const;
  [[nodiscard]] const Reader& reader() const { return *reader_; }

 private:
  const Reader* reader_;
  const toml::table* table_;
  std::string prefix_;
};

}  // namespace ptm::golden
