#pragma once
#include <map>
#include <span>
#include <vector>

#include "model/pipeline/memory_timing.h"
#include "testbench/rtl/verilated_unit.h"

/// Frames driven pin by pin, so that they can be left in the middle.
namespace ptm::tests {

/// Answers to requests from before a reset, in the order in which they were asked for: the first
/// comes in cycle `first`, the others `step` cycles after each other, with lines of ones that could
/// not be read.
struct LateAnswers {
  std::vector<std::uint8_t> tags;
  pipeline::Cycle first = 0, step = 1;
  [[nodiscard]] std::optional<pipeline::Cycle> last() const {
    if (tags.empty()) return std::nullopt;
    return first + step * (tags.size() - 1);
  }
};

struct PinFrame {
  std::vector<pipeline::Cycle> taken, answered;
  std::vector<reference::UnitPixel> pixels;
  std::vector<std::uint8_t> owed;  ///< tags that were asked for and not answered at the end
};

/// A frame from now on, cycle 0 being the next: fragments as fast as they are accepted, pixels
/// taken at once, requests answered as `memory` says, until all pixels are out or `end` cycles have
/// passed.
template <class Unit>
PinFrame run_pins(Unit& unit, const reference::UnitState& state,
                  std::span<const reference::UnitFragment> fragments,
                  pipeline::MemoryTiming& memory, const LateAnswers& late, pipeline::Cycle end) {
  struct Asked {
    std::uint8_t tag;
    std::uint32_t line;
  };
  memory.reset();
  PinFrame out;
  std::map<pipeline::Cycle, Asked> due;
  std::size_t sent = 0, late_sent = 0;
  for (pipeline::Cycle cycle = 0; cycle < end && out.pixels.size() < fragments.size(); ++cycle) {
    testbench::RtlUnitPins pins;
    pins.valid = sent < fragments.size();
    if (pins.valid) pins.fragment = fragments[sent];
    if (late_sent < late.tags.size() && cycle == late.first + late.step * late_sent) {
      pins.response = true;
      pins.tag = late.tags[late_sent++];
      pins.line.fill(~0U);
      pins.failed = true;
    } else if (const auto now = due.find(cycle); now != due.end()) {
      pins.response = true;
      pins.tag = now->second.tag;
      pins.line = state.memory.at(now->second.line);
      pins.failed = state.failed.contains(now->second.line);
      due.erase(now);
    }
    const testbench::RtlUnitSeen seen = unit.cycle(pins);
    if (pins.valid && seen.ready) ++sent;
    if (seen.request) {
      const pipeline::Cycle done = memory.line(out.answered.size(), seen.line, cycle);
      out.answered.push_back(done);
      due.insert({done, {seen.tag, seen.line}});
    }
    if (seen.pixel_valid) {
      out.taken.push_back(cycle);
      out.pixels.push_back(seen.pixel);
    }
  }
  for (const auto& [cycle, asked] : due) out.owed.push_back(asked.tag);
  return out;
}

/// The registers of a state, and the wait for the check of its draws, after a reset. The caches are
/// left as the reset left them.
template <class Unit>
void write_registers(Unit& unit, const reference::UnitState& state) {
  for (const auto& w : reference::register_writes(state)) unit.write(w.address, w.data);
  for (int cycle = 0; cycle < 4 * 27; ++cycle) unit.write(0x1000, 2);  // clears the counters
}

}  // namespace ptm::tests
