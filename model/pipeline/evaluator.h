#pragma once
#include <systemc>

#include "model/pipeline/pixel.h"
#include "model/pipeline/registers.h"
#include "model/pipeline/stream.h"

namespace ptm::pipeline {

struct PixelBeat {
  PixelId id;
  Pixel pixel;
};

/// When the evaluator takes beats and gives pixels; values apart.
class EvaluatorTime {
 public:
  static constexpr std::size_t kRegisters = 7;
  static constexpr std::size_t kFifoDepth = 2;

  /// `completes`: the beat's pixel leaves with it. `out(cycle)` is told from which cycle on that
  /// pixel is offered, and says when it is taken. Returns the cycle in which the beat is taken.
  template <class Out>
  Cycle accept(bool completes, Cycle offered, Out&& out) {
    return registers_.accept(offered, [&](Cycle in_last_register) {
      return completes ? fifo_.accept(in_last_register, out) : in_last_register;
    });
  }

 private:
  RegisterChain<kRegisters> registers_;
  TimedFifo<kFifoDepth> fifo_;
};

/// The evaluator: seven pipeline registers and an output FIFO of two.
///
/// Values    ptm::reference::evaluate_luminance, color_scale, color_direct; this class owns time.
/// Latency   8 cycles from the transfer in to valid at the output, when nothing stalls.
/// Rate      one beat a cycle. A pixel of an RGB map is three beats; its first two leave the last
///           register for the assembly register unconditionally, the third pushes the pixel.
/// Capacity  9 beats when the output is stalled.
/// Twin      rtl/evaluator/ptm_evaluator.sv, equal in every cycle
/// (tests/pipeline/evaluator_chain_test.cpp)
class Evaluator final : public sc_core::sc_module, public StreamTarget<EvaluatorBeat> {
 public:
  sc_core::sc_export<StreamTarget<EvaluatorBeat>> in{"in"};
  sc_core::sc_port<StreamTarget<PixelBeat>> out{"out"};

  Evaluator(const sc_core::sc_module_name& name, const reference::EvalConfig& config);

  Cycle accept(const EvaluatorBeat& beat, Cycle offered) override;

  /// Back to the state after reset, for the next frame.
  void reset();

  struct Counters {
    std::uint64_t multiplies = 0;     ///< 11 an LRGB beat, 8 a pass of an RGB map
    std::uint64_t input_stalled = 0;  ///< cycles in which a beat was offered and not taken
    Cycle first_accepted = 0;
    std::uint64_t beats = 0;
  };
  [[nodiscard]] const Counters& counters() const { return counters_; }

 private:
  [[nodiscard]] bool shade(const EvaluatorBeat& beat);

  reference::EvalConfig config_;
  EvaluatorTime time_;
  PixelBeat assembled_;
  Counters counters_;
};

}  // namespace ptm::pipeline
