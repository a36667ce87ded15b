#pragma once
#include <filesystem>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "model/reference/eval_config.h"
#include "model/reference/unit/unit_config.h"

/// Verilated units of any parameters: built when first asked for, and kept.
///
/// A unit is a library of its own that is loaded into the process that runs it. Its key is made
/// from its parameters, the content of the RTL and of the harness, and what compiles them, so that
/// a changed file never meets a stale library. Libraries lie in $PTMSIM_CACHE, else
/// $XDG_CACHE_HOME/ptmsim, else ~/.cache/ptmsim, else the folder for temporary files.
namespace ptm::testbench {

/// A tool that is needed is missing; what() names the Debian package that brings it.
class MissingTool : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The folder for libraries cannot be made.
class UnusableCache : public std::runtime_error {
 public:
  UnusableCache(const std::string& where, const std::string& why)
      : std::runtime_error(where + ": " + why), folder(where), reason(why) {}
  std::string folder, reason;
};

/// "Name=value" of every parameter of rtl/ptm_unit.sv.
[[nodiscard]] std::vector<std::string> rtl_parameters(const reference::EvalConfig& config,
                                                      const reference::UnitConfig& unit);

/// Where the library of those parameters lies or will lie.
[[nodiscard]] std::filesystem::path variant_library(const reference::EvalConfig& config,
                                                    const reference::UnitConfig& unit);

/// Builds the library if it is not there; `say` is told before that takes its minute. Of two
/// programs that want the same one, one waits for the other. Throws MissingTool,
/// UnusableCache, and std::runtime_error with the end of the tools' output if they fail.
std::filesystem::path build_variant(const reference::EvalConfig& config,
                                    const reference::UnitConfig& unit,
                                    const std::function<void(const std::string&)>& say = {});

}  // namespace ptm::testbench
