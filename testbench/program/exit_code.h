#pragma once
#include <stdexcept>
#include <string>

namespace ptm::testbench {

/// The program's exit codes; every command keeps to them.
enum class ExitCode : int {
  fine = 0,
  disagree = 1,     ///< the models disagree, or a stated tolerance is broken
  usage = 2,        ///< wrong usage
  bad_input = 3,    ///< golden::InputError: file, place, found, expected
  missing_tool = 4  ///< a needed tool is missing (the message names the package) or fails
};

/// Ends the program with that code and message.
class ExitError : public std::runtime_error {
 public:
  ExitError(ExitCode code, const std::string& message) : std::runtime_error(message), code_(code) {}
  [[nodiscard]] ExitCode code() const { return code_; }

 private:
  ExitCode code_;
};

}  // namespace ptm::testbench
