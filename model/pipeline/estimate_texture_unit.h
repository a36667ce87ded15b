#pragma once
#include "model/pipeline/unit_run.h"

/// Timing `loose` of the whole texture unit, free of SystemC; callable as often as one likes.
namespace ptm::pipeline {

struct UnitEstimate {
  std::uint64_t fragments = 0;
  std::uint64_t cycles = 0;      ///< first fragment accepted to last pixel taken
  std::uint64_t beats = 0;       ///< expected
  std::uint64_t lines_read = 0;  ///< expected
};

/// How long a frame takes from cold caches (keep_cache is not looked at), from a few of its
/// fragments.
///
/// A span is a run of fragments of one draw, neighbours in x, up to the next multiple of `tile`.
/// Its first and last fragment are looked at, and between them one for each tile of texels that
/// they are apart. Their tiles go through the caches, their misses to the memory; the fragments
/// between are taken to need what the one before them needed. A span whose ends have the tiles of
/// the last one's, where that one missed nothing, is taken to miss nothing. Time runs in two
/// places, at the tags and at the commit stage: they are held apart by FIFO and ring, and the
/// commit stage goes at the pace of what binds, beats, passes or palette.
///
/// Assumes   neighbours in a span belong together (no edges within it); a seam that splits is met
///           as often as its share of the texels. Gaps and stalls count by their mean.
/// Error     total cycles within 3 % of `exact` on scenes of 65,536 fragments and more without
///           random stalls (tests/pipeline/estimate_test.cpp)
/// Requires  a valid configuration, legal draws, fragments that name one of them; tile >= 1.
[[nodiscard]] UnitEstimate estimate_texture_unit(const reference::UnitConfig& unit,
                                                 const reference::UnitState& state,
                                                 const UnitFrame& frame, const MemoryModel& memory,
                                                 int tile = 16, const StreamTiming& timing = {},
                                                 const reference::EvalConfig& eval = {});

}  // namespace ptm::pipeline
