#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "model/pipeline/stream_timing.h"
#include "model/reference/evaluate.h"

/// The RTL evaluator as plain C++: no Verilator header is needed to use it.
namespace ptm::testbench {

/// A pixel as the RTL gives it.
struct RtlPixel {
  std::array<std::uint16_t, 3> lum{};  ///< what each channel was made from; LRGB: three times one
  std::array<std::uint8_t, 3> out{};
  bool lum_saturated = false;  ///< RGB map: any channel's
  bool color_saturated = false;

  /// Field by field: comparing memory just written in smaller pieces stalls the processor, and
  /// this runs in every cycle.
  friend constexpr bool operator==(const RtlPixel& a, const RtlPixel& b) {
    bool same = (a.lum_saturated == b.lum_saturated) & (a.color_saturated == b.color_saturated);
    for (unsigned c = 0; c < 3; ++c) same &= (a.lum[c] == b.lum[c]) & (a.out[c] == b.out[c]);
    return same;
  }
};

/// The same pixel as the reference gives it. Inline, so that the compiler drops the rest of the
/// trace.
[[nodiscard]] inline RtlPixel to_pixel(const reference::LrgbTrace<>& trace) {
  RtlPixel pixel;
  const auto& lum = trace.luminance.lum;
  for (unsigned c = 0; c < 3; ++c) {
    pixel.lum[c] = static_cast<std::uint16_t>(lum.lum);
    pixel.out[c] = static_cast<std::uint8_t>(trace.color.out[c]);
  }
  pixel.lum_saturated = lum.saturated != 0;
  pixel.color_saturated = trace.color.saturated != 0;
  return pixel;
}
[[nodiscard]] inline RtlPixel to_pixel(const reference::RgbTrace<>& trace) {
  RtlPixel pixel;
  for (unsigned c = 0; c < 3; ++c) {
    pixel.lum[c] = static_cast<std::uint16_t>(trace.channel[c].lum.lum);
    pixel.out[c] = static_cast<std::uint8_t>(trace.color.out[c]);
  }
  pixel.lum_saturated = trace.lum_saturated != 0;
  pixel.color_saturated = trace.color.saturated != 0;
  return pixel;
}

/// Counters of one run; names and meanings are the pipeline model's.
struct RtlCounters {
  std::uint64_t cycles = 0;          ///< first beat accepted to last pixel taken, inclusive
  std::uint64_t input_stalled = 0;   ///< cycles with an operand offered and not accepted
  std::uint64_t output_blocked = 0;  ///< cycles with a pixel offered and not taken
  std::uint64_t beats = 0;           ///< operands accepted: one an LRGB pixel, three an RGB one
  std::uint64_t pixels = 0;
};

struct RtlRun {
  std::vector<RtlPixel> pixels;
  std::vector<std::uint64_t> taken;  ///< the cycle in which each pixel is taken; 0 is after reset
  RtlCounters counters;
};

/// The stage registers as one operand set passes through them; names of docs/spec/datapath.md.
struct RtlTrace {
  reference::LuminanceTrace<reference::Value> luminance;
  reference::Three<reference::Value> product{};
  reference::Color<reference::Value> color{};  ///< RGB map: this pass's channel in all three places
};
/// d0..d5, uu, vv, uv, p0..p5, t0..t5, acc, lum, lum_saturated, product_r.., out_r.., and
/// color_saturated, in this order.
[[nodiscard]] std::vector<std::pair<std::string, reference::Value>> named_values(
    const RtlTrace& trace);

/// The pins in one clock cycle, for tests of timing.
struct RtlPins {
  bool valid = false;
  bool ready = true;
  reference::LrgbOperands<> operands{};
  bool rgb_map = false;
  unsigned channel = 0;
  std::uint32_t sideband = 0;
};
/// What is seen in that cycle, before the edge at its end.
struct RtlSeen {
  bool ready = false;  ///< the operand is accepted if it is valid
  bool valid = false;  ///< a pixel is offered
  RtlPixel pixel{};    ///< of no meaning if not valid
  std::uint32_t sideband = 0;
};

/// The RTL broke the stream's protocol: it hangs, or gives a pixel out of order, twice or too many.
/// The message says cycle and item.
class RtlProtocolError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// One Verilated variant. Every run starts with a reset. Not to be shared between threads.
///
/// Sources are called once a pixel, in order; what they return must live until the next call.
/// Sinks are called once a pixel, in order, with the cycle in which it is taken.
class RtlEvaluator {
 public:
  using LrgbSource = std::function<const reference::LrgbOperands<>&(std::uint64_t pixel)>;
  using RgbSource = std::function<const reference::RgbOperands<>&(std::uint64_t pixel)>;
  using Sink = std::function<void(std::uint64_t pixel, const RtlPixel&, std::uint64_t cycle)>;

  virtual ~RtlEvaluator() = default;

  [[nodiscard]] virtual std::string_view name() const = 0;

  /// Streams of any length, nothing is kept. Throws RtlProtocolError; std::invalid_argument if the
  /// timing's probabilities lie outside their ranges.
  virtual RtlCounters stream_lrgb(std::uint64_t pixels, const pipeline::StreamTiming& timing,
                                  const LrgbSource& source, const Sink& sink) = 0;
  virtual RtlCounters stream_rgb(std::uint64_t pixels, const pipeline::StreamTiming& timing,
                                 const RgbSource& source, const Sink& sink) = 0;

  /// The same with everything kept.
  [[nodiscard]] RtlRun run(std::span<const reference::LrgbOperands<>> operands,
                           const pipeline::StreamTiming& timing);
  [[nodiscard]] RtlRun run(std::span<const reference::RgbOperands<>> operands,
                           const pipeline::StreamTiming& timing);

  /// One operand set through the empty pipeline, every stage register read as it arrives there.
  [[nodiscard]] RtlTrace trace(const reference::LrgbOperands<>& operands);
  [[nodiscard]] std::array<RtlTrace, 3> trace(const reference::RgbOperands<>& operands);

  /// Cycle by cycle.
  virtual void reset() = 0;
  virtual RtlSeen cycle(const RtlPins& pins) = 0;
  /// A register or constant as it stands between two cycles; numbers in testbench/rtl/probe.h.
  [[nodiscard]] virtual reference::Value probe(std::uint8_t number) = 0;

 private:
  RtlTrace trace_pass(const RtlPins& pins);
};

/// The evaluator of those parameters: one that comes with the build, else one that is built first
/// and kept (variant_cache.h, whose exceptions it throws).
[[nodiscard]] std::unique_ptr<RtlEvaluator> make_rtl_evaluator(const reference::EvalConfig& config);
/// Whether it comes with the build.
[[nodiscard]] bool has_rtl_evaluator(const reference::EvalConfig& config);

/// The lerp of Eq. 14: both roundings, for 8-bit and for 16-bit stored values.
class RtlLerp {
 public:
  virtual ~RtlLerp() = default;
  /// Requires a, b < 2^width; width 8 or 16; f < 256.
  [[nodiscard]] virtual unsigned operator()(reference::Rounding rounding, int width, unsigned a,
                                            unsigned b, unsigned f) = 0;
};
[[nodiscard]] std::unique_ptr<RtlLerp> make_rtl_lerp();

}  // namespace ptm::testbench
