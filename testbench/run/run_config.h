#pragma once
#include <optional>

#include "golden/scene/unit_scene.h"
#include "model/pipeline/memory_timing.h"
#include "model/reference/eval_config.h"
#include "model/reference/unit/unit_config.h"

namespace ptm::testbench {

/// In which order a unit scene's fragments come, and what stands in the caches before.
struct FrameOrder {
  golden::Traversal traversal = golden::Traversal::tiles;
  int tile = 16;
  bool keep_cache = false, draw_twice = false;
};

/// What the models of a unit scene were built with and driven by, beside the evaluator.
struct UnitRunConfig {
  reference::UnitConfig unit;
  pipeline::MemoryModel memory;
  golden::StressSpec stress;
  FrameOrder frames;
};

/// The whole configuration of a run. A flat map knows the evaluator and its TMUs alone.
struct RunConfig {
  reference::EvalConfig evaluator;
  int tmus = 3;
  std::optional<UnitRunConfig> unit;
};

}  // namespace ptm::testbench
