#include "testbench/report/html_made_by.h"

#include "testbench/report/config_json.h"
#include "testbench/report/html_table.h"
#include "testbench/report/html_text.h"

namespace ptm::testbench::html {
namespace {

using Json = nlohmann::ordered_json;

void add_fact(std::string& page, const std::string& name, const std::string& value) {
  page += "<dt>" + html_escape(name) + "</dt><dd>" + html_escape(value) + "</dd>\n";
}

std::string value_text(const Json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (!value.is_array()) return value.dump();
  std::string text;
  for (const Json& one : value) text += (text.empty() ? "" : ", ") + value_text(one);
  return text.empty() ? "none" : text;
}

std::string table_title(const std::string& name) {
  if (name == "evaluator") return "Evaluator";
  if (name == "unit") return "Unit";
  if (name == "effects") return "Parts for effects";
  if (name == "memory") return "Memory";
  if (name == "stress") return "Gaps and stalls";
  return "Frames";
}

std::string command_text(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) {
    const bool plain =
        !word.empty() && word.find_first_of(" \t\n'\"\\$&|;<>()*?[]#~`!{}") == std::string::npos;
    text += text.empty() ? "" : " ";
    if (plain) {
      text += word;
      continue;
    }
    text += '\'';
    for (const char c : word) {
      if (c == '\'') {
        text += "'\\''";
      } else {
        text += c;
      }
    }
    text += '\'';
  }
  return text;
}

void add_program(std::string& page, const MadeBy& made) {
  page += "<h3>Program and machine</h3>\n<dl class=\"facts\">\n";
  add_fact(page, "Program", program_text(made.invocation));
  add_fact(page, "Command", command_text(made.invocation.command));
  add_fact(page, "Date", made.date);
  add_fact(page, "Built with", made.compiler + "; " + made.verilator + "; SystemC " + made.systemc);
  add_fact(page, "Machine", made.cpu + ", " + plural(made.cores, "core"));
  add_fact(page, "System", made.system + ", " + made.kernel);
  page += "</dl>\n";
}

}  // namespace

void add_made_by(std::string& page, const RunResult& result) {
  open_section(page, "made_by", "What made it");
  const Json config = config_json(result.config);
  for (const auto& [name, table] : config.items()) {
    page += "<h3>" + table_title(name) + "</h3>\n<dl class=\"facts\">\n";
    for (const auto& [key, value] : table.items()) add_fact(page, key, value_text(value));
    page += "</dl>\n";
  }
  add_program(page, result.made_by);
  page += "</section>\n";
}

}  // namespace ptm::testbench::html
