#pragma once
#include <vector>

#include "testbench/run/flat_job.h"
#include "testbench/run/run_result.h"

/// The two models that know nothing of time.
namespace ptm::testbench {

[[nodiscard]] ModelResult render_golden(const FlatJob& job);

[[nodiscard]] ModelResult render_reference(const FlatJob& job);

/// The reference's frames for any configuration and stored map.
[[nodiscard]] std::vector<golden::ImageReal> reference_frames(const FlatJob& job,
                                                              const reference::EvalConfig& config,
                                                              const HardwareMap& hardware);

}  // namespace ptm::testbench
