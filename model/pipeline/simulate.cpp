#include "model/pipeline/simulate.h"

#include <systemc>
#include <utility>

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

  EvaluatorChain(const reference::EvalConfig& config, const StreamTiming& timing,
                 PixelSink::Taker take)
      : evaluator("evaluator", config), sink("sink", timing, std::move(take)) {
    evaluator.out(sink.in);
  }

  void reset() {
    evaluator.reset();
    sink.reset();
  }

  /// The cycle after the last pixel was taken.
  [[nodiscard]] Cycle end() const {
    return sink.counters().pixels == 0 ? 0 : sink.counters().last_taken + 1;
  }

  [[nodiscard]] FrameResult result(Cycle first_fragment) const {
    FrameResult frame;
    const Evaluator::Counters& counters = evaluator.counters();
    frame.first_operand = counters.first_accepted;
    if (end() != 0) {
      frame.total_cycles = end() - first_fragment;
      frame.evaluator_cycles = end() - frame.first_operand;
    }
    frame.multiplies = counters.multiplies;
    frame.input_stalled = counters.input_stalled;
    frame.output_blocked = sink.counters().output_blocked;
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

/// Runs the evaluator on as many beats as `make` yields.
template <class Make>
FrameResult run_chain(const reference::EvalConfig& config, const StreamTiming& timing,
                      std::uint64_t beats, const PixelTaker& take, const Make& make) {
  EvaluatorChain chain(config, timing, take);
  Cycle first = 0;
  Source<EvaluatorBeat> source("source", timing, clock_period(), [&](auto& self) {
    first = self.send(beats, make);
    self.pass(chain.end());
  });
  source.out(chain.evaluator.in);
  start_simulation();
  return chain.result(first);
}

/// Keeps what a taker is given.
struct Keeper {
  std::vector<Pixel> pixels;
  std::vector<Cycle> cycles;

  void reserve(std::size_t count) {
    pixels.reserve(count);
    cycles.reserve(count);
  }
  [[nodiscard]] PixelTaker taker() {
    return [this](std::uint64_t, const Pixel& pixel, Cycle cycle) {
      pixels.push_back(pixel);
      cycles.push_back(cycle);
    };
  }
  void move_to(FrameResult& frame) {
    frame.pixels = std::exchange(pixels, {});
    frame.cycles = std::exchange(cycles, {});
  }
};

template <class Operands>
FrameResult keep_all(const reference::EvalConfig& config, std::span<const Operands> operands,
                     const StreamTiming& timing) {
  Keeper keeper;
  keeper.reserve(operands.size());
  const std::function<const Operands&(std::uint64_t)> source =
      [&](std::uint64_t n) -> const Operands& { return operands[n]; };
  FrameResult frame = stream_evaluator(config, operands.size(), source, keeper.taker(), timing);
  keeper.move_to(frame);
  return frame;
}

}  // namespace

void simulate_unit(const reference::EvalConfig& config, const UnitConfig& unit,
                   const reference::StoredTexture& texture, const FrameStream& frames,
                   const StreamTiming& timing) {
  const TextureDescriptor descriptor{reference::layout_of(config, texture), texture.bias,
                                     texture.shift};
  const auto words = reference::pack_texture(descriptor.layout, texture);
  Keeper keeper;
  EvaluatorChain chain(config, timing, keeper.taker());
  IdealMemory memory("memory", words, clock_period());
  WordFetch fetch("fetch", unit.tmus, descriptor, clock_period());
  Source<Fragment> source("source", timing, clock_period(), [&](auto& self) {
    for (std::size_t frame = 0; frame < frames.count; ++frame) {
      const std::span<const Fragment> fragments = frames.make(frame);
      keeper.reserve(fragments.size());
      chain.reset();
      fetch.reset();
      const Cycle first = self.send(
          fragments.size(), [&](std::uint64_t n) -> const Fragment& { return fragments[n]; });
      FrameResult result = chain.result(first);
      keeper.move_to(result);
      result.words_fetched = fetch.words_fetched();
      self.pass(chain.end());
      frames.take(frame, std::move(result));
    }
  });
  source.out(fetch.in);
  fetch.out(chain.evaluator.in);
  for (auto& socket : fetch.tmu) socket.bind(memory.socket);
  start_simulation();
}

FrameResult stream_evaluator(const reference::EvalConfig& config, std::uint64_t pixels,
                             const LrgbSource& source, const PixelTaker& take,
                             const StreamTiming& timing) {
  return run_chain(config, timing, pixels, take,
                   [&](std::uint64_t n) { return beat_of(source(n)); });
}

FrameResult stream_evaluator(const reference::EvalConfig& config, std::uint64_t pixels,
                             const RgbSource& source, const PixelTaker& take,
                             const StreamTiming& timing) {
  const RgbOperands<>* operands = nullptr;
  return run_chain(config, timing, pixels * 3, take, [&](std::uint64_t n) {
    if (n % 3 == 0) operands = &source(n / 3);
    return beat_of(*operands, static_cast<unsigned>(n % 3));
  });
}

FrameResult simulate_evaluator(const reference::EvalConfig& config,
                               std::span<const LrgbOperands<>> operands,
                               const StreamTiming& timing) {
  return keep_all(config, operands, timing);
}

FrameResult simulate_evaluator(const reference::EvalConfig& config,
                               std::span<const RgbOperands<>> operands,
                               const StreamTiming& timing) {
  return keep_all(config, operands, timing);
}

}  // namespace ptm::pipeline

/// SystemC's library has a main() that wants this; the project's programs have their own and start
/// the simulation themselves.
int sc_main(int, char*[]) {
  SC_REPORT_ERROR("ptm::pipeline", "sc_main is not an entry point of this program");
  return 1;
}
