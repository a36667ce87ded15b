#pragma once
#include <filesystem>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "model/reference/eval_config.h"
#include "model/reference/unit/unit_config.h"

/// Verilated units and evaluators of any parameters: built when first asked for, and kept.
///
/// Each is a library of its own that is loaded into the process that runs it. It is made of the
/// sources that lie within this program (variant_build.h). Its key is made from its parameters, the
/// content of those sources, and what compiles them, so that another program never meets a stale
/// library. Libraries lie in $PTMSIM_CACHE, else $XDG_CACHE_HOME/ptmsim, else ~/.cache/ptmsim, else
/// the folder for temporary files. A digest at their end tells damaged ones.
namespace ptm::testbench {

/// A tool that is needed is missing or fails; what() names the Debian package that brings it, or
/// has the end of what the tool said.
class ToolError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The folder for libraries cannot be made or written, or its disk is full.
class UnusableCache : public std::runtime_error {
 public:
  UnusableCache(const std::string& where, const std::string& why)
      : std::runtime_error(where + ": " + why), folder(where), reason(why) {}
  std::string folder, reason;
};

/// "Name=value" of every parameter of rtl/evaluator/ptm_evaluator.sv, and of rtl/ptm_unit.sv.
[[nodiscard]] std::vector<std::string> evaluator_parameters(const reference::EvalConfig& config);
[[nodiscard]] std::vector<std::string> rtl_parameters(const reference::EvalConfig& config,
                                                      const reference::UnitConfig& unit);

/// Where the library of those parameters lies or will lie.
[[nodiscard]] std::filesystem::path variant_library(const reference::EvalConfig& config,
                                                    const reference::UnitConfig& unit);

/// Who is told what happens.
using Say = std::function<void(const std::string&)>;

/// Builds the library of a unit, or of an evaluator, if it is not there or damaged; `say` is told
/// before that takes its minute. Of two programs that want the same one, one waits for the other.
/// What programs that were killed left in the folder is removed. Throws ToolError and
/// UnusableCache.
std::filesystem::path build_variant(const reference::EvalConfig& config,
                                    const reference::UnitConfig& unit, const Say& say = {});
std::filesystem::path build_variant(const reference::EvalConfig& config, const Say& say = {});

/// The function of that name in a library, which is never closed. Throws std::runtime_error.
[[nodiscard]] void* find_in_library(const std::filesystem::path& library, const char* name);

/// What a library makes; `maker` names its function.
template <class Rtl>
[[nodiscard]] std::unique_ptr<Rtl> load_variant(const std::filesystem::path& library,
                                                const char* maker) {
  using Make = Rtl*();
  return std::unique_ptr<Rtl>(reinterpret_cast<Make*>(find_in_library(library, maker))());
}

}  // namespace ptm::testbench
