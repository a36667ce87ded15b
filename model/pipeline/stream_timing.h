#pragma once
#include <cstdint>

namespace ptm::pipeline {

using Cycle = std::uint64_t;  ///< 0 is the first cycle after reset

/// Random gaps before a unit's inputs and stalls at its output, the same for every model: pure
/// hashes of (seed, item or cycle), never a running generator (docs/spec/unit-timing.md, T7).
struct StreamTiming {
  std::uint64_t seed = 0;
  double input_gap = 0;     ///< probability that an operand keeps the unit waiting
  double output_stall = 0;  ///< probability that the sink refuses in a cycle; below 1
  /// What a source that is slower than the unit adds: idle cycles before every `group`-th item.
  Cycle idle = 0;
  unsigned group = 1;
};

/// SplitMix64's finaliser over two words (Steele, Lea, Flood 2014).
[[nodiscard]] constexpr std::uint64_t hash(std::uint64_t seed, std::uint64_t index) {
  std::uint64_t z = seed * 0xD1B54A32D192ED03ULL + (index + 1) * 0x9E3779B97F4A7C15ULL;
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ULL;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBULL;
  return z ^ (z >> 31);
}

[[nodiscard]] constexpr bool chance(std::uint64_t hashed, double probability) {
  return static_cast<double>(hashed >> 11) < probability * 0x1p53;
}

/// Idle cycles before item n is offered, after item n - 1 was accepted: the source's own, and at
/// random none or 1 to 4 more.
[[nodiscard]] constexpr Cycle gap(const StreamTiming& timing, std::uint64_t item) {
  const Cycle own = timing.idle != 0 && item % timing.group == 0 ? timing.idle : 0;
  if (timing.input_gap <= 0) return own;
  const std::uint64_t h = hash(timing.seed, item);
  return own + (chance(h, timing.input_gap) ? 1 + hash(h, 1) % 4 : 0);
}

/// Whether the sink refuses in this cycle.
[[nodiscard]] constexpr bool stalled(const StreamTiming& timing, Cycle cycle) {
  if (timing.output_stall <= 0) return false;
  return chance(hash(~timing.seed, cycle), timing.output_stall);
}

}  // namespace ptm::pipeline
