#pragma once
#include "model/pipeline/unit/filter.h"

namespace ptm::pipeline {

/// D: holds the taps; a palettised map's are looked up here, as many a cycle as it has ports, in
/// cycles in which Q accepts. All that leaves D goes to Q's registers.
class Palette final : public sc_core::sc_module {
 public:
  Palette(const sc_core::sc_module_name& name, Filter& out) : sc_module(name), out_(out) {}

  /// Returns the cycle in which D takes the beat.
  template <bool kEffects>
  Cycle accept(const UnitBeat& beat, Cycle offered) {
    const Cycle enter = std::max(offered, free_);
    // Q stays empty until the beat is whole, so the look-up cycles follow each other.
    const Cycle leave = std::max(enter + 1, out_.free()) + look_up(beat) - 1;
    if (beat.completes) out_.accept<kEffects>(beat, leave);
    free_ = leave;
    return enter;
  }
  void reset() {
    free_ = 0;
    lookups_ = 0;
  }
  [[nodiscard]] std::uint64_t lookups() const { return lookups_; }

 private:
  /// Its look-up cycles, one at least.
  Cycle look_up(const UnitBeat& beat) {
    const unsigned ports = beat.plan->palette_ports;
    if (ports == 0) return 1;
    const auto taps = static_cast<unsigned>(std::popcount((*beat.tiles)[0].taps & beat.mask));
    lookups_ += taps;
    return std::max(1U, (taps + ports - 1) / ports);
  }

  Filter& out_;
  Cycle free_ = 0;
  std::uint64_t lookups_ = 0;
};

}  // namespace ptm::pipeline
