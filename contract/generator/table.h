#pragma once
#include <toml++/toml.h>

#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

/// Tables of the contract as TOML files. Whatever is wrong with one is a TableError that names the
/// file and the line.
namespace ptm::contract {

/// what(): "parameters.toml:12: guard: found a string, expected an integer"
class TableError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// One [[name]] of a file, or a table within one.
class Row {
 public:
  Row(std::string file, const toml::table& table) : file_(std::move(file)), table_(&table) {}

  [[nodiscard]] bool has(std::string_view key) const { return table_->contains(key); }
  /// Refuses keys that are not among these.
  void only(std::initializer_list<std::string_view> known) const;

  /// The key must be there.
  [[nodiscard]] std::string text(std::string_view key) const;
  [[nodiscard]] std::int64_t integer(std::string_view key) const;
  /// An integer or a text, as text: a number or an expression.
  [[nodiscard]] std::string expression(std::string_view key) const;
  [[nodiscard]] std::vector<std::string> expressions(std::string_view key) const;
  [[nodiscard]] std::vector<std::string> texts(std::string_view key) const;
  [[nodiscard]] std::vector<std::int64_t> integers(std::string_view key) const;
  /// A table within this one, and the names of its keys in the order of the file.
  [[nodiscard]] Row table(std::string_view key) const;
  [[nodiscard]] std::vector<std::string> keys() const;
  /// The tables of an array, [[row.key]] or inline, in the order of the file; none if it is absent.
  [[nodiscard]] std::vector<Row> rows(std::string_view key) const;

  /// The key may be absent.
  [[nodiscard]] std::string text_or(std::string_view key, std::string_view otherwise) const;
  [[nodiscard]] std::int64_t integer_or(std::string_view key, std::int64_t otherwise) const;
  [[nodiscard]] bool flag_or(std::string_view key, bool otherwise) const;

  /// About a key, or about the row if the key is absent.
  [[noreturn]] void fail(std::string_view key, const std::string& what) const;

 private:
  [[nodiscard]] const toml::node& node(std::string_view key) const;
  [[nodiscard]] const toml::array& array(std::string_view key) const;

  std::string file_;
  const toml::table* table_;
};

/// A file of tables.
class TableFile {
 public:
  /// Throws TableError.
  explicit TableFile(const std::filesystem::path& path);

  /// Refuses tables of other names.
  void only(std::initializer_list<std::string_view> known) const;
  /// The rows [[name]] in the order of the file; none if there is no such table.
  [[nodiscard]] std::vector<Row> rows(std::string_view name) const;

 private:
  std::string name_;
  toml::table root_;
};

}  // namespace ptm::contract
