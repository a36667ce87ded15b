// SystemVerilog: lists and maps of parameters to be included, and the modules that check them.
#include <algorithm>
#include <array>
#include <cctype>

#include "contract/generator/emit.h"
#include "contract/generator/text.h"

namespace ptm::contract {
namespace {

using Kind = Parameter::Kind;
using List = std::vector<const Parameter*>;

const char* const kNote =
    "// Written by scripts/contract from contract/parameters.toml; change it there.";

bool is_number(const std::string& text) {
  return std::all_of(text.begin(), text.end(), [](char c) { return c == '-' || std::isdigit(c); });
}

/// The range as a comment says it, in the RTL's names.
std::string range_words(const Config& config, const Parameter& p) {
  const auto rtl = [&](const std::string& text) {
    return with_names(text, [&](const std::string& name) { return config.find(name)->rtl; });
  };
  if (p.kind == Kind::flag) return p.needs.empty() ? "0, 1" : "0, 1; needs " + rtl(p.needs);
  if (p.kind == Kind::mask) return "a mask";
  std::vector<std::string> words;
  for (std::size_t i = 0; i < p.choices.size(); ++i) {
    words.push_back(std::to_string(i) + ": " + p.choices[i]);
  }
  for (const std::int64_t value : p.values) words.push_back(std::to_string(value));
  if (!words.empty()) return joined(words);
  return rtl(p.low) + ".." + rtl(p.most.empty() ? p.high : p.most);
}

/// "parameter int CoefBits = 8,  // stored coefficient, unsigned; 4..12"
std::string parameter_list(const Parameters& all, const List& list) {
  std::size_t longest = 0;
  for (const Parameter* p : list) longest = std::max(longest, p->rtl.size());
  Text text;
  text.line(kNote);
  for (std::size_t i = 0; i < list.size(); ++i) {
    const Parameter& p = *list[i];
    const Config& config = all.config(all.config("evaluator").find(p.name) ? "evaluator" : "unit");
    text.comment("  // ", p.meaning + "; " + range_words(config, p));
    text.line("  parameter int " + padded(p.rtl, longest) + " = " + std::to_string(p.value) +
              (i + 1 < list.size() ? "," : ""));
  }
  return text.str();
}

/// ".CoefBits(CoefBits), ..."
std::string parameter_map(const List& list) {
  std::vector<std::string> parts;
  for (const Parameter* p : list) parts.push_back("." + p->rtl + "(" + p->rtl + ")");
  Text text;
  text.line(kNote);
  text.list("    ", parts, "");
  return text.str();
}

/// Items of a case statement by which a test bench shows its parameters, from 128 on.
std::string probe_cases(const List& list) {
  Text text;
  text.line(kNote);
  for (std::size_t i = 0; i < list.size(); ++i) {
    text.line("        8'd" + std::to_string(128 + i) + ": probe_o = ProbeW'(" + list[i]->rtl +
              ");");
  }
  return text.str();
}

// The modules that check parameters

/// A bound within a module's name: "minus_8", "twice_LightFrac", "4_times_Tmus".
std::string bound_name(const Config& config, const std::string& bound) {
  if (is_number(bound)) return bound[0] == '-' ? "minus_" + bound.substr(1) : bound;
  std::string name = with_names(bound, [&](const std::string& n) { return config.find(n)->rtl; });
  if (name.rfind("2 * ", 0) == 0) name = "twice_" + name.substr(4);
  for (std::size_t at; (at = name.find(" * ")) != std::string::npos;) {
    name.replace(at, 3, "_times_");
  }
  std::replace_if(
      name.begin(), name.end(), [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); },
      '_');
  return name;
}

struct Requirement {
  std::string fault, condition;
};

std::string either(const std::string& name, const std::vector<std::string>& values) {
  std::vector<std::string> parts;
  for (const std::string& value : values) parts.push_back(name + " == " + value);
  return joined(parts, " || ");
}

/// "1_2_or_4"
std::string or_name(const std::vector<std::string>& values) {
  std::string name = values.front();
  for (std::size_t i = 1; i < values.size(); ++i) {
    name += (i + 1 == values.size() ? "_or_" : "_") + values[i];
  }
  return name;
}

void add_values(const Parameter& p, const std::vector<std::string>& values,
                std::vector<Requirement>& list) {
  list.push_back({p.rtl + "_not_" + or_name(values), either(p.rtl, values)});
}

std::vector<Requirement> requirements_of(const Config& config, const Parameter& p) {
  const auto rtl = [&](const std::string& text) {
    return with_names(text, [&](const std::string& name) { return config.find(name)->rtl; });
  };
  std::vector<Requirement> list;
  if (p.kind == Kind::flag || p.kind == Kind::choice) {
    std::vector<std::string> values{"0", "1"};
    for (std::size_t i = 2; i < p.choices.size(); ++i) values.push_back(std::to_string(i));
    add_values(p, values, list);
    if (!p.needs.empty()) {
      const std::string needs = rtl(p.needs);
      list.push_back({p.rtl + "_without_" + needs, p.rtl + " == 0 || " + needs + " != 0"});
    }
  } else if (p.kind == Kind::mask) {
    list.push_back({p.rtl + "_not_a_mask_of_8_bits", p.rtl + " >= 0 && " + p.rtl + " <= 255"});
  } else if (!p.values.empty()) {
    std::vector<std::string> values;
    for (const std::int64_t value : p.values) values.push_back(std::to_string(value));
    add_values(p, values, list);
  } else {
    const std::string most = p.most.empty() ? p.high : p.most;
    list.push_back({p.rtl + "_not_" + bound_name(config, p.low) + "_to_" + bound_name(config, most),
                    p.rtl + " >= " + rtl(p.low) + " && " + p.rtl + " <= " + rtl(p.high) +
                        (p.most.empty() ? "" : " && " + p.rtl + " <= " + rtl(p.most))});
  }
  if (!p.rule.empty()) list.push_back({p.rtl + "_breaks_its_rule", rtl(p.rule)});
  return list;
}

void write_requirement(const Requirement& requirement, Text& text) {
  const std::string head = "  `PTM_REQUIRE(ptm_illegal_" + requirement.fault + ",";
  const std::string line = head + " " + requirement.condition + ")";
  if (line.size() <= kColumns) {
    text.line(line);
    return;
  }
  text.line(head);
  const auto parts = wrapped(requirement.condition + ")", kColumns - 15);
  for (const std::string& part : parts) text.line("               " + part);
}

std::string evaluator_module(const Parameters& all) {
  const Config& config = all.config("evaluator");
  Text text;
  text.line(
      "// What the parameters of ptm_evaluator may be: docs/spec/datapath.md, Parameters. Nothing "
      "else.");
  text.line("//");
  text.line(
      "// A module of its own, so that a tool which does not read the unit (Icarus Verilog 11) can "
      "be asked");
  text.line("// too.");
  text.line(kNote);
  text.line("`include \"ptm_assert.svh\"");
  text.line("module ptm_evaluator_parameters #(");
  text.line("`include \"contract/ptm_evaluator_parameters.svh\"");
  text.line("  ,");
  text.line("  parameter int Assemble     = 1,");
  text.line("  parameter int SidebandBits = 32");
  text.line(") ();");
  for (const Parameter* p : config.checked()) {
    for (const Requirement& r : requirements_of(config, *p)) write_requirement(r, text);
  }
  write_requirement({"Assemble_not_0_or_1", "Assemble == 0 || Assemble == 1"}, text);
  write_requirement({"SidebandBits_not_1_or_more", "SidebandBits >= 1"}, text);
  text.line("endmodule");
  return text.str();
}

std::string unit_module(const Parameters& all) {
  const Config& config = all.config("unit");
  Text text;
  text.line(
      "// What the parameters of ptm_unit may be: docs/spec/unit-timing.md, Parameters. Nothing "
      "else. Of");
  text.line("// Stages, ptm_effect_chain refuses those that the build has not.");
  text.line("//");
  text.line(kNote);
  text.line("`include \"ptm_assert.svh\"");
  text.line("module ptm_unit_parameters #(");
  text.line("`include \"contract/ptm_unit_parameters.svh\"");
  text.line(") ();");
  text.line("  ptm_evaluator_parameters #(");
  text.line("`include \"contract/ptm_evaluator_map.svh\"");
  text.line("  ) u_evaluator ();");
  text.line();
  for (const Parameter* p : config.checked()) {
    for (const Requirement& r : requirements_of(config, *p)) write_requirement(r, text);
  }
  text.line("endmodule");
  return text.str();
}

}  // namespace

