#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "model/reference/unit/draw.h"
#include "tests/rtl/unit_back_bench.h"

/// The cycles of docs/spec/unit-timing.md from D to the pixel, by recurrence over items in order.
namespace ptm::tests {

/// Look-up cycles of a beat or sub-beat in D.
inline std::uint64_t look_up_cycles(const reference::UnitConfig& unit, const reference::Draw& draw,
                                    const BackBeat& beat) {
  using reference::TextureFormat;
  const bool lrgb = draw.format == TextureFormat::palette_lrgb;
  if ((!lrgb && draw.format != TextureFormat::palette_rgb) || beat.group != 0) return 1;
  const int ports = lrgb ? unit.palette_lrgb_ports : unit.palette_rgb_ports;
  int taps = 0;
  for (unsigned t = 0; t < 4; ++t) taps += (beat.taps[0] >> t & 1U) != 0;
  return static_cast<std::uint64_t>(std::max(1, (taps + ports - 1) / ports));
}

class BackSchedule {
 public:
  /// ready(c): the pixel that is offered in cycle c is taken.
  BackSchedule(const reference::UnitConfig& unit, std::function<bool(std::uint64_t)> ready)
      : unit_(unit), ready_(std::move(ready)) {}

  /// A beat stands in D from cycle `in_d` on; the cycle in which it leaves.
  std::uint64_t beat(const reference::Draw& draw, const BackBeat& beat, std::uint64_t in_d) {
    // filter_[0] is when Q was left: it accepts from that cycle on, until a whole beat enters it.
    const std::uint64_t left = std::max(in_d, filter_[0]) + look_up_cycles(unit_, draw, beat) - 1;
    if (!beat.sub_last) return left;
    // Q, P, L1, L2: when each is left by this beat. filter_[n] is when the beat before left it.
    std::uint64_t at = left;
    for (unsigned n = 0; n < kPlain; ++n) {
      at = std::max(at + 1, filter_[n + 1]);
      filter_[n] = at;
    }
    if (!beat.last) {
      filter_[kPlain] = at + 1;
      return left;
    }
    filter_[kPlain] = std::max(at + 1, o_left_);
    passes(reference::draw_passes(draw), filter_[kPlain] + 1);
    return left;
  }

  /// When each pixel was taken, so far.
  [[nodiscard]] const std::vector<std::uint64_t>& pixels() const { return pixels_; }

 private:
  static constexpr unsigned kPlain = 4;      // Q, P, L1, L2
  static constexpr unsigned kEvaluator = 7;  // R1 to R7

  /// The passes of a fragment that stands in O from cycle `at` on.
  void passes(int count, std::uint64_t at) {
    for (int pass = 0; pass < count; ++pass) {
      std::uint64_t in = std::max(at + static_cast<std::uint64_t>(pass), o_left_ + 1);
      in = std::max(in, stage_[0]);
      o_left_ = in;
      for (unsigned r = 0; r + 1 < kEvaluator; ++r) {
        in = std::max(in + 1, stage_[r + 1]);
        stage_[r] = in;
      }
      if (pass + 1 < count) {
        stage_[kEvaluator - 1] = in + 1;  // into the assembly register
      } else {
        in = std::max(in + 1, fifo_left_[0] + 1);  // the pixel before the last one has left
        stage_[kEvaluator - 1] = in;
        pixel(in);
      }
    }
  }

  /// A pixel enters the FIFO in cycle `in`.
  void pixel(std::uint64_t in) {
    const std::uint64_t popped = std::max({in + 1, fifo_left_[1] + 1, c1_left_});
    fifo_left_ = {fifo_left_[1], popped};
    c1_left_ = std::max(popped + 1, c2_left_);
    c2_left_ = c1_left_ + 1;
    while (!ready_(c2_left_)) ++c2_left_;
    pixels_.push_back(c2_left_);
  }

  reference::UnitConfig unit_;
  std::function<bool(std::uint64_t)> ready_;
  /// Cycles in which the item before left: Q, P, L1, L2, L3; O; R1 to R7; the FIFO (the one before
  /// it first); C1, C2. A register takes an item in the cycle in which it is left.
  std::array<std::uint64_t, kPlain + 1> filter_{};
  std::uint64_t o_left_ = 0;
  std::array<std::uint64_t, kEvaluator> stage_{};
  std::array<std::uint64_t, 2> fifo_left_{};
  std::uint64_t c1_left_ = 0, c2_left_ = 0;
  std::vector<std::uint64_t> pixels_;
};

}  // namespace ptm::tests
