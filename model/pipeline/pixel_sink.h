#pragma once
#include <functional>
#include <systemc>

#include "model/pipeline/evaluator.h"

namespace ptm::pipeline {

/// Takes pixels in order and hands each on with its cycle; refuses in the cycles that `timing`
/// says.
class PixelSink final : public sc_core::sc_module, public StreamTarget<PixelBeat> {
 public:
  using Taker = std::function<void(std::uint64_t pixel, const Pixel&, Cycle cycle)>;

  sc_core::sc_export<StreamTarget<PixelBeat>> in{"in"};

  PixelSink(const sc_core::sc_module_name& name, const StreamTiming& timing, Taker take)
      : sc_module(name), timing_(timing), take_(std::move(take)) {
    in.bind(*this);
  }

  Cycle accept(const PixelBeat& beat, Cycle offered) override {
    Cycle taken = offered;
    while (stalled(timing_, taken)) ++taken;
    counters_.output_blocked += taken - offered;
    counters_.last_taken = taken;
    take_(counters_.pixels++, beat.pixel, taken);
    return taken;
  }

  void reset() { counters_ = {}; }

  struct Counters {
    std::uint64_t pixels = 0;
    std::uint64_t output_blocked = 0;  ///< cycles in which a pixel was offered and not taken
    Cycle last_taken = 0;
  };
  [[nodiscard]] const Counters& counters() const { return counters_; }

 private:
  StreamTiming timing_;
  Taker take_;
  Counters counters_;
};

}  // namespace ptm::pipeline
