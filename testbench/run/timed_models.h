#pragma once
#include <vector>

#include "model/pipeline/stream_timing.h"
#include "testbench/run/child_process.h"
#include "testbench/run/flat_job.h"
#include "testbench/run/run_result.h"

/// The two models that know the cycle of every pixel, each in a process of its own.
namespace ptm::testbench {

struct TimedResult {
  ModelResult model;
  /// For each frame and pixel the cycle in which it left, counted from the evaluator's first
  /// operand: what pipeline and RTL must agree in. The fetch in front of it is the pipeline's only.
  std::vector<std::vector<pipeline::Cycle>> cycles;
};

/// Starts the model; the job must stay as it is until take_result().
[[nodiscard]] ChildProcess start_pipeline(const FlatJob& job);
[[nodiscard]] ChildProcess start_rtl(const FlatJob& job);

/// Waits for it.
[[nodiscard]] TimedResult take_result(ChildProcess& child, const std::string& model,
                                      const FlatJob& job);

}  // namespace ptm::testbench
