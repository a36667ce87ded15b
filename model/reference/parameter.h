#pragma once
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

/// What programs ask of the rows of contract/parameters.toml: by name, as texts, within ranges.
///
/// A struct of parameters (EvalConfig, UnitConfig, the memories) has a ParameterTable, which is
/// generated with it. Values are integers here: a flag is 0 or 1, a word of a choice its place.
namespace ptm::reference {

enum class ParameterKind : std::uint8_t { number, flag, choice };

struct ParameterRow {
  std::string_view name;  ///< in C++, in TOML and on the command line
  std::string_view rtl;   ///< in SystemVerilog; empty of a memory's
  ParameterKind kind;
  std::span<const std::string_view> choices;  ///< words of a choice
  std::string_view unit, meaning;             ///< a part of a sentence
};

/// A value outside its range.
struct ParameterFault {
  std::string name, found, expected;
  /// "guard = 13, expected 0 to 12"
  [[nodiscard]] std::string text() const { return name + " = " + found + ", expected " + expected; }
};

/// Of the struct Config:
///   kCount                 how many parameters
///   rows()                 all, in the order of the members
///   get(config, index), set(config, index, value)
///   fault(config)          the first value outside its range, nothing if there is none
template <class Config>
struct ParameterTable;

/// A parameter as the RTL takes it: "CoefBits", 8.
struct NamedParameter {
  std::string_view name;
  std::int64_t value;
};

/// Where the parameter of that name stands in the table; nothing if there is none.
template <class Config>
[[nodiscard]] std::optional<std::size_t> find_parameter(std::string_view name) {
  const auto rows = ParameterTable<Config>::rows();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows[i].name == name) return i;
  }
  return {};
}

/// Throws std::invalid_argument naming the first parameter outside its range, its value and the
/// range.
template <class Config>
void validate_parameters(const Config& config) {
  if (const auto fault = ParameterTable<Config>::fault(config)) {
    throw std::invalid_argument(fault->text());
  }
}

/// As people write it, in TOML without quotes and on the command line: "8", "true", "nearest".
[[nodiscard]] std::string parameter_text(const ParameterRow& row, std::int64_t value);

/// The value that a text names; nothing if it is none of that kind. Every decimal number of 64 bits
/// is one, whatever the range.
[[nodiscard]] std::optional<std::int64_t> parse_parameter(const ParameterRow& row,
                                                          std::string_view text);

/// What a text should have been: "a whole number", "true or false", "one of truncate, nearest".
[[nodiscard]] std::string expected_text(const ParameterRow& row);

// For ParameterTable::fault(): each says what is wrong with a value, nothing if it is right.
[[nodiscard]] std::optional<ParameterFault> outside(std::string_view name, std::int64_t value,
                                                    std::int64_t low, std::int64_t high);
[[nodiscard]] std::optional<ParameterFault> not_among(std::string_view name, std::int64_t value,
                                                      std::initializer_list<std::int64_t> values);
/// A mask of stages with one that this build has not.
[[nodiscard]] std::optional<ParameterFault> beyond_mask(std::string_view name, std::int64_t value,
                                                        std::int64_t mask);
[[nodiscard]] std::optional<ParameterFault> breaks(std::string_view name, std::int64_t value,
                                                   bool holds, std::string_view expected);

}  // namespace ptm::reference
