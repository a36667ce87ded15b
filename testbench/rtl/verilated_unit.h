#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>

#include "model/pipeline/unit_run.h"
#include "model/reference/unit/unit_config.h"
#include "model/reference/unit/unit_memory.h"
#include "testbench/rtl/verilated_evaluator.h"

/// The RTL texture unit as plain C++: no Verilator header is needed to use it.
namespace ptm::testbench {

/// What a unit refuses to draw from: the status register (docs/spec/unit.md, "Registers").
class RtlUnitRefusal : public std::runtime_error {
 public:
  RtlUnitRefusal(const std::string& what, std::uint32_t bits)
      : std::runtime_error(what), status(bits) {}
  std::uint32_t status;  ///< error bits of draw d at [8 d + 3 : 8 d]
};

/// The pins in one clock cycle, for tests of timing.
struct RtlUnitPins {
  bool valid = false;
  reference::UnitFragment fragment{};
  bool pixel_ready = true;
  bool request_ready = true;
  bool response = false;
  std::uint8_t tag = 0;
  reference::Line line{};
  bool failed = false;  ///< the line could not be read
  std::optional<reference::RegisterWrite> write = std::nullopt;
};
/// What is seen in that cycle, before the edge at its end.
struct RtlUnitSeen {
  bool ready = false;  ///< the fragment is accepted if it is valid
  bool pixel_valid = false;
  reference::UnitPixel pixel{};  ///< of no meaning if not valid
  bool request = false;
  std::uint32_t line = 0;
  std::uint8_t tag = 0;
  bool interrupt = false;
};

/// One Verilated variant of the whole unit. Not to be shared between threads.
class RtlUnit {
 public:
  virtual ~RtlUnit() = default;

  [[nodiscard]] virtual std::string_view name() const = 0;

  /// Resets the unit, writes the state's registers one a cycle, waits for the check of the draws,
  /// and keeps a copy of the memory. Throws RtlUnitRefusal if a draw is illegal; the unit then
  /// accepts no fragment until a legal state is loaded.
  virtual void load(const reference::UnitState& state) = 0;

  /// One frame: invalidates the caches unless keep_cache, clears the counters, sends the fragments
  /// as `timing` says (gap() idle cycles before each, counted from the transfer of the one before),
  /// takes pixels except in cycles that are stalled(), and answers requests as `memory` says, whose
  /// state it resets first. Cycle 0 is the first in which a fragment may be offered.
  ///
  /// A memory fault, or kPatience cycles without a transfer at any port, ends the run: the result's
  /// fault names cycle, the fragment at K and the line it waits for; the next run or load starts
  /// from a reset. Requires a successful load(), and fragments that name one of its draws.
  /// Throws RtlProtocolError if the unit gives a pixel too many or reads beyond the memory.
  virtual pipeline::UnitFrameResult run(
      const pipeline::UnitFrame& frame, pipeline::MemoryTiming& memory,
      const pipeline::StreamTiming& timing,
      const std::optional<pipeline::MemoryFault>& fault = std::nullopt) = 0;

  /// From the next run on, the memory makes a request wait in a cycle with this probability
  /// (`exact` knows only 0). Pixels stay the same; requires 0 <= probability < 1.
  virtual void stall_requests(double probability, std::uint64_t seed) = 0;

  /// One cycle of reset, whatever the unit holds, with nothing offered to it: of the unit alone, or
  /// of the memory too, which then forgets the requests that it has not answered. The registers are
  /// to be written again.
  virtual void reset(bool memory_too) = 0;
  /// What the cycle that begins now will show at its ports, whatever its inputs are.
  [[nodiscard]] virtual RtlUnitSeen seen() const = 0;
  /// Cycle by cycle, after load().
  virtual RtlUnitSeen cycle(const RtlUnitPins& pins) = 0;
  virtual void write(std::uint16_t address, std::uint32_t data) = 0;  ///< takes a cycle
  [[nodiscard]] virtual std::uint32_t read(std::uint16_t address) = 0;
  [[nodiscard]] virtual reference::UnitCounters counters() = 0;
  /// A wire as it stands between two cycles; numbers in testbench/rtl/unit_probe.h.
  [[nodiscard]] virtual std::uint32_t probe(std::uint8_t number) = 0;
};

/// The unit of those parameters. Where none comes with the build it is built first, once
/// (variant_cache.h, whose errors this throws).
[[nodiscard]] std::unique_ptr<RtlUnit> make_rtl_unit(const reference::EvalConfig& config,
                                                     const reference::UnitConfig& unit);

}  // namespace ptm::testbench
