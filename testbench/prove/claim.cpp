#include "testbench/prove/claim.h"

#include <algorithm>
#include <map>

#include "testbench/rtl/yosys.h"

namespace ptm::testbench {
namespace {

std::string vector(int bits) { return "[" + std::to_string(bits - 1) + ":0] "; }

std::string join(const std::vector<std::string>& parts, const std::string& between) {
  std::string text;
  for (const std::string& part : parts) text += (text.empty() ? "" : between) + part;
  return text;
}

std::string literal(Value value, int bits) {
  return "$signed(" + std::to_string(bits) + "'d" +
         std::to_string(static_cast<std::uint64_t>(value) & ((std::uint64_t{1} << bits) - 1)) + ")";
}

/// Whether a number of so many bits, signed, is within a range; nothing if all of them are.
std::string within(const std::string& value, int bits, Range range) {
  if (range == signed_range(bits)) return {};
  const int wide = std::max(bits, signed_bits(range)) + 1;
  return "(" + value + " >= " + literal(range.low, wide) + " && " + value +
         " <= " + literal(range.high, wide) + ")";
}

std::string legal_input(const Netlist::Port& input) {
  if (input.is_signed) return within(input.name, input.bits, input.range);
  if (input.range == unsigned_range(input.bits)) return {};
  return within("$signed({1'b0, " + input.name + "})", input.bits + 1, input.range);
}

std::string instance_of_rtl(const Claim& claim) {
  std::vector<std::string> parameters, connections;
  for (const auto& [name, value] : claim.parameters) {
    parameters.push_back("." + name + "(" + yosys_integer(value) + ")");
  }
  for (const auto& [port, parts] : claim.inputs) {
    // Yosys 0.23 stops where a concatenation meets a signed port.
    const std::string value = join(parts, ", ");
    connections.push_back("." + port + "(" + (parts.size() == 1 ? value : "{" + value + "}") + ")");
  }
  std::map<std::string, int> widths;
  for (const Compared& out : claim.outputs) {
    widths[out.port] = std::max(widths[out.port], out.low_bit + out.bits);
  }
  std::string text;
  for (const auto& [port, bits] : widths) {
    text += "  wire " + vector(bits) + "rtl_" + port + ";\n";
    connections.push_back("." + port + "(rtl_" + port + ")");
  }
  return text + "  " + claim.module + " #(" + join(parameters, ", ") + ") u_rtl (\n    " +
         join(connections, ",\n    ") + "\n  );\n";
}

std::string instance_of_reference(const Claim& claim) {
  std::string text = "  wire known;\n";
  std::vector<std::string> connections{".known(known)"};
  for (const Netlist::Port& port : claim.netlist.inputs()) {
    connections.push_back("." + port.name + "(" + port.name + ")");
  }
  for (const Netlist::Port& port : claim.netlist.outputs()) {
    text += "  wire signed " + vector(port.bits) + "ref_" + port.name + ";\n";
    connections.push_back("." + port.name + "(ref_" + port.name + ")");
  }
  return text + "  " + claim.name + "_reference u_reference (\n    " +
         join(connections, ",\n    ") + "\n  );\n";
}

/// Both as signed numbers, so that the narrower one is extended as its sign says.
std::string difference(const Compared& out) {
  const std::string slice = "rtl_" + out.port + "[" + std::to_string(out.low_bit + out.bits - 1) +
                            ":" + std::to_string(out.low_bit) + "]";
  return "($signed(" + (out.is_signed ? slice : "{1'b0, " + slice + "}") + ") != ref_" +
         out.output + ")";
}

}  // namespace

std::string miter(const Claim& claim) {
  std::vector<std::string> ports, legal{"known"}, differences;
  for (const Netlist::Port& input : claim.netlist.inputs()) {
    ports.push_back(std::string("  input wire ") + (input.is_signed ? "signed " : "") +
                    vector(input.bits) + input.name);
    if (const std::string limits = legal_input(input); !limits.empty()) legal.push_back(limits);
  }
  for (const Compared& out : claim.outputs) differences.push_back(difference(out));
  for (const Netlist::Port& output : claim.netlist.outputs()) {
    if (!output.claimed) continue;
    const std::string limits = within("ref_" + output.name, output.bits, output.range);
    if (!limits.empty()) differences.push_back(std::string("!").append(limits));
  }
  return claim.netlist.verilog(claim.name + "_reference") + "module " + claim.name + " (\n" +
         join(ports, ",\n") + ",\n  output wire differ\n);\n" + instance_of_rtl(claim) +
         instance_of_reference(claim) + "  assign differ = " + join(legal, "\n    && ") +
         "\n    && (" + join(differences, "\n      || ") + ");\nendmodule\n";
}

}  // namespace ptm::testbench
