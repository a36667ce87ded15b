#pragma once
#include "model/pipeline/unit/palette.h"

namespace ptm::pipeline {

/// The register F: reads the data banks of each TMU as the beat leaves for D.
///
/// A shortcut spares most beats the way through the blocks behind F. A *plain* beat is a whole
/// fragment with one evaluator pass, so it spends one cycle in each register from D to the output.
/// If a plain beat was held up nowhere, its pixel was taken kWay cycles after the beat entered F.
/// A plain beat that comes next enters F at least a cycle later, so it finds each register on the
/// way already emptied and is not held up either: its pixel is entered in the sink at once. The
/// blocks behind F then still remember an older beat as their last one. That changes no cycle: in
/// every register a beat that took the shortcut is at least a cycle ahead of all that come after
/// it, so none of them would have waited for it.
class Fetch final : public sc_core::sc_module {
 public:
  /// `sink` takes the pixels that come out behind `out`. `stalls`: the sink refuses them in some
  /// cycles, so the shortcut must not be taken.
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
  /// Cycles from the transfer into F to that of the pixel, one for each register in between: F, D,
  /// Q, P, L1, L2, L3, O, the evaluator's seven and its FIFO, C1, C2.
  static constexpr Cycle kWay = 18;

  Palette& out_;
  UnitSink& sink_;
  bool stalls_;
  Cycle free_ = 0;
  bool clear_ = false;  ///< the last beat was plain, and was held up nowhere
};

}  // namespace ptm::pipeline
