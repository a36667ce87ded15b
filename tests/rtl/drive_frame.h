#pragma once
#include <bit>
#include <map>
#include <optional>
#include <random>
#include <set>
#include <span>
#include <vector>

#include "testbench/rtl/verilated_unit.h"

/// Frames driven pin by pin, of a unit or of a recording of one (four_state.h), with what a memory
/// may do at its port and what it may not.
namespace ptm::tests {

struct Drive {
  std::uint64_t seed = 1;
  std::uint64_t limit = 100'000;  ///< cycles after which it ends in any case
  std::uint64_t blocked = 0;      ///< before that cycle no pixel is taken
  bool stalls = false;            ///< later, neither pixels nor requests are taken every cycle
  unsigned latency_max = 30;      ///< a request is answered 1 to so many cycles later,
  bool answers_at_once = false;   ///< half of them in the cycle in which they are taken instead
  bool strays = false;            ///< answers come whose tags nobody waits for
};

struct DrivenFrame {
  std::vector<testbench::RtlUnitSeen> seen;  ///< of every cycle
  std::vector<std::uint64_t> accepted;       ///< cycles in which fragments were, from 0 on
  std::vector<reference::UnitPixel> pixels;
  std::vector<std::uint8_t> requests;  ///< tags, in order
  std::vector<std::uint8_t> strays;    ///< tags
  std::size_t aliases = 0;             ///< strays that equal an awaited tag in its low bits
  std::size_t at_once = 0;             ///< answers in the cycle of their request
};

/// Tags that nobody waits for: any, and often one that equals an awaited one in the `low` lowest
/// bits, if tags have more.
inline std::optional<std::uint8_t> stray_tag(const std::set<std::uint8_t>& awaited, unsigned low,
                                             std::uint64_t random) {
  auto tag = static_cast<std::uint8_t>(random);
  if (low < 8 && (random >> 8) % 2 == 0 && !awaited.empty()) {
    const auto number = static_cast<std::ptrdiff_t>((random >> 9) % awaited.size());
    const auto others = (1U << (8 - low)) - 1;
    const unsigned high = (1 + static_cast<unsigned>(random >> 32) % others) << low;
    tag = static_cast<std::uint8_t>(*std::next(awaited.begin(), number) ^ high);
  }
  if (awaited.contains(tag)) return std::nullopt;
  return tag;
}

/// A frame from now on, cycle 0 being the next: fragments offered until they are accepted, until
/// all pixels are out. `slots` is the ring's size. Without strays it drives, cycle by cycle, what
/// it drives with them otherwise.
template <class Unit>
DrivenFrame drive_frame(Unit& unit, const reference::UnitState& state,
                        std::span<const reference::UnitFragment> fragments, unsigned slots,
                        const Drive& drive) {
  struct Asked {
    std::uint8_t tag;
    std::uint32_t line;
  };
  std::mt19937_64 rng(drive.seed);
  std::multimap<std::uint64_t, Asked> due;
  std::set<std::uint8_t> awaited;
  DrivenFrame out;
  for (std::uint64_t cycle = 0; cycle < drive.limit && out.pixels.size() < fragments.size();
       ++cycle) {
    const testbench::RtlUnitSeen before = unit.seen();
    testbench::RtlUnitPins pins;
    pins.valid = out.accepted.size() < fragments.size();
    if (pins.valid) pins.fragment = fragments[out.accepted.size()];
    const std::uint64_t stalled = drive.stalls ? rng() : 1;
    pins.pixel_ready = cycle >= drive.blocked && stalled % 4 != 0;
    pins.request_ready = stalled % 5 != 0;
    const bool taken = before.request && pins.request_ready;
    const std::uint64_t wait = rng(), stray = rng();
    if (taken) {
      out.requests.push_back(before.tag);
      awaited.insert(before.tag);
      const bool now = drive.answers_at_once && wait % 2 == 0;
      due.insert(
          {now ? cycle : cycle + 1 + wait / 2 % drive.latency_max, {before.tag, before.line}});
    }
    if (const auto next = due.begin(); next != due.end() && next->first <= cycle) {
      const std::uint32_t line = (next->second.line - state.base) & reference::kOuterMask;
      pins.response = true;
      pins.tag = next->second.tag;
      pins.line = state.memory.at(line);
      pins.failed = state.failed.contains(line);
      out.at_once += taken && pins.tag == before.tag;
      awaited.erase(pins.tag);
      due.erase(next);
    } else if (drive.strays && stray % 2 == 0) {
      const auto low = static_cast<unsigned>(std::bit_width(slots - 1));
      if (const auto tag = stray_tag(awaited, low, stray / 2)) {
        pins.response = pins.failed = true;
        pins.tag = *tag;
        pins.line.fill(~0U);
        out.strays.push_back(*tag);
        out.aliases += awaited.contains(static_cast<std::uint8_t>(*tag % (1U << low)));
      }
    }
    const testbench::RtlUnitSeen seen = unit.cycle(pins);
    out.seen.push_back(seen);
    if (pins.valid && seen.ready) out.accepted.push_back(cycle);
    if (seen.pixel_valid && pins.pixel_ready) out.pixels.push_back(seen.pixel);
  }
  return out;
}

}  // namespace ptm::tests
