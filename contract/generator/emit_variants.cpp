// Presets and verilated variants, for CMake, scripts and C++.
#include "contract/generator/emit.h"
#include "contract/generator/text.h"

namespace ptm::contract {
namespace {

using Kind = Parameter::Kind;

/// "Name=value"
std::string setting(const Parameter& parameter, std::int64_t value) {
  return parameter.rtl + "=" + std::to_string(value);
}

/// A line a preset.
std::string presets_text(const Parameters& parameters) {
  Text text;
  text.line(
      "# Parameters of ptm_evaluator, by preset (docs/spec/datapath.md). Read by "
      "scripts/synthesize.");
  text.line("# Written by scripts/contract from contract/parameters.toml; change it there.");
  for (const std::string& preset : parameters.presets) {
    std::string row = preset;
    for (const Parameter& parameter : parameters.config("evaluator").parameters) {
      row += ' ' + setting(parameter, parameter.in_preset(preset));
    }
    text.line(row);
  }
  return text.str();
}

/// A line a variant, with what differs from the RTL's own defaults.
std::string variants_text(const Parameters& parameters) {
  Text text;
  text.line(
      "# RTL that is verilated with the build; a mask of stages is cut down to those of the "
      "build.");
  text.line(
      "# Read by testbench/rtl/CMakeLists.txt, and what is of the kind netlist by "
      "scripts/synthesize.");
  text.line("# Written by scripts/contract from contract/variants.toml; change it there.");
  text.line("# kind name program|tests assert|plain parameters");
  for (const Variant& variant : parameters.variants) {
    std::string row = variant.kind + " " + variant.name +
                      (variant.program ? " program" : " tests") +
                      (variant.asserts ? " assert" : " plain");
    for (const Parameter* parameter : parameters.of_rtl()) {
      const std::int64_t value = variant.value(*parameter);
      // A script that makes a netlist checks names against the whole list.
      if (variant.kind == "netlist" || value != parameter->value)
        row += ' ' + setting(*parameter, value);
    }
    text.line(row);
  }
  return text.str();
}

std::string initializer(const Config& config, const Variant& variant) {
  std::vector<std::string> members;
  for (const Parameter& p : config.parameters) {
    const std::int64_t value = variant.value(p);
    std::string text = p.word(value);
    if (p.kind == Kind::choice) text.insert(0, "reference::" + p.type + "::");
    if (p.kind == Kind::mask) text = "reference::effects::kStages & " + text + "U";
    members.push_back("." + p.name + " = " + text);
  }
  Text text;
  text.list("    ", members, "};");
  return text.str();
}

/// X(name) of every variant of a kind.
void write_list(const Parameters& parameters, const std::string& macro, const std::string& kind,
                bool program, Text& text) {
  std::string row = "#define " + macro + "(X)";
  for (const Variant& variant : parameters.variants) {
    if (variant.kind == kind && variant.program == program) row += " X(" + variant.name + ")";
  }
  text.line(row);
}

std::string header_text(const Parameters& parameters) {
  Text text;
  text.line("// Written by contract/generator from contract/variants.toml.");
  text.line("#pragma once");
  text.line("#include \"model/reference/effects/stages.h\"");
  text.line("#include \"model/reference/unit/unit_config.h\"").line();
  text.line("// X(name) of each: what the program links, and what tests link besides");
  write_list(parameters, "PTM_RTL_EVALUATORS", "evaluator", true, text);
  write_list(parameters, "PTM_RTL_TEST_EVALUATORS", "evaluator", false, text);
  write_list(parameters, "PTM_RTL_UNITS", "unit", true, text);
  write_list(parameters, "PTM_RTL_TEST_UNITS", "unit", false, text);
  text.line();
  text.line("/// The parameters of each: <kind>_<name>_evaluator, <kind>_<name>_unit.");
  text.line("namespace ptm::testbench::variants {").line();
  for (const Variant& variant : parameters.variants) {
    if (variant.kind == "netlist") continue;
    const std::string name = variant.kind + "_" + variant.name;
    if (!variant.meaning.empty()) text.comment("/// ", variant.meaning);
    text.line("inline constexpr reference::EvalConfig " + name + "_evaluator{");
    text.lines(initializer(parameters.config("evaluator"), variant));
    if (variant.kind == "evaluator") continue;
    text.line("inline constexpr reference::UnitConfig " + name + "_unit{");
    text.lines(initializer(parameters.config("unit"), variant));
  }
  text.line().line("}  // namespace ptm::testbench::variants");
  return text.str();
}

}  // namespace

void emit_variants(const Parameters& parameters, Outputs& outputs) {
  outputs.push_back({Output::Kind::committed, "rtl/presets.txt", presets_text(parameters)});
  outputs.push_back(
      {Output::Kind::committed, "testbench/rtl/variants.txt", variants_text(parameters)});
  outputs.push_back({Output::Kind::build, "rtl_variants.h", header_text(parameters)});
}

}  // namespace ptm::contract
