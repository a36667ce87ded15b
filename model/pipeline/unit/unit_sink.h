#pragma once
#include <systemc>
#include <vector>

#include "model/pipeline/stream_timing.h"

namespace ptm::pipeline {

/// Takes pixels in order and keeps their cycles; refuses in the cycles that `timing` says.
class UnitSink final : public sc_core::sc_module {
 public:
  UnitSink(const sc_core::sc_module_name& name, const StreamTiming& timing)
      : sc_module(name), timing_(timing) {}

  Cycle accept(Cycle offered) {
    Cycle cycle = offered;
    while (stalled(timing_, cycle)) ++cycle;
    taken.push_back(cycle);
    return cycle;
  }

  std::vector<Cycle> taken;

 private:
  StreamTiming timing_;
};

}  // namespace ptm::pipeline
