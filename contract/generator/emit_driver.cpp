#include "contract/generator/emit_registers.h"
#include "contract/generator/names.h"
#include "contract/generator/text.h"

/// The header of a driver: plain C11, nothing but macros.
namespace ptm::contract {
namespace {

constexpr const char* kPrefix = "PTM_UNIT_";

std::string define(const std::string& name, const std::string& value) {
  return "#define " + padded(kPrefix + name, 44) + " " + value;
}

std::string number(std::uint32_t value) { return hex(value, 1) + "u"; }

void constants(const PortTables& tables, Text& out) {
  out.line("/* Sizes that are the same in every unit */");
  for (const Constant& constant : tables.map.constants) {
    out.line(define(upper(constant.name), std::to_string(constant.value)) + " /* " +
             constant.meaning + " */");
  }
  for (const Codes& codes : tables.map.codes) {
    out.line().line("/* Codes: " + codes.meaning + " */");
    for (std::size_t n = 0; n < codes.names.size(); ++n) {
      out.line(define(upper(codes.name) + "_" + upper(codes.names[n]), std::to_string(n) + "u"));
    }
  }
  out.line().line("/* Counters: numbers of PTM_UNIT_COUNTER_LOW and PTM_UNIT_COUNTER_HIGH */");
  for (const Counter& counter : tables.counters.all) {
    out.line(define("COUNT_" + upper(counter.name), std::to_string(counter.number) + "u"));
  }
  out.line(define("COUNTERS", std::to_string(tables.counters.all.size()) + "u"));
}

/// A comment of C: one, whatever its lines.
void comment(const std::string& words, Text& out) {
  std::vector<std::string> lines = wrapped(words, kColumns - 6);
  for (std::size_t n = 0; n < lines.size(); ++n) {
    out.line((n == 0 ? "/* " : " * ") + lines[n] + (n + 1 == lines.size() ? " */" : ""));
  }
}

void address(const Block& block, const Register& r, Text& out) {
  std::vector<std::string> arguments, terms{number(block.address + r.offset)};
  const auto add = [&](const Repeat& repeat) {
    arguments.push_back(repeat.index);
    terms.push_back(std::to_string(repeat.stride) + "u * (" + repeat.index + ")");
  };
  if (block.repeat) add(*block.repeat);
  for (const Repeat& repeat : r.repeats) add(repeat);
  const std::string name = upper(r.full_name);
  if (arguments.empty()) {
    out.line(define(name, terms[0]));
  } else {
    out.line(define(name + "(" + joined(arguments) + ")", "(" + joined(terms, " + ") + ")"));
  }
}

void field(const Register& r, const Field& one, Text& out) {
  const std::string name = upper(r.full_name) + "_" + upper(one.name);
  if (!one.repeat) {
    out.line(define(name + "_SHIFT", std::to_string(one.low)));
    out.line(define(name + "_MASK", number(one.mask())));
  } else {
    const std::string index = "(" + one.repeat->index + ")";
    out.line(define(name + "_SHIFT" + index, "(" + std::to_string(one.low) + "u + " +
                                                 std::to_string(one.repeat->stride) + "u * " +
                                                 index + ")"));
    out.line(define(name + "_MASK" + index, "(" + number(one.mask()) + " << (" +
                                                std::to_string(one.repeat->stride) + "u * " +
                                                index + "))"));
  }
  out.line(define(name + "_WIDTH", std::to_string(one.width)));
  if (one.is_signed) out.line(define(name + "_SIGNED", "1"));
  if (one.reset != 0) out.line(define(name + "_RESET", number(one.reset)));
}

}  // namespace

void emit_driver_header(const PortTables& tables, Outputs& outputs) {
  Text out;
  out.line("/* Written by scripts/contract from the tables of contract/.");
  out.line(" *");
  out.comment(" * ", tables.map.meaning +
                         " (docs/spec/unit.md and docs/spec/effects.md, Registers) "
                         "for a driver in C11. Addresses are of 32-bit words; a bus of bytes has a "
                         "register at four times its address. A field is read and set with");
  out.line(" *");
  out.line(" *   PTM_UNIT_GET(word, PTM_UNIT_STATE_TAG)");
  out.line(" *   PTM_UNIT_SET(word, PTM_UNIT_DRAW_CONTROL_MIP, PTM_UNIT_MIP_LINEAR)");
  out.line(" *");
  out.comment(" * ",
              "and one of those that repeat in a register with PTM_UNIT_GET_AT(word, NAME, index) "
              "and PTM_UNIT_SET_AT(word, NAME, index, value). PTM_UNIT_GET_SIGNED extends the sign "
              "of a field in two's complement (NAME_SIGNED is 1). */");
  out.line("#ifndef PTM_UNIT_H").line("#define PTM_UNIT_H").line();
  out.line("#include <stdint.h>").line();
  out.line(
      "#define PTM_UNIT_GET(word, field) ((uint32_t)(((uint32_t)(word) & field##_MASK) >> "
      "field##_SHIFT))");
  out.line("#define PTM_UNIT_SET(word, field, value) \\");
  out.line("  (((uint32_t)(word) & ~(uint32_t)field##_MASK) | \\");
  out.line("   (((uint32_t)(value) << field##_SHIFT) & field##_MASK))");
  out.line("#define PTM_UNIT_GET_AT(word, field, index) \\");
  out.line("  ((uint32_t)(((uint32_t)(word) & field##_MASK(index)) >> field##_SHIFT(index)))");
  out.line("#define PTM_UNIT_SET_AT(word, field, index, value) \\");
  out.line("  (((uint32_t)(word) & ~(uint32_t)field##_MASK(index)) | \\");
  out.line("   (((uint32_t)(value) << field##_SHIFT(index)) & field##_MASK(index)))");
  out.line("#define PTM_UNIT_GET_SIGNED(word, field) \\");
  out.line("  ((int32_t)((PTM_UNIT_GET(word, field) ^ (1u << (field##_WIDTH - 1))) - \\");
  out.line("             (1u << (field##_WIDTH - 1))))").line();
  constants(tables, out);
  for (const Block& block : tables.map.blocks) {
    out.line().line("/* Addresses " + hex(block.address, 4) + " to " +
                    hex(block.address + block.size - 1, 4) + ": " + block.meaning + " */");
    for (const Register& r : block.registers) {
      out.line();
      comment(r.meaning + "; " + std::string(access_name(r.access)) +
                  (r.shared ? ", while the unit is idle only" : ""),
              out);
      address(block, r, out);
      for (const Field& one : r.fields) field(r, one, out);
    }
  }
  out.line().line("#endif");
  outputs.push_back({Output::Kind::committed, "contract/driver/ptm_unit.h", out.str(), {}});
}

}  // namespace ptm::contract
