#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "model/pipeline/memory_timing.h"
#include "model/pipeline/stream_timing.h"
#include "model/reference/unit/unit_config.h"
#include "model/reference/unit/unit_counters.h"
#include "model/reference/unit/unit_fragment.h"
#include "model/reference/unit/unit_memory.h"

/// What a timed model of the whole unit is given and gives; the same for `exact`, `loose` and the
/// RTL. Free of SystemC's headers.
namespace ptm::pipeline {

/// One frame: its fragments in order. Caches are invalidated before it unless keep_cache.
struct UnitFrame {
  std::span<const reference::UnitFragment> fragments;
  bool keep_cache = false;
  /// If set, the unit alone was reset before the frame, and in this cycle the memory gives the last
  /// answer to a request from before. Nothing is asked for until then (docs/spec/unit-timing.md).
  std::optional<Cycle> owed_until = std::nullopt;
};

struct UnitFault {
  std::string what;  ///< one sentence with cycle, waiting fragment and line or tag
  Cycle cycle = 0;
};

/// Of one frame; cycles count from the unit's reset or, in later frames, from the frame's start
/// (the unit is idle in between, and cycle 0 is the first in which a fragment may be offered).
struct UnitFrameResult {
  std::vector<Cycle> taken;     ///< cycle in which each pixel left, in order
  std::vector<Cycle> answered;  ///< cycle of each response, in request order
  reference::UnitCounters counters;
  std::vector<reference::UnitPixel> pixels;  ///< RTL only; the others' are the reference's
  std::optional<UnitFault> fault;            ///< set: the run ended there
};

/// Cycles in which nothing moves, though the output was ready, after which a fault is reported.
inline constexpr Cycle kPatience = 100000;

}  // namespace ptm::pipeline
