#pragma once
#include "model/pipeline/unit/address.h"

namespace ptm::pipeline {

/// The whole texture unit in time: one module a block, none with a process of its own. Each call
/// advances the blocks by one fragment; their state is maxima over earlier cycles.
///
/// Source    docs/spec/unit-timing.md
/// Values    ptm::reference::shade; this class owns time and counters
/// Twin      rtl/ptm_unit.sv, equal in every pixel's cycle and every counter
class TextureUnit final : public sc_core::sc_module {
 public:
  /// Requires a valid configuration (reference::validate) and legal draws.
  TextureUnit(const sc_core::sc_module_name& name, const reference::UnitConfig& unit,
              const std::vector<reference::Draw>& draws, const StreamTiming& timing,
              const std::optional<MemoryFault>& fault, const sc_core::sc_time& clock,
              const reference::EvalConfig& eval = {});

  MemoryPort memory;

  /// One frame, from now on in simulation time. The caller lets time catch up: `end` of the result.
  struct Frame {
    UnitFrameResult result;
    Cycle end = 0;  ///< the cycle after the last that anything happened in
  };
  [[nodiscard]] Frame run(const UnitFrame& frame, Cycle patience);

 private:
  void reset(const UnitFrame& frame);
  /// What of the fragments was accepted.
  struct Feed {
    std::uint64_t accepted = 0;
    Cycle first = 0, last = 0;
  };
  template <bool kEffects>
  Feed feed(std::span<const reference::UnitFragment> fragments);
  [[nodiscard]] Feed feed_with_effects(std::span<const reference::UnitFragment> fragments);
  void report_counters(Frame& frame, std::uint64_t accepted, Cycle first);
  void report_draws(reference::UnitCounters& counters) const;
  void report_fault(Frame& frame, Cycle last_accepted, Cycle patience);

  reference::UnitConfig unit_;
  StreamTiming timing_;
  UnitSink sink_;
  EffectChain chain_;
  Combine combine_;
  UnitEvaluator evaluator_;
  Filter filter_;
  Palette palette_;
  Fetch fetch_;
  Commit commit_;
  MissRing ring_;
  Tags tags_;
  Address address_;
};

}  // namespace ptm::pipeline
