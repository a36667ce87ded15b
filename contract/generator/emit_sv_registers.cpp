#include <algorithm>

#include "contract/generator/emit_registers.h"
#include "contract/generator/names.h"
#include "contract/generator/text.h"

namespace ptm::contract {
namespace {

constexpr const char* kPackage = "ptm_register_pkg::";
constexpr const char* kWritten =
    "// Written by scripts/contract from contract/registers.toml and its neighbours.";

std::string verilog_hex(unsigned bits, std::uint64_t value) {
  return std::to_string(bits) + "'h" + hex(value, static_cast<int>(bits + 3) / 4).substr(2);
}

std::string sized(unsigned bits, std::uint64_t value) {
  return std::to_string(bits) + "'d" + std::to_string(value);
}

void constants(const PortTables& tables, Text& out) {
  for (const Constant& constant : tables.map.constants) {
    out.line("  localparam int " + camel(constant.name) + " = " + std::to_string(constant.value) +
             ";  // " + constant.meaning);
  }
  out.line("  localparam int Counters = " + std::to_string(tables.counters.all.size()) +
           ";  // counters.toml");
  std::vector<std::string> numbers;
  for (const Counter& counter : tables.counters.all) {
    numbers.push_back("Count" + camel(counter.name) + " = " + std::to_string(counter.number));
  }
  out.line("  localparam int").list("    ", numbers, ";");
  out.line();
  for (const Codes& codes : tables.map.codes) {
    out.comment("  // ", "Codes: " + codes.meaning);
    const unsigned bits = bits_for(codes.names.size());
    std::vector<std::string> parts;
    for (std::size_t n = 0; n < codes.names.size(); ++n) {
      parts.push_back(camel(codes.name) + camel(codes.names[n]) + " = " + sized(bits, n));
    }
    parts.push_back(camel(codes.name) + "Last = " + sized(bits, codes.names.size() - 1));
    out.line("  localparam logic [" + std::to_string(bits - 1) + ":0]");
    out.list("    ", parts, ";");
  }
}

void addresses(const PortTables& tables, Text& out) {
  out.line("  // Blocks of registers: the first address, addresses, from one instance to the next");
  for (const Block& block : tables.map.blocks) {
    const std::string name = camel(block.name);
    out.comment("  // ", block.meaning);
    out.line("  localparam logic [15:0] " + name + "Block = " + verilog_hex(16, block.address) +
             ";");
    out.line("  localparam int " + name + "Size = " + std::to_string(block.size) + ", " + name +
             "Stride = " + std::to_string(block.instance()) + ";");
  }
  out.line();
  out.line(
      "  // Registers: addresses, and offsets in an instance of their block; fields: the lowest");
  out.line("  // bit and the width");
  for (const Block& block : tables.map.blocks) {
    for (const Register& r : block.registers) {
      const std::string name = camel(r.full_name);
      if (!block.repeat && r.repeats.empty()) {
        out.line("  localparam logic [15:0] " + name +
                 "Addr = " + verilog_hex(16, block.address + r.offset) + ";");
      }
      out.line("  localparam logic [" + std::to_string(bits_for(block.instance()) - 1) + ":0] " +
               name + "Offset = " + sized(bits_for(block.instance()), r.offset) + ";");
      for (const Field& field : r.fields) {
        out.line("  localparam int " + name + camel(field.name) +
                 "Low = " + std::to_string(field.low) + ", " + name + camel(field.name) +
                 "W = " + std::to_string(field.width) + ";");
      }
      for (const Field& field : r.fields) {
        if (!field.repeat) continue;
        out.line("  localparam int " + name + camel(field.name) +
                 "Step = " + std::to_string(field.repeat->stride) + ";");
      }
      std::uint32_t reset = 0;
      for (const Field& field : r.fields) reset |= field.reset << field.low;
      if (reset != 0) {
        out.line("  localparam logic [31:0] " + name + "Reset = " + verilog_hex(32, reset) + ";");
      }
      if (r.bits) {
        out.line("  localparam int " + name + "W = " + std::to_string(r.fields.size()) + ";");
      }
    }
  }
  const Register& first = *tables.map.capabilities().front();
  out.line("  localparam logic [4:0] CapabilitiesOffset = " + sized(5, first.offset) + ";");
  out.line("  localparam int CapabilityWords = " +
           std::to_string(tables.map.capabilities().size()) + ";");
  out.line();
}

void layouts(const PortTables& tables, Text& out) {
  out.line(
      "  // Packed vectors: widths, places of their parts (of element 0), structs. Ports that");
  out.line(
      "  // hold several are plain vectors, item 0 lowest: Yosys 0.23 reads `draw_t [3:0] port`");
  out.line("  // as one draw_t, without a word.");
  for (const Layout& layout : tables.map.layouts) {
    const std::string name = camel(layout.name);
    out.line("  localparam int " + name + "W = " + std::to_string(layout.width) + ";");
    std::vector<std::string> at, width;
    for (const Place& place : layout.places) {
      at.push_back(name + camel(place.name) + "At = " + std::to_string(place.low));
      width.push_back(name + camel(place.name) + "W = " + std::to_string(place.width));
    }
    out.line("  localparam int").list("    ", at, ";");
    out.line("  localparam int").list("    ", width, ";");
    out.comment("  // ", layout.meaning);
    out.line("  typedef struct packed {");
    for (const Place& place : layout.places) {
      std::string type = "logic";
      if (!place.layout.empty()) {
        type = place.layout + "_t";
      } else {
        if (place.is_signed) type += " signed";
        if (place.count > 1) type += " [" + std::to_string(place.count - 1) + ":0]";
        if (place.width > 1 || place.count > 1) {
          type += (place.count > 1 ? "[" : " [") + std::to_string(place.width - 1) + ":0]";
        }
      }
      out.line("    " + type + " " + place.name + ";");
    }
    out.line("  } " + layout.name + "_t;");
    out.line();
  }
}

void package(const PortTables& tables, Outputs& outputs) {
  Text out;
  out.line(kWritten).line("//");
  out.comment("// ",
              tables.map.meaning +
                  ": docs/spec/unit.md and docs/spec/effects.md, Registers. "
                  "For inside a package, where Yosys 0.23 knows no constants of another one.");
  constants(tables, out);
  out.line();
  addresses(tables, out);
  layouts(tables, out);
  outputs.push_back({Output::Kind::committed, "rtl/contract/ptm_registers.svh", out.str(), {}});

  Text package;
  package.line(kWritten).line("//");
  package.comment("// ", tables.map.meaning + ".");
  package.line("package ptm_register_pkg;");
  package.line("  `include \"contract/ptm_registers.svh\"");
  package.line("endpackage");
  outputs.push_back(
      {Output::Kind::committed, "rtl/contract/ptm_register_pkg.sv", package.str(), {}});
}

/// The low bit of an element in the outermost layout.
unsigned held_low(const Held& held, unsigned element) { return held.low + held.stride * element; }

struct Piece {
  std::string need;  ///< "ExtraSets > 0", or empty
  unsigned at = 0, low = 0, width = 0;
};

/// What of one register is kept in the layout.
std::vector<Piece> pieces(const PortTables& tables, const Register& r, unsigned copy,
                          const std::string& layout) {
  std::vector<Piece> all;
  for (const Field& field : r.fields) {
    if (!field.held || field.held->layout != layout) continue;
    for (unsigned n = 0; n < field.copies(); ++n) {
      Piece piece;
      piece.at = held_low(*field.held, copy * field.copies() + n);
      piece.low = field.low + (field.repeat ? n * field.repeat->stride : 0);
      piece.width = field.width;
      if (field.need) {
        piece.need = tables.parameter(field.need->parameter).rtl + " > " +
                     std::to_string(r.more_than(field, copy, n));
      }
      all.push_back(piece);
    }
  }
  return all;
}

/// Case items that write, or read, what a block's registers keep in a layout.
void fragment(const PortTables& tables, const Block& block, const Layout& layout, bool writes,
              Outputs& outputs) {
  Text items;
  const unsigned bits = bits_for(block.instance());
  const std::string width = std::string(kPackage) + camel(layout.name) + "W";
  for (const Register& r : block.registers) {
    for (unsigned copy = 0; copy < r.copies(); ++copy) {
      const std::vector<Piece> all = pieces(tables, r, copy, layout.name);
      if (all.empty()) continue;
      items.line(sized(bits, r.offset_of(copy)) + ": begin  // " + r.full_name);
      for (const Piece& piece : all) {
        const std::string kept = layout.name + (writes ? "s_q" : "s_i") + "[d*" + width + "+" +
                                 std::to_string(piece.at) + " +: " + std::to_string(piece.width) +
                                 "]";
        const std::string bus = bit_range(piece.low, piece.width);
        std::string line = "  ";
        if (writes && !piece.need.empty()) line += "if (" + piece.need + ") ";
        line += writes ? kept + " <= reg_wdata_i" + bus + ";" : "data_o" + bus + " = " + kept + ";";
        items.line(line);
      }
      items.line("end");
    }
  }
  if (items.str().empty()) return;
  const std::string name = "ptm_" + block.name +
                           (block.name == layout.name ? "" : "_" + layout.name) +
                           (writes ? "_write" : "_read") + ".svh";
  Text out;
  out.line(kWritten);
  out.comment("// ", std::string("Case items over the offset in an instance of the block `") +
                         block.name + "`: what a register of draw d " +
                         (writes ? "writes into " + layout.name + "s_q from reg_wdata_i."
                                 : "shows of " + layout.name + "s_i in data_o."));
  outputs.push_back({Output::Kind::committed, "rtl/contract/" + name, out.str() + items.str(), {}});
}

/// A register that a parameter is needed for does not count in a unit without.
std::string here_if_built(const PortTables& tables, const Register& r, const std::string& here) {
  const Field& first = r.fields.front();
  if (!first.need) return here;
  return "(" + tables.parameter(first.need->parameter).rtl + " > " +
         std::to_string(r.more_than(first, 0, 0)) + " && " + here + ")";
}

/// A function that says whether a write is of what fragments read.
void shared_fragment(const PortTables& tables, Outputs& outputs) {
  std::vector<std::string> terms;
  for (const Block& block : tables.map.blocks) {
    const unsigned low = bits_for(block.size);
    if (block.shared) {
      terms.push_back("address" + bit_range(low, 16 - low) +
                      " == " + verilog_hex(16 - low, block.address >> low));
      continue;
    }
    for (const Register& r : block.registers) {
      const std::string here = "address == " + std::string(kPackage) + camel(r.full_name) + "Addr";
      if (r.shared) terms.push_back(here_if_built(tables, r, here));
      for (const Field& field : r.fields) {
        if (!field.shared) continue;
        terms.push_back("(" + here + " && data" + bit_range(field.low, field.width) + " != '0)");
      }
    }
  }
  Text out;
  out.line(kWritten);
  out.comment("// ", "Whether a write is of what fragments read: docs/spec/unit.md, Registers.");
  out.line("function automatic logic is_shared_write(input logic [15:0] address,");
  out.line("                                         input logic [31:0] data);");
  out.line("  is_shared_write = " + joined(terms, " ||\n                    ") + ";");
  out.line("endfunction");
  outputs.push_back({Output::Kind::committed, "rtl/contract/ptm_shared_write.svh", out.str(), {}});
}

std::string built_value(const PortTables& tables, const Field& field) {
  switch (field.built->kind) {
    case Built::Kind::parameter:
      return std::to_string(field.width) + "'(" + tables.parameter(field.built->name).rtl + ")";
    case Built::Kind::constant:
      return std::to_string(field.width) + "'(" + kPackage + camel(field.built->name) + ")";
    default:
      return sized(field.width, static_cast<std::uint64_t>(field.built->number));
  }
}

std::vector<Field> by_bits(const Register& r) {
  std::vector<Field> fields = r.fields;
  std::sort(fields.begin(), fields.end(),
            [](const Field& a, const Field& b) { return a.low < b.low; });
  return fields;
}

void capabilities(const PortTables& tables, Outputs& outputs) {
  Text out;
  out.line(kWritten);
  out.comment("// ", "What the capability registers read as, word 0 lowest in words_o.");
  unsigned number = 0;
  for (const Register* r : tables.map.capabilities()) {
    std::vector<std::string> parts;
    unsigned from = 0;
    for (const Field& field : by_bits(*r)) {
      if (field.low > from) parts.insert(parts.begin(), sized(field.low - from, 0));
      parts.insert(parts.begin(), built_value(tables, field));
      from = field.low + field.width;
    }
    if (from < 32) parts.insert(parts.begin(), sized(32 - from, 0));
    out.line("// " + r->full_name);
    out.line("assign words_o[" + std::to_string(32 * number) + " +: 32] = {");
    out.list("  ", parts, "};");
    ++number;
  }
  outputs.push_back(
      {Output::Kind::committed, "rtl/contract/ptm_capability_words.svh", out.str(), {}});
}

}  // namespace

void emit_sv_registers(const PortTables& tables, Outputs& outputs) {
  package(tables, outputs);
  for (const Block& block : tables.map.blocks) {
    for (const Layout& layout : tables.map.layouts) {
      fragment(tables, block, layout, true, outputs);
      fragment(tables, block, layout, false, outputs);
    }
  }
  shared_fragment(tables, outputs);
  capabilities(tables, outputs);
}

}  // namespace ptm::contract
