#include "model/pipeline/simulate.h"

#include <memory>
#include <systemc>

#include "model/pipeline/evaluator.h"
#include "model/pipeline/ideal_memory.h"
#include "model/pipeline/pixel_sink.h"
#include "model/pipeline/source.h"
#include "model/pipeline/word_fetch.h"

namespace ptm::pipeline {
namespace {

using reference::Fragment;
using reference::LrgbOperands;
using reference::RgbOperands;

/// Any unit will do: all times are whole multiples of it.
const sc_core::sc_time& clock_period() {
  static const sc_core::sc_time period(1, sc_core::SC_NS);
  return period;
}

/// Warnings are errors: a model that SystemC doubts is not a model to quote.
void start_simulation() {
  sc_core::sc_report_handler::set_actions(sc_core::SC_WARNING, sc_core::SC_THROW);
  sc_core::sc_start();
}

/// Evaluator and sink, the part that every simulation has.
struct EvaluatorChain {
  Evaluator evaluator;
  PixelSink sink;

  EvaluatorChain(const reference::EvalConfig& config, const StreamTiming& timing)
      : evaluator("evaluator", config), sink("sink", timing) {
    evaluator.out(sink.in);
  }

  void reset(std::size_t pixels) {
    evaluator.reset();
    sink.reset(pixels);
  }

  FrameResult result(Cycle first_fragment) {
    FrameResult frame;
    frame.pixels = std::move(sink.pixels());
    frame.cycles = std::move(sink.cycles());
    const auto& counters = evaluator.counters();
    frame.first_operand = counters.first_accepted;
    if (!frame.cycles.empty()) {
      frame.total_cycles = frame.cycles.back() + 1 - first_fragment;
      frame.evaluator_cycles = frame.cycles.back() + 1 - frame.first_operand;
    }
    frame.multiplies = counters.multiplies;
    frame.input_stalled = counters.input_stalled;
    frame.output_blocked = sink.output_blocked();
    return frame;
  }
};

EvaluatorBeat beat_of(const LrgbOperands<>& in) {
  EvaluatorBeat beat;
  beat.coef = in.coef;
  beat.bias = in.bias;
  beat.shift = in.shift;
  beat.rgb = in.rgb;
  beat.lu = in.lu;
  beat.lv = in.lv;
  return beat;
}

EvaluatorBeat beat_of(const RgbOperands<>& in, unsigned channel) {
  EvaluatorBeat beat;
  beat.coef = in.coef[channel];
  beat.bias = in.bias;
  beat.shift = in.shift;
  beat.lu = in.lu;
  beat.lv = in.lv;
  beat.rgb_map = true;
  beat.channel = channel;
  return beat;
}

/// Runs the evaluator on `count` beats that `make` yields.
template <class Make>
FrameResult run_chain(const reference::EvalConfig& config, const StreamTiming& timing,
                      std::uint64_t beats, std::size_t pixels, const Make& make) {
  EvaluatorChain chain(config, timing);
  Cycle first = 0;
  Source<EvaluatorBeat> source("source", timing, clock_period(), [&](auto& self) {
    chain.reset(pixels);
    first = self.send(beats, make);
    self.pass(chain.sink.cycles().empty() ? 0 : chain.sink.cycles().back() + 1);
  });
  source.out(chain.evaluator.in);
  start_simulation();
  return chain.result(first);
}

}  // namespace

void simulate_unit(const reference::EvalConfig& config, const UnitConfig& unit,
                   const reference::StoredTexture& texture, const FrameStream& frames,
                   const StreamTiming& timing) {
  const TextureDescriptor descriptor{reference::layout_of(config, texture), texture.bias,
                                     texture.shift};
  const auto words = reference::pack_texture(descriptor.layout, texture);
  EvaluatorChain chain(config, timing);
  IdealMemory memory("memory", words, clock_period());
  WordFetch fetch("fetch", unit.tmus, descriptor, clock_period());
  Source<Fragment> source("source", timing, clock_period(), [&](auto& self) {
    for (std::size_t frame = 0; frame < frames.count; ++frame) {
      const std::span<const Fragment> fragments = frames.make(frame);
      chain.reset(fragments.size());
      fetch.reset();
      const Cycle first = self.send(
          fragments.size(), [&](std::uint64_t n) -> const Fragment& { return fragments[n]; });
      FrameResult result = chain.result(first);
      result.words_fetched = fetch.words_fetched();
      self.pass(result.total_cycles);
      frames.take(frame, std::move(result));
    }
  });
  source.out(fetch.in);
  fetch.out(chain.evaluator.in);
  for (auto& socket : fetch.tmu) socket.bind(memory.socket);
  start_simulation();
}

FrameResult simulate_evaluator(const reference::EvalConfig& config,
                               std::span<const LrgbOperands<>> operands,
                               const StreamTiming& timing) {
  return run_chain(config, timing, operands.size(), operands.size(),
                   [&](std::uint64_t n) { return beat_of(operands[n]); });
}

FrameResult simulate_evaluator(const reference::EvalConfig& config,
                               std::span<const RgbOperands<>> operands,
                               const StreamTiming& timing) {
  return run_chain(config, timing, operands.size() * 3, operands.size(), [&](std::uint64_t n) {
    return beat_of(operands[n / 3], static_cast<unsigned>(n % 3));
  });
}

}  // namespace ptm::pipeline

/// SystemC's library has a main() that wants this; the project's programs have their own and start
/// the simulation themselves.
int sc_main(int, char*[]) {
  SC_REPORT_ERROR("ptm::pipeline", "sc_main is not an entry point of this program");
  return 1;
}
