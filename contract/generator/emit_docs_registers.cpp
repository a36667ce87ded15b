#include "contract/generator/emit_registers.h"
#include "contract/generator/names.h"
#include "contract/generator/text.h"

namespace ptm::contract {
namespace {

/// "`64 d + 4 + i`", "`0x1002`"
std::string address(const Block& block, const Register& r) {
  const bool low = block.address < 0x1000;
  std::vector<std::string> terms;
  if (!low) terms.push_back(hex(block.address + r.offset, 4));
  const auto add = [&](const Repeat& repeat) {
    terms.push_back(repeat.stride == 1 ? repeat.index
                                       : std::to_string(repeat.stride) + " " + repeat.index);
  };
  if (block.repeat) add(*block.repeat);
  if (low) terms.push_back(std::to_string(r.offset));
  for (const Repeat& repeat : r.repeats) add(repeat);
  return "`" + joined(terms, " + ") + "`";
}

std::string bits(const Field& field) {
  if (!field.repeat) return bit_range(field.low, field.width);
  const auto bit = [&field](unsigned low) {
    return std::to_string(field.repeat->stride) + " " + field.repeat->index +
           (low == 0 ? "" : " + " + std::to_string(low));
  };
  if (field.width == 1) return "[" + bit(field.low) + "]";
  return "[" + bit(field.low + field.width - 1) + ":" + bit(field.low) + "]";
}

std::string named(const Register& r) { return " | `" + r.full_name + "` | "; }

std::string access(const Register& r) {
  return upper(access_name(r.access)) + (r.shared ? ", shared" : "");
}

std::string indices(const Register& r) {
  std::string text;
  const auto add = [&text](const Repeat& repeat) {
    text += "; " + repeat.index + " = 0.." + std::to_string(repeat.count - 1);
  };
  for (const Repeat& repeat : r.repeats) add(repeat);
  return text;
}

std::string holds(const PortTables& tables, const Register& r) {
  std::vector<std::string> fields;
  for (const Field& field : r.fields) {
    std::string one = "`" + field.name + "` " + bits(field);
    if (field.built && field.built->kind == Built::Kind::parameter) {
      one = "`" + tables.parameter(field.built->name).rtl + "` " + bits(field);
    }
    if (field.is_signed) one += ", two's complement";
    std::string more = field.meaning;
    if (field.need) {
      std::string need = "needs `" + tables.parameter(field.need->parameter).rtl + "`";
      if (!field.need->index.empty()) {
        need += " above " + field.need->index;
      } else if (field.need->number != 0) {
        need += " above " + std::to_string(field.need->number);
      }
      more += more.empty() ? need : "; " + need;
    }
    if (field.shared) more += more.empty() ? "shared" : "; shared, the bit alone is refused";
    if (field.reset != 0)
      more = "`" + hex(field.reset, 1) + "`" + (more.empty() ? "" : ", " + more);
    if (!more.empty()) one += " (" + more + ")";
    fields.push_back(one);
  }
  return r.meaning + indices(r) + ": " + joined(fields);
}

void page(const PortTables& tables, const std::string& file, const std::string& block_name,
          Outputs& outputs) {
  Text out;
  out.line("| address | name | access | holds |").line("|---|---|---|---|");
  for (const Block& block : tables.map.blocks) {
    for (const Register& r : block.registers) {
      if (r.page == file && !r.capability && !r.bits) {
        out.line("| " + address(block, r) + named(r) + access(r) + " | " + holds(tables, r) + " |");
      } else if (r.page != file && file == "unit.md") {
        out.line("| " + address(block, r) + named(r) + access(r) + " | " + r.meaning + indices(r) +
                 ": [`" + r.page + "`](" + r.page + ") |");
      } else if (r.capability && r.page == file && &r == tables.map.capabilities().front()) {
        const Register& last = *tables.map.capabilities().back();
        out.line("| " + address(block, r) + " to " + address(block, last) + " | | " + access(r) +
                 " | capabilities, below |");
      } else if (r.page == file && r.bits) {
        out.line("| " + address(block, r) + named(r) + access(r) + " | " + r.meaning + ", below |");
      }
    }
  }
  outputs.push_back({Output::Kind::block, "docs/spec/" + file, out.str(), block_name});
}

void events(const PortTables& tables, Outputs& outputs) {
  Text out;
  out.line("| bit | name | cause |").line("|---|---|---|");
  for (const Block& block : tables.map.blocks) {
    for (const Register& r : block.registers) {
      if (!r.bits) continue;
      for (const Field& field : r.fields) {
        out.line("| " + std::to_string(field.low) + " | `" + field.name + "` | " + field.meaning +
                 " |");
      }
    }
  }
  outputs.push_back({Output::Kind::block, "docs/spec/unit.md", out.str(), "events"});
}

void capabilities(const PortTables& tables, Outputs& outputs) {
  Text out;
  out.line("| address | name | holds |").line("|---|---|---|");
  for (const Block& block : tables.map.blocks) {
    for (const Register& r : block.registers) {
      if (!r.capability) continue;
      out.line("| " + address(block, r) + named(r) + holds(tables, r) + " |");
    }
  }
  outputs.push_back({Output::Kind::block, "docs/spec/unit.md", out.str(), "capabilities"});
}

}  // namespace

void emit_docs_registers(const PortTables& tables, Outputs& outputs) {
  page(tables, "unit.md", "registers", outputs);
  page(tables, "effects.md", "effect_registers", outputs);
  events(tables, outputs);
  capabilities(tables, outputs);
}

}  // namespace ptm::contract
