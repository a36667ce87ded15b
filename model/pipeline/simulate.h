#pragma once
#include <functional>
#include <span>
#include <vector>

#include "model/pipeline/pixel.h"
#include "model/pipeline/stream_timing.h"
#include "model/reference/evaluate.h"
#include "model/reference/fragment.h"
#include "model/reference/texture_words.h"

/// The pipeline model's entry points, free of SystemC's headers. SystemC elaborates once a process:
/// call one of these once, in a process of its own (testbench/run/child_process.h).
namespace ptm::pipeline {

/// One frame: pixels in the order of their fragments, and the cycle in which each was taken.
struct FrameResult {
  std::vector<Pixel> pixels;
  std::vector<Cycle> cycles;           ///< absolute, from reset at the frame's start
  std::uint64_t total_cycles = 0;      ///< first fragment accepted to last pixel taken, inclusive
  std::uint64_t evaluator_cycles = 0;  ///< the same from the first operand accepted
  Cycle first_operand = 0;             ///< the cycle in which that was
  std::uint64_t words_fetched = 0;
  std::uint64_t multiplies = 0;
  std::uint64_t input_stalled = 0;   ///< cycles an operand was offered and not taken
  std::uint64_t output_blocked = 0;  ///< cycles a pixel was offered and not taken
};

struct UnitConfig {
  int tmus = 3;  ///< words fetched in a cycle; 1..3
};

/// The frames that a unit draws: made and taken one at a time, so that memory stays bounded.
struct FrameStream {
  std::size_t count = 0;
  std::function<std::span<const reference::Fragment>(std::size_t frame)> make;
  std::function<void(std::size_t frame, FrameResult&& result)> take;
};

/// A texture unit for flat maps: fragments -> word fetch -> evaluator -> pixels, reset between
/// frames.
/// Requires  fragments inside the texture (u, v in [0, 1)), legal codes, a valid configuration.
void simulate_unit(const reference::EvalConfig& config, const UnitConfig& unit,
                   const reference::StoredTexture& texture, const FrameStream& frames,
                   const StreamTiming& timing = {});

/// Streams of any length through the evaluator alone, what rtl/evaluator/ptm_evaluator.sv is
/// compared with; nothing is kept. Sources are called once a pixel, in order; what they return must
/// live until the next call. The sink is called once a pixel, in order, with the cycle in which it
/// is taken. The result's `pixels` and `cycles` stay empty.
using LrgbSource = std::function<const reference::LrgbOperands<>&(std::uint64_t pixel)>;
using RgbSource = std::function<const reference::RgbOperands<>&(std::uint64_t pixel)>;
using PixelTaker = std::function<void(std::uint64_t pixel, const Pixel&, Cycle cycle)>;
FrameResult stream_evaluator(const reference::EvalConfig& config, std::uint64_t pixels,
                             const LrgbSource& source, const PixelTaker& take,
                             const StreamTiming& timing = {});
FrameResult stream_evaluator(const reference::EvalConfig& config, std::uint64_t pixels,
                             const RgbSource& source, const PixelTaker& take,
                             const StreamTiming& timing = {});

/// The same with everything kept.
[[nodiscard]] FrameResult simulate_evaluator(const reference::EvalConfig& config,
                                             std::span<const reference::LrgbOperands<>> operands,
                                             const StreamTiming& timing);
[[nodiscard]] FrameResult simulate_evaluator(const reference::EvalConfig& config,
                                             std::span<const reference::RgbOperands<>> operands,
                                             const StreamTiming& timing);

}  // namespace ptm::pipeline
