#pragma once
#include <optional>
#include <string>
#include <vector>

namespace ptm::testbench {

/// The program that runs, as main() knows it.
struct Invocation {
  std::string version;               ///< of the project
  std::string commit;                ///< that it was built from, 40 digits, or "unknown"
  std::optional<bool> changed;       ///< whether sources differed from it; nothing if unknown
  std::vector<std::string> command;  ///< its words, the program first
};

/// What a report's block `made_by` holds: docs/spec/report.md.
struct MadeBy {
  Invocation invocation;
  std::string date;                          ///< UTC, "2026-01-31T23:59:59Z"
  std::string compiler, verilator, systemc;  ///< name and version
  std::string cpu, system, kernel;           ///< "unknown" where the machine does not say
  unsigned cores = 0;                        ///< that the system has on line; 0: unknown
};

/// The block for a run that ends now, on this machine.
[[nodiscard]] MadeBy made_by(const Invocation& invocation);

/// "ptmsim 0.1.0, commit abc..., sources changed since" on one line.
[[nodiscard]] std::string program_text(const Invocation& invocation);

}  // namespace ptm::testbench
