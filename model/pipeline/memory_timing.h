#pragma once
#include <cstdint>
#include <memory>
#include <variant>

#include "contract/memory_config.h"
#include "model/pipeline/stream_timing.h"

/// When a memory answers. One class for the pipeline model and the RTL's test bench
/// (docs/spec/unit-timing.md, "Memory"); free of SystemC's headers.
namespace ptm::pipeline {

inline constexpr Cycle kNever = ~Cycle{0};

class MemoryTiming {
 public:
  virtual ~MemoryTiming() = default;
  MemoryTiming() = default;
  MemoryTiming(const MemoryTiming&) = delete;
  MemoryTiming& operator=(const MemoryTiming&) = delete;

  /// The cycle in which the line asked for in `cycle` arrives, later than `cycle` and different
  /// from every earlier answer; kNever if it never does. Called once a request, in order:
  /// `index` counts from 0, `cycle` rises.
  virtual Cycle line(std::uint64_t index, std::uint32_t address, Cycle cycle) = 0;
  /// Back to the state before the first request.
  virtual void reset() = 0;
};

// FixedMemory, DramMemory and RandomMemory are generated from contract/parameters.toml.
//
// FixedMemory: done = max(cycle + latency, previous done + interval).
//
// DramMemory: page p = address / page_lines is row p / banks of bank p mod banks. A request's
// commands start when it comes and its bank has read for the one before (`burst` cycles after that
// read), each in the earliest cycle that the following allow:
//
//     row open     read at once
//     none open    activate, tRCD later read
//     other open   precharge (tRAS after its activation at the earliest), tRP later activate
//     tRC          a bank's activations are tRAS + tRP apart, whatever closed the row between them
//     bus          data follow CL after the read on one bus, in request order, `burst` cycles a
//                  line; a read waits until its data find the bus free
//     refresh      none of the commands lies in the first tRFC cycles of each tREFI (the first one
//                  excepted); tRFC includes the closing of every row. Data of a read given before
//                  still arrive. Commands that would not all come before a refresh come after it.
//
// The answer arrives `overhead` cycles after the last data.
//
// RandomMemory: latencies hashed from (seed, index); one whose cycle is another's already takes the
// next free cycle.

/// A fault for tests: what happens to the request of that index.
struct MemoryFault {
  enum class Kind : std::uint8_t { never, wrong_tag };
  Kind kind = Kind::never;
  std::uint64_t index = 0;
};

using MemoryModel = std::variant<FixedMemory, DramMemory, RandomMemory>;

/// All throw std::invalid_argument, naming the field, where a parameter is outside its range:
/// within it every answer is later than its request and no two share a cycle.
[[nodiscard]] std::unique_ptr<MemoryTiming> make_memory(const FixedMemory& memory);
[[nodiscard]] std::unique_ptr<MemoryTiming> make_memory(const DramMemory& memory);
[[nodiscard]] std::unique_ptr<MemoryTiming> make_memory(const RandomMemory& memory);
[[nodiscard]] std::unique_ptr<MemoryTiming> make_memory(const MemoryModel& memory);

}  // namespace ptm::pipeline
