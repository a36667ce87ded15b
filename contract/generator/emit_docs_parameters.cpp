// Tables of docs/spec.
#include <algorithm>
#include <cctype>

#include "contract/generator/emit.h"
#include "contract/generator/text.h"

namespace ptm::contract {
namespace {

using Kind = Parameter::Kind;

/// An expression with its names as code.
std::string coded(const std::string& expression) {
  return with_names(expression, [](const std::string& name) { return "`" + name + "`"; });
}

/// What it is, and more of it.
std::string meaning(const Parameter& p) {
  return p.note.empty() ? p.meaning : p.meaning + "; " + p.note;
}

std::string range_words(const Parameter& p) {
  if (p.kind == Kind::flag) {
    return p.needs.empty() ? "true, false" : "false; true if `" + p.needs + "` is not 0 or false";
  }
  if (p.kind == Kind::choice) return joined(p.choices);
  if (p.kind == Kind::mask) return "stages that the build has";
  std::string words;
  if (p.values.empty()) {
    words = p.kind == Kind::number && p.low == "0"
                ? "0 or more"
                : coded(p.low) + " to " + coded(p.most.empty() ? p.high : p.most);
  } else {
    std::vector<std::string> values;
    for (const std::int64_t value : p.values) values.push_back(std::to_string(value));
    words = joined(values);
  }
  return p.rule.empty() ? words : words + "; " + p.rule_says;
}

std::string evaluator_table(const Parameters& all) {
  Text text;
  std::string head = "| name | in SystemVerilog | meaning | unit |", rule = "|---|---|---|---|";
  for (const std::string& preset : all.presets) {
    head += " `" + preset + "` |";
    rule += "---|";
  }
  text.line(head + " range |").line(rule + "---|");
  for (const Parameter& p : all.config("evaluator").parameters) {
    std::string row =
        "| `" + p.name + "` | `" + p.rtl + "` | " + meaning(p) + " | " + p.unit + " |";
    for (const std::string& preset : all.presets) row += " " + p.word(p.in_preset(preset)) + " |";
    text.line(row + " " + range_words(p) + " |");
  }
  return text.str();
}

std::string unit_table(const Parameters& all) {
  Text text;
  text.line("| name | in SystemVerilog | meaning | unit | default | range |");
  text.line("|---|---|---|---|---|---|");
  for (const Parameter& p : all.config("unit").parameters) {
    text.line("| `" + p.name + "` | `" + p.rtl + "` | " + meaning(p) + " | " + p.unit + " | " +
              p.word(p.value) + " | " + range_words(p) + " |");
  }
  return text.str();
}

std::string memory_table(const Parameters& all) {
  Text text;
  text.line("| kind | key | meaning | unit | default | range |");
  text.line("|---|---|---|---|---|---|");
  for (const char* kind : {"fixed", "random", "dram"}) {
    for (const Parameter& p : all.config(kind).parameters) {
      text.line("| `\"" + std::string(kind) + "\"` | `" + p.name + "` | " + meaning(p) + " | " +
                p.unit + " | " + p.word(p.value) + " | " + range_words(p) + " |");
    }
  }
  return text.str();
}

}  // namespace

void emit_docs_parameters(const Parameters& parameters, Outputs& outputs) {
  const auto block = [&](const char* page, const char* name, std::string text) {
    outputs.push_back({Output::Kind::block, page, std::move(text), name});
  };
  block("docs/spec/datapath.md", "evaluator parameters", evaluator_table(parameters));
  block("docs/spec/unit-timing.md", "unit parameters", unit_table(parameters));
  block("docs/spec/scene.md", "memory parameters", memory_table(parameters));
}

}  // namespace ptm::contract
