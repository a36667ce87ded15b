#pragma once
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "testbench/prove/claim.h"

/// Asks Yosys and ABC, which comes with it, whether something holds for every input.
///
/// All three throw ToolError without yosys, and std::runtime_error with the end of its output if
/// it cannot read what it is given. `files` are SystemVerilog, a package before its users, absolute
/// or as seen from the project's root.
namespace ptm::testbench {

enum class Verdict { holds, fails, undecided };

struct Answer {
  Verdict verdict = Verdict::undecided;
  /// Of a claim that fails: each input and its value, "lu = -512", and what the RTL made of it.
  std::vector<std::pair<std::string, std::string>> counterexample;
  double seconds = 0;
};

/// Whether the RTL's module and the reference agree on every input of the claim's ranges, by SAT.
/// Undecided after `seconds`.
[[nodiscard]] Answer prove(const Claim& claim, const std::vector<std::string>& files,
                           int seconds = 250);

/// A module whose one output is to be 0. Its registers start as their initial values say, or from
/// anything.
struct Property {
  std::string top;
  std::vector<std::pair<std::string, int>> parameters;
};

/// Whether the output is 0 in every cycle that can be reached (property-directed reachability).
[[nodiscard]] Answer prove_always(const Property& property, const std::vector<std::string>& files);

/// Whether the output is 0 in this one cycle; the first is 0. For properties with arithmetic, whose
/// two sides are made of the same modules.
[[nodiscard]] Answer prove_in_cycle(const Property& property, const std::vector<std::string>& files,
                                    int cycle);

}  // namespace ptm::testbench
