#include "contract/generator/emit_registers.h"
#include "contract/generator/names.h"
#include "contract/generator/text.h"

namespace ptm::contract {
namespace {

void header(const PortTables& tables, Outputs& outputs) {
  std::vector<std::string> enumerators, quoted, needs;
  for (const Counter& counter : tables.counters.all) {
    enumerators.push_back(counter.name);
    quoted.push_back("\"" + counter.name + "\"");
    if (!counter.need.empty()) {
      needs.push_back("(" + tables.parameter(counter.need).cpp +
                      " || counter != UnitCounter::" + counter.name + ")");
    }
  }
  Text out;
  out.line("// Written by contract/generator from contract/counters.toml.").line("#pragma once");
  out.line("#include <array>").line("#include <cstddef>").line("#include <cstdint>");
  out.line("#include <string_view>").line();
  out.line("namespace ptm::contract {").line();
  out.line("/// Counter numbers of docs/spec/unit-timing.md; the registers' order.");
  out.line("enum class UnitCounter : std::uint8_t {").list("  ", enumerators, "").line("};");
  out.line("inline constexpr std::size_t kUnitCounters = " +
           std::to_string(tables.counters.all.size()) + ";");
  out.line("inline constexpr std::array<std::string_view, kUnitCounters> kUnitCounterNames{");
  out.list("    ", quoted, "};").line();
  out.line("/// Whether a unit that has counters has that one.");
  out.line("template <class UnitConfig>");
  out.line("constexpr bool built_counter([[maybe_unused]] const UnitConfig& unit,");
  out.line("                             [[maybe_unused]] UnitCounter counter) {");
  out.line("  return " + (needs.empty() ? "true" : joined(needs, " &&\n         ")) + ";");
  out.line("}").line();
  std::vector<std::string> spared;
  for (const Counter& counter : tables.counters.all) {
    if (counter.spared) spared.push_back("counter == UnitCounter::" + counter.name);
  }
  out.line("/// Whether the report leaves the counter out where it is 0.");
  out.line("constexpr bool spared_counter([[maybe_unused]] UnitCounter counter) {");
  out.line("  return " + (spared.empty() ? "false" : joined(spared, " || ")) + ";");
  out.line("}").line().line("}  // namespace ptm::contract");
  outputs.push_back({Output::Kind::build, "counters.h", out.str(), {}});
}

void page(const PortTables& tables, Outputs& outputs) {
  Text out;
  out.line("| n | name | counts |").line("|---|---|---|");
  for (const CounterRow& row : tables.counters.rows) {
    std::string number = std::to_string(row.number);
    for (const Repeat& repeat : row.repeats) {
      number += " + " + std::to_string(repeat.stride) + " " + repeat.index;
    }
    std::string says = row.meaning;
    if (!row.page.empty()) says += ": `" + row.page + "`";
    if (!row.need.empty()) says += "; needs `" + tables.parameter(row.need).rtl + "`";
    out.line("| " + number + " | `" + row.name + "` | " + says + " |");
  }
  outputs.push_back({Output::Kind::block, "docs/spec/unit-timing.md", out.str(), "counters"});
}

/// Names that the report of a unit with all counters has, and how many there may be.
void schema(const PortTables& tables, Outputs& outputs) {
  std::vector<std::string> names;
  for (const Counter& counter : tables.counters.all) {
    if (counter.need.empty() && !counter.spared) names.push_back("\"" + counter.name + "\"");
  }
  Text out;
  out.line("          \"maxProperties\": " + std::to_string(tables.counters.all.size()) + ",");
  out.line("          \"required\": [").list("            ", names, "").line("          ],");
  outputs.push_back({Output::Kind::block, "docs/spec/report.schema.json", out.str(), "counters"});
}

}  // namespace

void emit_counters(const PortTables& tables, Outputs& outputs) {
  header(tables, outputs);
  page(tables, outputs);
  schema(tables, outputs);
}

}  // namespace ptm::contract
