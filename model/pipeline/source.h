#pragma once
#include <functional>
#include <systemc>

#include "model/pipeline/stream.h"

namespace ptm::pipeline {

/// Offers items in order, each `gap` idle cycles after the one before was taken. Its thread is the
/// only process of the model: it runs `script`, and the blocks advance inside its calls.
template <class Item>
class Source final : public sc_core::sc_module {
 public:
  using Script = std::function<void(Source&)>;

  sc_core::sc_port<StreamTarget<Item>> out{"out"};

  SC_HAS_PROCESS(Source);
  Source(const sc_core::sc_module_name& name, const StreamTiming& timing,
         const sc_core::sc_time& clock, Script script)
      : sc_module(name), timing_(timing), clock_(clock), script_(std::move(script)) {
    SC_THREAD(run);
  }

  /// Sends one frame from a unit after reset: make(n) for n = 0 .. count - 1, in order. Returns the
  /// cycle in which the first item was taken.
  template <class Make>
  Cycle send(std::uint64_t count, Make&& make) {
    Cycle first = 0;
    Cycle next = 0;
    for (std::uint64_t n = 0; n < count; ++n) {
      const Cycle taken = out->accept(make(n), next + gap(timing_, n));
      if (n == 0) first = taken;
      next = taken + 1;
    }
    return first;
  }

  /// Lets simulated time catch up with the cycles that a frame took.
  void pass(Cycle cycles) { wait(sc_core::sc_time::from_value(cycles * clock_.value())); }

 private:
  void run() { script_(*this); }

  StreamTiming timing_;
  sc_core::sc_time clock_;
  Script script_;
};

}  // namespace ptm::pipeline
