// The structs of C++, a header and a source for each `header` of a [[config]].
#include <algorithm>
#include <cctype>

#include "contract/generator/emit.h"
#include "contract/generator/text.h"

namespace ptm::contract {
namespace {

using Kind = Parameter::Kind;

std::string capital(std::string word) {
  word[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(word[0])));
  return word;
}

std::string type_of(const Parameter& parameter) {
  switch (parameter.kind) {
    case Kind::flag:
      return "bool";
    case Kind::choice:
      return parameter.type;
    case Kind::mask:
      return "unsigned";
    case Kind::cycles:
    case Kind::number:
      return "std::uint64_t";
    case Kind::integer:
      break;
  }
  return "int";
}

/// A value as C++ writes it.
std::string literal(const Parameter& parameter, std::int64_t value) {
  return parameter.kind == Kind::choice ? parameter.type + "::" + parameter.word(value)
                                        : parameter.word(value);
}

/// The range as a comment says it.
std::string range_words(const Parameter& parameter) {
  if (parameter.kind == Kind::integer || parameter.kind == Kind::cycles) {
    if (!parameter.values.empty()) {
      std::vector<std::string> values;
      for (const std::int64_t value : parameter.values) values.push_back(std::to_string(value));
      return joined(values);
    }
    return parameter.low + ".." + (parameter.most.empty() ? parameter.high : parameter.most);
  }
  return parameter.needs.empty() ? "" : "needs " + parameter.needs;
}

void write_struct(const Config& config, Text& text) {
  for (const Parameter& parameter : config.parameters) {
    if (parameter.kind != Kind::choice) continue;
    text.line();
    text.comment("/// ", parameter.meaning);
    text.line("enum class " + parameter.type + " : std::uint8_t { " + joined(parameter.choices) +
              " };");
  }
  text.line();
  text.comment("/// ", config.meaning);
  text.line("struct " + config.type + " {");
  for (const Parameter& parameter : config.parameters) {
    const std::string range = range_words(parameter);
    text.comment("  /// ", parameter.meaning + (range.empty() ? "" : "; " + range));
    text.line("  " + type_of(parameter) + " " + parameter.name + " = " +
              literal(parameter, parameter.value) + ";");
  }
  text.line();
  text.line("  bool operator==(const " + config.type + "&) const = default;");
  text.line("};");
}

void write_presets(const Parameters& all, const Config& config, Text& text) {
  text.line();
  for (const std::string& preset : all.presets) {
    std::vector<std::string> members;
    for (const Parameter& parameter : config.parameters) {
      members.push_back("." + parameter.name + " = " +
                        literal(parameter, parameter.in_preset(preset)));
    }
    text.line("inline constexpr " + config.type + " k" + capital(preset) + "{");
    text.list("    ", members, "};");
  }
  text.line();
  text.line("struct Preset {");
  text.line("  std::string_view name;");
  text.line("  " + config.type + " config;");
  text.line("};");
  std::vector<std::string> rows;
  for (const std::string& preset : all.presets) {
    rows.push_back("{\"" + preset + "\", k" + capital(preset) + "}");
  }
  text.line("inline constexpr std::array<Preset, " + std::to_string(all.presets.size()) +
            "> kPresets{{");
  text.list("    ", rows, "}};");
}

void declare_table(const Config& config, Text& text) {
  const std::string type = config.space + "::" + config.type;
  text.line();
  text.line("template <>");
  text.line("struct ptm::reference::ParameterTable<" + type + "> {");
  text.line("  static constexpr std::size_t kCount = " + std::to_string(config.parameters.size()) +
            ";");
  text.line("  [[nodiscard]] static std::span<const ParameterRow> rows();");
  text.line("  [[nodiscard]] static std::int64_t get(const " + type +
            "& config, std::size_t index);");
  text.line("  static void set(" + type + "& config, std::size_t index, std::int64_t value);");
  text.line("  [[nodiscard]] static std::optional<ParameterFault> fault(const " + type +
            "& config);");
  text.line("};");
}

/// An expression of parameters in C++, all in 64 bits.
std::string expression(const std::string& text) {
  if (std::all_of(text.begin(), text.end(), [](char c) { return c == '-' || std::isdigit(c); })) {
    return "std::int64_t{" + text + "}";
  }
  return with_names(
      text, [](const std::string& name) { return "static_cast<std::int64_t>(c." + name + ")"; });
}

std::string check_of(const Parameter& p) {
  const std::string value = "whole(c." + p.name + ")";
  const std::string named = "\"" + p.name + "\", " + value + ", ";
  switch (p.kind) {
    case Kind::choice:
      return {};
    case Kind::mask:
      return "beyond_mask(" + named + "effects::kStages)";
    case Kind::flag:
      return p.needs.empty() ? ""
                             : "outside(" + named + "0, " + expression(p.needs) + " != 0 ? 1 : 0)";
    default:
      break;
  }
  if (!p.values.empty()) {
    std::vector<std::string> values;
    for (const std::int64_t v : p.values) values.push_back(std::to_string(v));
    return "not_among(" + named + "{" + joined(values) + "})";
  }
  const std::string high = p.most.empty()
                               ? expression(p.high)
                               : "std::min(" + expression(p.high) + ", " + expression(p.most) + ")";
  return "outside(" + named + expression(p.low) + ", " + high + ")";
}

void define_rows(const Config& config, Text& text) {
  for (const Parameter& p : config.parameters) {
    if (p.kind != Kind::choice) continue;
    std::vector<std::string> words;
    for (const std::string& choice : p.choices) words.push_back("\"" + choice + "\"");
    text.line("constexpr std::array<std::string_view, " + std::to_string(words.size()) + "> k" +
              p.type + "Words{" + joined(words) + "};");
  }
  text.line("constexpr std::array<ParameterRow, " + std::to_string(config.parameters.size()) +
            "> k" + config.type + "Rows{{");
  for (const Parameter& p : config.parameters) {
    const std::string kind = p.kind == Kind::flag     ? "flag"
                             : p.kind == Kind::choice ? "choice"
                                                      : "number";
    text.line("    {\"" + p.name + "\", \"" + p.rtl + "\", ParameterKind::" + kind + ", " +
              (p.kind == Kind::choice ? "k" + p.type + "Words" : "{}") + ", \"" + p.unit + "\",");
    text.line("     \"" + p.meaning + "\"},");
  }
  text.line("}};");
}

void define_table(const Config& config, Text& text) {
  const std::string type = config.space + "::" + config.type;
  const std::string table = "ParameterTable<" + type + ">::";
  text.line();
  text.line("namespace {");
  define_rows(config, text);
  text.line("}  // namespace");
  text.line();
  text.line("std::span<const ParameterRow> " + table + "rows() { return k" + config.type +
            "Rows; }");
  text.line();
  text.line("std::int64_t " + table + "get(const " + type + "& c, std::size_t index) {");
  text.line("  switch (index) {");
  for (std::size_t i = 0; i < config.parameters.size(); ++i) {
    text.line("    case " + std::to_string(i) + ":");
    text.line("      return static_cast<std::int64_t>(c." + config.parameters[i].name + ");");
  }
  text.line("    default:");
  text.line("      throw std::out_of_range(\"no such parameter of " + config.type + "\");");
  text.line("  }");
  text.line("}");
  text.line();
  text.line("void " + table + "set(" + type + "& c, std::size_t index, std::int64_t value) {");
  text.line("  switch (index) {");
  for (std::size_t i = 0; i < config.parameters.size(); ++i) {
    const Parameter& p = config.parameters[i];
    text.line("    case " + std::to_string(i) + ":");
    text.line("      c." + p.name + " = " +
              (p.kind == Kind::flag ? "value != 0" : "static_cast<" + type_of(p) + ">(value)") +
              ";");
    text.line("      break;");
  }
  text.line("    default:");
  text.line("      throw std::out_of_range(\"no such parameter of " + config.type + "\");");
  text.line("  }");
  text.line("}");
  text.line();
  text.line("std::optional<ParameterFault> " + table + "fault(const " + type + "& c) {");
  text.line("  const auto whole = [](auto value) { return static_cast<std::int64_t>(value); };");
  for (const Parameter* checked : config.checked()) {
    const Parameter& p = *checked;
    const std::string check = check_of(p);
    if (!check.empty()) text.line("  if (auto wrong = " + check + ") return wrong;");
    if (p.rule.empty()) continue;
    text.line("  if (auto wrong = breaks(\"" + p.name + "\", whole(c." + p.name + "),");
    text.line("                          " + expression(p.rule) + ",");
    text.line("                          \"" + p.rule_says + "\")) return wrong;");
  }
  text.line("  return {};");
  text.line("}");
}

const char* const kNote = "// Written by contract/generator from contract/parameters.toml.";

std::string header_text(const Parameters& all, const std::vector<const Config*>& configs) {
  Text text;
  text.line(kNote).line("#pragma once");
  for (const char* name : {"array", "cstddef", "cstdint", "optional", "span", "string_view"}) {
    text.line("#include <" + std::string(name) + ">");
  }
  text.line().line("#include \"model/reference/parameter.h\"").line();
  text.line("namespace " + configs.front()->space + " {");
  for (const Config* config : configs) {
    write_struct(*config, text);
    if (config->name == "evaluator") write_presets(all, *config, text);
  }
  text.line().line("}  // namespace " + configs.front()->space);
  for (const Config* config : configs) declare_table(*config, text);
  return text.str();
}

std::string source_text(const std::vector<const Config*>& configs) {
  Text text;
  text.line(kNote);
  text.line("#include \"contract/" + configs.front()->header + ".h\"").line();
  text.line("#include <algorithm>").line("#include <stdexcept>").line();
  for (const Config* config : configs) {
    const auto& rows = config->parameters;
    if (std::any_of(rows.begin(), rows.end(), [](const auto& p) { return p.kind == Kind::mask; })) {
      text.line("#include \"model/reference/effects/stages.h\"").line();
    }
  }
  text.line("namespace ptm::reference {");
  for (const Config* config : configs) define_table(*config, text);
  text.line().line("}  // namespace ptm::reference");
  return text.str();
}

}  // namespace

void emit_cpp_parameters(const Parameters& parameters, Outputs& outputs) {
  std::vector<std::string> headers;
  for (const Config& config : parameters.configs) {
    if (std::find(headers.begin(), headers.end(), config.header) == headers.end()) {
      headers.push_back(config.header);
    }
  }
  for (const std::string& header : headers) {
    std::vector<const Config*> configs;
    for (const Config& config : parameters.configs) {
      if (config.header == header) configs.push_back(&config);
    }
    outputs.push_back({Output::Kind::build, header + ".h", header_text(parameters, configs)});
    outputs.push_back({Output::Kind::build, header + ".cpp", source_text(configs)});
  }
}

}  // namespace ptm::contract
