#include <algorithm>

#include "contract/generator/emit_registers.h"
#include "contract/generator/names.h"
#include "contract/generator/text.h"

/// SystemRDL 2.0. Addresses are of bytes there: four a word.
namespace ptm::contract {
namespace {

std::string in_quotes(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    if (c != '`') out += c;
  }
  return out + "\"";
}

/// What software and the unit may do.
std::string rights(Access access) {
  switch (access) {
    case Access::rw:
      return "sw = rw; hw = r;";
    case Access::ro:
      return "sw = r; hw = w;";
    case Access::wo:
      return "sw = w; hw = r;";
    case Access::w1c:
      return "sw = rw; hw = w; onwrite = woclr;";
  }
  return "";
}

/// Names of SystemRDL's own, which a name of the tables may be.
std::string identifier(const std::string& name) {
  static const std::vector<std::string> reserved{"abstract",   "accesstype",  "addressingtype",
                                                 "addrmap",    "alias",       "all",
                                                 "bit",        "boolean",     "bothedge",
                                                 "compact",    "component",   "componentwidth",
                                                 "constraint", "default",     "encode",
                                                 "enum",       "external",    "false",
                                                 "field",      "fullalign",   "hw",
                                                 "inside",     "internal",    "level",
                                                 "longint",    "mem",         "na",
                                                 "negedge",    "nonsticky",   "number",
                                                 "onreadtype", "onwritetype", "posedge",
                                                 "property",   "r",           "rclr",
                                                 "ref",        "reg",         "regalign",
                                                 "regfile",    "rset",        "ruser",
                                                 "rw",         "rw1",         "signal",
                                                 "string",     "struct",      "sw",
                                                 "this",       "true",        "type",
                                                 "unsigned",   "w",           "w1",
                                                 "wclr",       "woclr",       "woset",
                                                 "wot",        "wr",          "wset",
                                                 "wuser",      "wzc",         "wzs",
                                                 "wzt"};
  return std::find(reserved.begin(), reserved.end(), name) == reserved.end() ? name : "\\" + name;
}

void field(const Register& r, const Field& one, unsigned copy, Text& out) {
  const unsigned low = one.low + (one.repeat ? copy * one.repeat->stride : 0);
  std::string meaning = one.meaning;
  if (one.built && meaning.empty()) meaning = one.built->name;
  if (one.repeat) meaning += "; " + one.repeat->index + " = " + std::to_string(copy);
  if (one.is_signed) meaning += "; two's complement";
  out.line("    field {");
  out.line("      " + rights(r.access));
  out.line("      desc = " + in_quotes(meaning) + ";");
  if (!one.codes.empty()) out.line("      encode = " + one.codes + "_e;");
  const std::string name = one.repeat ? one.name + std::to_string(copy) : identifier(one.name);
  // What a unit is built with has no value that holds for all of them.
  const bool constant = !one.built || one.built->kind != Built::Kind::parameter;
  const auto reset = one.built ? static_cast<std::uint32_t>(one.built->number) : one.reset;
  out.line("    } " + name + "[" + std::to_string(low + one.width - 1) + ":" + std::to_string(low) +
           "]" + (constant ? " = " + hex(reset, 1) : "") + ";");
}

void one_register(const Register& r, Text& out) {
  out.line("  reg {");
  out.line("    desc = " + in_quotes(r.meaning) + ";");
  out.line("    regwidth = 32; accesswidth = 32;");
  for (const Field& one : r.fields) {
    for (unsigned copy = 0; copy < one.copies(); ++copy) field(r, one, copy, out);
  }
  std::string dimensions, steps;
  for (const Repeat& repeat : r.repeats) dimensions += "[" + std::to_string(repeat.count) + "]";
  // One stride is all that SystemRDL knows: of more dimensions it is the inner one's, so registers
  // whose outer dimension leaves room are written one instance at a time.
  if (r.repeats.empty()) {
    out.line("  } " + identifier(r.name) + " @ " + hex(4 * r.offset, 2) + ";");
  } else if (r.repeats.size() == 1) {
    out.line("  } " + identifier(r.name) + dimensions + " @ " + hex(4 * r.offset, 2) +
             " += " + hex(4 * r.repeats[0].stride, 1) + ";");
  } else {
    std::vector<std::string> instances;
    const unsigned inner = r.repeats.back().count;
    for (unsigned copy = 0; copy < r.copies(); copy += inner) {
      instances.push_back(r.name + std::to_string(copy / inner) + "[" + std::to_string(inner) +
                          "] @ " + hex(4 * r.offset_of(copy), 2) +
                          " += " + hex(4 * r.repeats.back().stride, 1));
    }
    out.line("  } " + joined(instances, ",\n    ") + ";");
  }
}

}  // namespace

void emit_register_description(const PortTables& tables, Outputs& outputs) {
  Text out;
  out.line("// Written by scripts/contract from the tables of contract/. SystemRDL 2.0.");
  out.comment("// ",
              "Addresses are of bytes, four times the words' of docs/spec/unit.md. A register that "
              "the description calls shared is written while the unit is idle only.");
  out.line();
  for (const Codes& codes : tables.map.codes) {
    out.line("enum " + codes.name + "_e {");
    for (std::size_t n = 0; n < codes.names.size(); ++n) {
      out.line("  " + codes.names[n] + "_code = " + std::to_string(n) +
               " { name = " + in_quotes(codes.names[n]) + "; };");
    }
    out.line("};");
  }
  for (const Block& block : tables.map.blocks) {
    out.line().line("regfile " + block.name + "_block {");
    out.line("  desc = " + in_quotes(block.meaning + (block.shared ? "; shared" : "")) + ";");
    for (const Register& r : block.registers) one_register(r, out);
    out.line("};");
  }
  out.line().line("addrmap " + tables.map.name + " {");
  out.line("  name = " + in_quotes(tables.map.name) + ";");
  out.line("  desc = " + in_quotes(tables.map.meaning) + ";");
  out.line("  default regwidth = 32; addressing = regalign; littleendian;");
  for (const Block& block : tables.map.blocks) {
    std::string line = "  " + block.name + "_block " + identifier(block.name);
    if (block.repeat) line += "[" + std::to_string(block.repeat->count) + "]";
    line += " @ " + hex(4 * block.address, 5);
    if (block.repeat) line += " += " + hex(4 * block.repeat->stride, 1);
    out.line(line + ";");
  }
  out.line("};");
  outputs.push_back({Output::Kind::committed, "contract/driver/ptm_unit.rdl", out.str(), {}});
}

}  // namespace ptm::contract
