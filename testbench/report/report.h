#pragma once
#include <filesystem>

#include "testbench/report/run_comparison.h"

namespace ptm::testbench {

struct ReportPaths {
  std::filesystem::path json, html;
};

/// Writes into `directory` (made if missing): a PNG for every model and light, report.json and
/// report.html. The files appear together, under their names only when all of them are complete.
/// Pictures that an earlier report in the directory lists and this one does not are removed.
/// Throws golden::InputError if the directory or a file cannot be written.
ReportPaths write_report(const RunResult& result, const RunComparison& comparison,
                         const std::filesystem::path& directory);

}  // namespace ptm::testbench
