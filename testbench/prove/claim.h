#pragma once
#include <string>
#include <utility>
#include <vector>

#include "testbench/prove/symbolic.h"

/// That an RTL module and a piece of the reference give the same for every input.
namespace ptm::testbench {

/// Some bits of an output of the RTL, and the output of the netlist that they must equal.
struct Compared {
  std::string port;
  int low_bit = 0, bits = 0;
  bool is_signed = true;
  std::string output;
};

struct Claim {
  std::string name;    ///< a Verilog identifier
  std::string module;  ///< of the RTL
  std::vector<std::pair<std::string, int>> parameters;
  /// The RTL's inputs, each from expressions over the netlist's inputs, highest bits first.
  std::vector<std::pair<std::string, std::vector<std::string>>> inputs;
  std::vector<Compared> outputs;
  Netlist netlist;
};

/// One module in Verilog, `claim.name`, with the netlist's inputs and the output `differ`: 1 for
/// those inputs within their ranges for which any output differs, or leaves the range claimed of
/// it. It instantiates the RTL's module and the netlist's, which it brings along as
/// NAME_reference.
[[nodiscard]] std::string miter(const Claim& claim);

}  // namespace ptm::testbench
