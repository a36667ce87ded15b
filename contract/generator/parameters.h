#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

/// parameters.toml and variants.toml, read and checked.
namespace ptm::contract {

struct Parameter {
  enum class Kind { integer, flag, choice, mask, cycles, number };
  std::string name;
  std::string rtl;  ///< empty for a memory's
  Kind kind = Kind::integer;
  std::string low, high;             ///< expressions; empty if there is a list of values
  std::vector<std::int64_t> values;  ///< all there are
  std::vector<std::string> choices;  ///< words, each the integer of its place
  std::string type;                  ///< of the choices in C++
  std::string most, needs, rule, rule_says;
  std::int64_t value = 0;                       ///< the default
  std::map<std::string, std::int64_t> presets;  ///< where they differ from it
  std::string unit, meaning, note;
  std::vector<std::string> modules;

  [[nodiscard]] bool in(std::string_view module) const;
  /// The value in the preset.
  [[nodiscard]] std::int64_t in_preset(const std::string& preset) const;
  /// Names in its range, its needs and its rule.
  [[nodiscard]] std::vector<std::string> names() const;
  /// As people write it: a word of a choice, true or false of a flag.
  [[nodiscard]] std::string word(std::int64_t value) const;
};

/// A set of parameters: a struct of C++.
struct Config {
  std::string name, type, space, header, meaning;
  std::vector<Parameter> parameters;
  [[nodiscard]] const Parameter* find(std::string_view name) const;
  /// In the order in which they are checked: what a range names comes before it, so that of two
  /// that are wrong the cause is told.
  [[nodiscard]] std::vector<const Parameter*> checked() const;
};

/// RTL that is verilated with the build.
struct Variant {
  std::string kind, name, preset, meaning;
  std::map<std::string, std::int64_t> set;  ///< by parameter's name
  bool asserts = false, program = true;
  /// The parameter's value in it.
  [[nodiscard]] std::int64_t value(const Parameter& parameter) const;
};

struct Parameters {
  std::vector<Config> configs;
  std::vector<std::string> presets;
  std::vector<Variant> variants;
  [[nodiscard]] const Config& config(std::string_view name) const;
  /// Of the evaluator, then of the unit.
  [[nodiscard]] std::vector<const Parameter*> of_rtl() const;
};

/// Throws TableError.
[[nodiscard]] Parameters read_parameters(const std::filesystem::path& folder);

/// The expression with every name replaced.
[[nodiscard]] std::string with_names(std::string_view expression,
                                     const std::function<std::string(const std::string&)>& replace);

}  // namespace ptm::contract
