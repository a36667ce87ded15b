#include "contract/generator/parameters.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include "contract/generator/table.h"

namespace ptm::contract {
namespace {

bool begins_name(char c) { return std::isalpha(static_cast<unsigned char>(c)) || c == '_'; }
bool continues_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

Parameter::Kind kind_of(const Row& row) {
  constexpr std::array<std::pair<const char*, Parameter::Kind>, 6> kinds{
      {{"integer", Parameter::Kind::integer},
       {"flag", Parameter::Kind::flag},
       {"choice", Parameter::Kind::choice},
       {"mask", Parameter::Kind::mask},
       {"cycles", Parameter::Kind::cycles},
       {"number", Parameter::Kind::number}}};
  const std::string name = row.text_or("kind", "integer");
  for (const auto& [word, kind] : kinds) {
    if (name == word) return kind;
  }
  row.fail("kind", "found '" + name + "', expected integer, flag, choice, mask, cycles or number");
}

/// A value of a parameter as a table gives it.
std::int64_t read_value(const Row& row, std::string_view key, const Parameter& parameter) {
  if (parameter.kind == Parameter::Kind::flag) return row.flag_or(key, false) ? 1 : 0;
  if (parameter.kind != Parameter::Kind::choice) return row.integer(key);
  const std::string word = row.text(key);
  const auto found = std::find(parameter.choices.begin(), parameter.choices.end(), word);
  if (found == parameter.choices.end()) row.fail(key, "found '" + word + "', which is no choice");
  return found - parameter.choices.begin();
}

void read_range(const Row& row, Parameter& parameter) {
  using Kind = Parameter::Kind;
  const bool listed = row.has("values"), ranged = row.has("range");
  if (parameter.kind == Kind::flag || parameter.kind == Kind::choice ||
      parameter.kind == Kind::mask) {
    if (listed || ranged) row.fail("kind", "a parameter of this kind has neither values nor range");
    if (parameter.kind != Kind::choice) return;
    parameter.choices = row.texts("choices");
    parameter.type = row.text("enum");
    return;
  }
  if (listed == ranged) row.fail("name", "expected either values or range");
  if (listed) {
    parameter.values = row.integers("values");
    if (parameter.values.empty()) row.fail("values", "found none, expected at least one");
    return;
  }
  const std::vector<std::string> range = row.expressions("range");
  if (range.size() != 2) row.fail("range", "expected the least and the greatest value");
  parameter.low = range[0];
  parameter.high = range[1];
}

Parameter read_parameter(const Row& row, const std::vector<std::string>& presets) {
  row.only({"of", "name", "rtl", "kind", "range", "values", "choices", "enum", "most", "needs",
            "rule", "rule_says", "default", "presets", "unit", "meaning", "note", "modules"});
  Parameter parameter;
  parameter.name = row.text("name");
  parameter.rtl = row.text_or("rtl", "");
  parameter.kind = kind_of(row);
  read_range(row, parameter);
  parameter.most = row.text_or("most", "");
  parameter.needs = row.text_or("needs", "");
  parameter.rule = row.text_or("rule", "");
  parameter.rule_says = row.text_or("rule_says", "");
  if (parameter.rule.empty() != parameter.rule_says.empty()) {
    row.fail("rule", "a rule and what it says go together");
  }
  if (!parameter.needs.empty() && parameter.kind != Parameter::Kind::flag) {
    row.fail("needs", "only a flag has it");
  }
  if (!row.has("default")) row.fail("default", "found nothing, expected a value");
  parameter.value = read_value(row, "default", parameter);
  if (row.has("presets")) {
    const Row values = row.table("presets");
    for (const std::string& preset : values.keys()) {
      if (std::find(presets.begin(), presets.end(), preset) == presets.end()) {
        row.fail("presets", "found '" + preset + "', which is no [[preset]]");
      }
      parameter.presets[preset] = read_value(values, preset, parameter);
    }
  }
  parameter.unit = row.text_or("unit", "");
  parameter.meaning = row.text("meaning");
  parameter.note = row.text_or("note", "");
  if (row.has("modules")) parameter.modules = row.texts("modules");
  for (const std::string& module : parameter.modules) {
    if (module != "front" && module != "back") {
      row.fail("modules", "found '" + module + "', expected front or back");
    }
  }
  return parameter;
}

/// Expressions name parameters of their own config.
void check_names(const Row& row, const Config& config, const Parameter& parameter) {
  for (const auto& [key, expression] : {std::pair{"range", parameter.low},
                                        {"range", parameter.high},
                                        {"most", parameter.most},
                                        {"needs", parameter.needs},
                                        {"rule", parameter.rule}}) {
    (void)with_names(expression, [&, key = key](const std::string& name) {
      if (!config.find(name)) row.fail(key, "found '" + name + "', which is no parameter of these");
      return name;
    });
  }
}

void read_rows(const TableFile& file, Parameters& parameters) {
  for (const Row& row : file.rows("config")) {
    row.only({"name", "struct", "namespace", "header", "meaning"});
    parameters.configs.push_back({row.text("name"),
                                  row.text("struct"),
                                  row.text("namespace"),
                                  row.text("header"),
                                  row.text("meaning"),
                                  {}});
  }
  for (const Row& row : file.rows("preset")) {
    row.only({"name"});
    parameters.presets.push_back(row.text("name"));
  }
  std::vector<std::pair<Row, std::string>> rows;
  for (const Row& row : file.rows("parameter")) {
    const std::string of = row.text("of");
    const auto config = std::find_if(parameters.configs.begin(), parameters.configs.end(),
                                     [&](const Config& c) { return c.name == of; });
    if (config == parameters.configs.end()) row.fail("of", "found '" + of + "', no [[config]]");
    Parameter parameter = read_parameter(row, parameters.presets);
    if (config->find(parameter.name)) row.fail("name", "found '" + parameter.name + "' twice");
    config->parameters.push_back(std::move(parameter));
  }
  for (const Row& row : file.rows("parameter")) {
    const Config& config = parameters.config(row.text("of"));
    check_names(row, config, *config.find(row.text("name")));
  }
}

Variant read_variant(const Row& row, const Parameters& parameters) {
  row.only({"kind", "name", "preset", "set", "asserts", "program", "meaning"});
  Variant variant;
  variant.kind = row.text("kind");
  variant.name = row.text("name");
  variant.preset = row.text_or("preset", "base");
  variant.meaning = row.text_or("meaning", "");
  variant.asserts = row.flag_or("asserts", false);
  variant.program = row.flag_or("program", true);
  constexpr std::array<const char*, 4> kinds{"evaluator", "unit", "back", "netlist"};
  if (std::find(kinds.begin(), kinds.end(), variant.kind) == kinds.end()) {
    row.fail("kind", "found '" + variant.kind + "', expected evaluator, unit, back or netlist");
  }
  const auto& presets = parameters.presets;
  if (std::find(presets.begin(), presets.end(), variant.preset) == presets.end()) {
    row.fail("preset", "found '" + variant.preset + "', which is no [[preset]]");
  }
  if (!row.has("set")) return variant;
  const Row set = row.table("set");
  for (const std::string& name : set.keys()) {
    const Parameter* parameter = parameters.config("evaluator").find(name);
    if (!parameter && variant.kind != "evaluator") parameter = parameters.config("unit").find(name);
    if (!parameter) set.fail(name, "is no parameter of such a variant");
    variant.set[name] = read_value(set, name, *parameter);
  }
  return variant;
}

}  // namespace

bool Parameter::in(std::string_view module) const {
  return std::find(modules.begin(), modules.end(), module) != modules.end();
}

std::vector<std::string> Parameter::names() const {
  std::vector<std::string> all;
  for (const std::string& expression : {low, high, most, needs, rule}) {
    (void)with_names(expression, [&](const std::string& found) {
      if (found != name) all.push_back(found);
      return found;
    });
  }
  return all;
}

std::int64_t Parameter::in_preset(const std::string& preset) const {
  const auto found = presets.find(preset);
  return found == presets.end() ? value : found->second;
}

std::string Parameter::word(std::int64_t number) const {
  if (kind == Kind::flag) return number != 0 ? "true" : "false";
  if (kind == Kind::choice) return choices[static_cast<std::size_t>(number)];
  return std::to_string(number);
}

const Parameter* Config::find(std::string_view wanted) const {
  const auto found = std::find_if(parameters.begin(), parameters.end(),
                                  [&](const Parameter& p) { return p.name == wanted; });
  return found == parameters.end() ? nullptr : &*found;
}

std::vector<const Parameter*> Config::checked() const {
  std::vector<const Parameter*> order;
  const auto placed = [&](const std::string& wanted) {
    return std::any_of(order.begin(), order.end(),
                       [&](const Parameter* p) { return p->name == wanted; });
  };
  while (order.size() < parameters.size()) {
    const auto next = std::find_if(parameters.begin(), parameters.end(), [&](const Parameter& p) {
      const std::vector<std::string> named = p.names();
      return !placed(p.name) && std::all_of(named.begin(), named.end(), placed);
    });
    if (next == parameters.end()) {
      throw TableError("parameters.toml: ranges of " + name + " lead back to themselves");
    }
    order.push_back(&*next);
  }
  return order;
}

std::int64_t Variant::value(const Parameter& parameter) const {
  const auto found = set.find(parameter.name);
  return found == set.end() ? parameter.in_preset(preset) : found->second;
}

const Config& Parameters::config(std::string_view name) const {
  const auto found =
      std::find_if(configs.begin(), configs.end(), [&](const Config& c) { return c.name == name; });
  if (found == configs.end()) {
    throw TableError("parameters.toml: found no [[config]] of the name " + std::string(name));
  }
  return *found;
}

std::vector<const Parameter*> Parameters::of_rtl() const {
  std::vector<const Parameter*> all;
  for (const char* name : {"evaluator", "unit"}) {
    for (const Parameter& parameter : config(name).parameters) all.push_back(&parameter);
  }
  return all;
}

Parameters read_parameters(const std::filesystem::path& folder) {
  Parameters parameters;
  const TableFile file(folder / "parameters.toml");
  file.only({"config", "preset", "parameter"});
  read_rows(file, parameters);
  const TableFile variants(folder / "variants.toml");
  variants.only({"variant"});
  for (const Row& row : variants.rows("variant")) {
    parameters.variants.push_back(read_variant(row, parameters));
  }
  return parameters;
}

std::string with_names(std::string_view expression,
                       const std::function<std::string(const std::string&)>& replace) {
  std::string result;
  for (std::size_t i = 0; i < expression.size();) {
    if (!begins_name(expression[i])) {
      result += expression[i++];
      continue;
    }
    std::size_t end = i;
    while (end < expression.size() && continues_name(expression[end])) ++end;
    result += replace(std::string(expression.substr(i, end - i)));
    i = end;
  }
  return result;
}

}  // namespace ptm::contract