void emit_sv_parameters(const Parameters& parameters, Outputs& outputs) {
  List evaluator, back, front;
  for (const Parameter& p : parameters.config("evaluator").parameters) {
    evaluator.push_back(&p);
    if (p.in("front")) front.push_back(&p);
  }
  const List unit = parameters.of_rtl();
  back = evaluator;
  for (const Parameter& p : parameters.config("unit").parameters) {
    if (p.in("back")) back.push_back(&p);
    if (p.in("front")) front.push_back(&p);
  }
  const auto put = [&](const std::string& name, std::string text) {
    outputs.push_back({Output::Kind::committed, "rtl/contract/" + name, std::move(text)});
  };
  put("ptm_evaluator_parameters.svh", parameter_list(parameters, evaluator));
  put("ptm_evaluator_map.svh", parameter_map(evaluator));
  put("ptm_evaluator_probe.svh", probe_cases(evaluator));
  put("ptm_unit_parameters.svh", parameter_list(parameters, unit));
  put("ptm_unit_map.svh", parameter_map(unit));
  put("ptm_unit_probe.svh", probe_cases(unit));
  put("ptm_unit_back_parameters.svh", parameter_list(parameters, back));
  put("ptm_unit_back_map.svh", parameter_map(back));
  put("ptm_unit_front_parameters.svh", parameter_list(parameters, front));
  put("ptm_unit_front_map.svh", parameter_map(front));
  put("ptm_evaluator_parameters.sv", evaluator_module(parameters));
  put("ptm_unit_parameters.sv", unit_module(parameters));
}

}  // namespace ptm::contract
