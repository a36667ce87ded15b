#include <algorithm>

#include "contract/generator/emit_registers.h"
#include "contract/generator/names.h"
#include "contract/generator/text.h"

namespace ptm::contract {
namespace {

std::string code_type(const Codes& codes) {
  return codes.name == "format" ? "TextureFormat" : camel(codes.name);
}

void constants(const PortTables& tables, Text& out) {
  for (const Constant& constant : tables.map.constants) {
    out.line("inline constexpr int k" + camel(constant.name) + " = " +
             std::to_string(constant.value) + ";  ///< " + constant.meaning);
  }
  out.line();
  for (const Codes& codes : tables.map.codes) {
    out.comment("/// ", "Codes: " + codes.meaning + ".");
    out.line("enum class " + code_type(codes) + " : std::uint8_t {");
    out.list("  ", codes.names, "");
    out.line("};");
    out.line("inline constexpr auto kLast" + camel(codes.name) + " = " + code_type(codes) +
             "::" + codes.names.back() + ";");
  }
  out.line();
}

constexpr const char* kFieldType =
    R"(/// A field of a register: bits low to low + width - 1, two's complement if signed.
struct RegisterField {
  std::string_view name;
  unsigned low = 0, width = 0;
  bool is_signed = false;
  [[nodiscard]] constexpr std::uint32_t mask() const {
    return (width == 32 ? ~std::uint32_t{0} : (std::uint32_t{1} << width) - 1) << low;
  }
  [[nodiscard]] constexpr std::int64_t least() const {
    return is_signed ? -(std::int64_t{1} << (width - 1)) : 0;
  }
  [[nodiscard]] constexpr std::int64_t most() const {
    return least() + (std::int64_t{1} << width) - 1;
  }
  /// The value, which must be one of least() to most(), at its place in a word.
  [[nodiscard]] constexpr std::uint32_t pack(std::int64_t value) const {
    return static_cast<std::uint32_t>(value) << low & mask();
  }
  [[nodiscard]] constexpr std::int64_t unpack(std::uint32_t word) const {
    const std::int64_t code = (word & mask()) >> low;
    return is_signed && code > most() ? code - (std::int64_t{1} << width) : code;
  }
  /// The same field a number of bits higher: of fields that repeat.
  [[nodiscard]] constexpr RegisterField higher(unsigned bits) const {
    return {name, low + bits, width, is_signed};
  }
};
)";

void fields(const Register& r, Text& out) {
  out.line("namespace " + r.full_name + " {");
  for (const Field& field : r.fields) {
    out.line("inline constexpr RegisterField k" + camel(field.name) + "{\"" + field.name + "\", " +
             std::to_string(field.low) + ", " + std::to_string(field.width) + ", " +
             (field.is_signed ? "true" : "false") + "};");
    if (field.repeat) {
      out.line("inline constexpr unsigned k" + camel(field.name) +
               "Count = " + std::to_string(field.repeat->count) + ", k" + camel(field.name) +
               "Stride = " + std::to_string(field.repeat->stride) + ";");
    }
  }
  std::uint32_t reset = 0;
  for (const Field& field : r.fields) reset |= field.reset << field.low;
  if (reset != 0) {
    out.line("inline constexpr std::uint32_t kReset = " + hex(reset, 8) + ";");
  }
  if (r.bits) {
    std::uint32_t all = 0;
    for (const Field& field : r.fields) all |= field.mask();
    out.line("inline constexpr std::uint32_t kAll = " + hex(all, 1) + ";");
  }
  out.line("}  // namespace " + r.full_name);
}

/// Where it lies: a constant, or a function of what repeats.
void address(const Block& block, const Register& r, Text& out) {
  std::vector<std::string> arguments, terms{std::to_string(block.address + r.offset)};
  const auto add = [&](const Repeat& repeat) {
    arguments.push_back("unsigned " + repeat.index);
    terms.push_back((repeat.stride == 1 ? "" : std::to_string(repeat.stride) + " * ") +
                    repeat.index);
  };
  if (block.repeat) add(*block.repeat);
  for (const Repeat& repeat : r.repeats) add(repeat);
  out.comment("/// ", r.meaning + "; " + std::string(access_name(r.access)) +
                          (r.shared ? ", shared" : "") + ".");
  if (arguments.empty()) {
    out.line("inline constexpr std::uint16_t k" + camel(r.full_name) + " = " +
             hex(block.address + r.offset, 4) + ";");
    return;
  }
  out.line("[[nodiscard]] constexpr std::uint16_t " + r.full_name + "_address(" +
           joined(arguments) + ") {");
  out.line("  return static_cast<std::uint16_t>(" + joined(terms, " + ") + ");");
  out.line("}");
}

std::string headline() { return "// Written by contract/generator from the tables of contract/."; }

void header(const PortTables& tables, Outputs& outputs) {
  Text out;
  out.line(headline()).line("#pragma once");
  out.line("#include <cstddef>").line("#include <cstdint>").line("#include <string_view>").line();
  out.line("/// " + tables.map.meaning +
           ": docs/spec/unit.md and docs/spec/effects.md, Registers.");
  out.line("namespace ptm::contract {").line();
  constants(tables, out);
  out.line(kFieldType);
  out.comment("/// ", "Addresses, of 32-bit words.");
  out.line("namespace registers {").line();
  for (const Block& block : tables.map.blocks) {
    const std::string name = "k" + camel(block.name);
    out.line("// " + block.meaning);
    out.line("inline constexpr unsigned " + name + "Block = " + hex(block.address, 4) + ", " +
             name + "Size = " + std::to_string(block.size) + ";");
    if (block.repeat) {
      out.line("inline constexpr unsigned " + name +
               "Count = " + std::to_string(block.repeat->count) + ", " + name +
               "Stride = " + std::to_string(block.repeat->stride) + ";");
    }
    for (const Register& r : block.registers) address(block, r, out);
    out.line();
  }
  const auto capabilities = tables.map.capabilities();
  out.line("/// The registers that say what the unit is built with, one behind the other.");
  out.line("inline constexpr std::uint16_t kCapabilities = k" +
           camel(capabilities.front()->full_name) + ";");
  out.line("inline constexpr std::size_t kCapabilityWords = " +
           std::to_string(capabilities.size()) + ";");
  out.line().line("}  // namespace registers").line();
  out.comment("/// ", "Fields of registers.");
  out.line("namespace fields {").line();
  for (const Block& block : tables.map.blocks) {
    for (const Register& r : block.registers) fields(r, out);
  }
  out.line().line("}  // namespace fields").line();
  out.line("}  // namespace ptm::contract");
  outputs.push_back({Output::Kind::build, "registers.h", out.str(), {}});
}

std::string condition(const PortTables& tables, const Register& r, unsigned copy,
                      const Field& field, unsigned element) {
  return tables.parameter(field.need->parameter).cpp + " > " +
         std::to_string(r.more_than(field, copy, element));
}

/// "0xffffU | (unit.stages > 0 ? 0xff00U : 0U)"
std::string stored(const PortTables& tables, const Register& r, unsigned copy) {
  std::uint32_t always = 0;
  std::vector<std::pair<std::string, std::uint32_t>> parts;
  for (const Field& field : r.fields) {
    for (unsigned element = 0; element < field.copies(); ++element) {
      Field at = field;
      at.low += field.repeat ? element * field.repeat->stride : 0;
      if (!field.need) {
        always |= at.mask();
        continue;
      }
      const std::string when = condition(tables, r, copy, field, element);
      const auto same = [&when](const auto& part) { return part.first == when; };
      auto part = std::find_if(parts.begin(), parts.end(), same);
      if (part == parts.end()) part = parts.insert(parts.end(), {when, 0});
      part->second |= at.mask();
    }
  }
  std::vector<std::string> terms;
  if (always != 0) terms.push_back(hex(always, 1) + "U");
  for (const auto& [when, mask] : parts) {
    terms.push_back("(" + when + " ? " + hex(mask, 1) + "U : 0U)");
  }
  return joined(terms, " | ");
}

void stored_bits(const PortTables& tables, Outputs& outputs) {
  Text out;
  out.line(headline());
  out.comment("// ",
              "The body of stored_bits(address, unit, config): what reads as it was written.");
  for (const Block& block : tables.map.blocks) {
    Text cases;
    for (const Register& r : block.registers) {
      if (r.access != Access::rw) continue;
      for (unsigned copy = 0; copy < r.copies(); ++copy) {
        cases.line("    case " + std::to_string(r.offset_of(copy)) + ":");
        cases.line("      return " + stored(tables, r, copy) + ";");
      }
    }
    if (cases.str().empty()) continue;
    const unsigned instances =
        block.repeat ? block.repeat->count * block.repeat->stride : block.size;
    const std::string low = std::to_string(bits_for(block.size));
    std::string here =
        "address >> " + low + "U == " + hex(block.address >> bits_for(block.size), 1) + "U";
    if (instances < block.size) {
      here += " && address < " + hex(block.address + instances, 4) + "U";
    }
    out.line("if (" + here + ") {");
    out.line("  switch ((address - " + hex(block.address, 4) + "U) % " +
             std::to_string(block.instance()) + "U) {");
    out.line(cases.str() + "    default:\n      return 0;\n  }\n}");
  }
  out.line("return 0;");
  outputs.push_back({Output::Kind::build, "stored_bits.inc", out.str(), {}});
}

void capability_words(const PortTables& tables, Outputs& outputs) {
  Text out;
  out.line(headline());
  out.comment("// ", "The body of capability_words(config, unit).");
  out.line("return {");
  for (const Register* r : tables.map.capabilities()) {
    std::vector<std::string> parts;
    for (const Field& field : r->fields) {
      const std::string value = field.built->kind == Built::Kind::parameter
                                    ? tables.parameter(field.built->name).cpp
                                    : std::to_string(field.built->number);
      parts.push_back("fields::" + r->full_name + "::k" + camel(field.name) +
                      ".pack(static_cast<std::int64_t>(" + value + "))");
    }
    out.line("    " + joined(parts, " |\n        ") + ",");
  }
  out.line("};");
  outputs.push_back({Output::Kind::build, "capability_words.inc", out.str(), {}});
}

}  // namespace

void emit_cpp_registers(const PortTables& tables, Outputs& outputs) {
  header(tables, outputs);
  stored_bits(tables, outputs);
  capability_words(tables, outputs);
}

}  // namespace ptm::contract
