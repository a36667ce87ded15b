#pragma once
#include "model/pipeline/unit/palette.h"

namespace ptm::pipeline {

/// F: reads the data banks of each TMU as the beat leaves for D.
///
/// The way from here to the sink is the same for every beat that nothing holds up. If one passed
/// so, the next that is a whole fragment of one pass does too, for it comes at least a cycle later:
/// no register on the way can bind it, nor what comes behind it. So such a beat's pixel is booked
/// at once, and the registers are left with older items, which bind as little.
class Fetch final : public sc_core::sc_module {
 public:
  /// `sink` is where `out` ends; `stalls`: it refuses in some cycles.
  Fetch(const sc_core::sc_module_name& name, Palette& out, UnitSink& sink, bool stalls)
      : sc_module(name), out_(out), sink_(sink), stalls_(stalls) {}

  /// F accepts from this cycle on.
  [[nodiscard]] Cycle free() const { return free_; }
  /// The beat's transfer into F, not before free().
  template <bool kEffects>
  void accept(const UnitBeat& beat, Cycle enter) {
    const bool plain = beat.last && beat.draw->beats_alone;
    if (plain && clear_) [[likely]] {
      sink_.taken.push_back(enter + kWay);
      free_ = enter + 1;
      return;
    }
    free_ = out_.accept<kEffects>(beat, enter + 1);
    clear_ = plain && !stalls_ && sink_.taken.back() == enter + kWay;
  }
  void reset() {
    free_ = 0;
    clear_ = false;
  }

 private:
  static constexpr Cycle kWay = 18;  // D, Q, P, L1 to L3, O, seven and the FIFO, C1, C2, pixel

  Palette& out_;
  UnitSink& sink_;
  bool stalls_;
  Cycle free_ = 0;
  bool clear_ = false;  ///< the last beat was such a fragment, and nothing held it up
};

}  // namespace ptm::pipeline
