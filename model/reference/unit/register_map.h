#pragma once
#include <array>
#include <cstdint>

#include "model/reference/eval_config.h"
#include "model/reference/unit/unit_config.h"

/// The register port's addresses, and what they hold: docs/spec/unit.md and docs/spec/effects.md,
/// "Registers". Twin: rtl/ptm_unit_registers.sv.
namespace ptm::reference {

namespace registers {
// Draws: 64 d and on
inline constexpr unsigned kDrawStride = 64, kMapBase = 16, kColorBase = 32;
inline constexpr std::uint16_t kCommand = 0x1000;      ///< kInvalidate, kClear
inline constexpr std::uint16_t kMemoryLines = 0x1001;  ///< what draws are checked against
inline constexpr std::uint16_t kErrors = 0x1002;       ///< error bits of draw d at 8 d
inline constexpr std::uint16_t kState = 0x1003;        ///< [0] busy, [1] a tag nobody waits for
inline constexpr std::uint16_t kMemoryBase = 0x1004;   ///< added to every request's line
inline constexpr std::uint16_t kEvents = 0x1008;       ///< bits of events; written 1s clear them
inline constexpr std::uint16_t kEnable = 0x1009;       ///< which of them raise the interrupt
inline constexpr std::uint16_t kMagic = 0x1010, kVersion = 0x1011, kCapabilities = 0x1012;
inline constexpr unsigned kCounters = 0x2000;  ///< counter n: + 2 n the low half, then the high one
inline constexpr unsigned kSets = 0x2800, kTables = 0x3000;
inline constexpr unsigned kLrgbPalettes = 0x4000, kRgbPalette = 0x8000;

inline constexpr std::uint32_t kInvalidate = 1, kClear = 2;  ///< bits of a command
}  // namespace registers

/// Bits of the event register and of its enable register.
namespace events {
inline constexpr std::uint32_t kIdle = 1;        ///< the last pixel of what was inside was taken
inline constexpr std::uint32_t kDrawError = 2;   ///< a draw's check ended with errors
inline constexpr std::uint32_t kWrongTag = 4;    ///< a response came that nobody waits for
inline constexpr std::uint32_t kFailedLine = 8;  ///< a response said its line could not be read
inline constexpr std::uint32_t kRefused = 16;    ///< a write came while fragments were inside
inline constexpr std::uint32_t kAll = 31;
}  // namespace events

inline constexpr std::uint32_t kRegisterMagic = 0x50544d55;       ///< "PTMU"
inline constexpr std::uint32_t kRegisterMapVersion = 0x00010000;  ///< major [31:16], minor
inline constexpr std::size_t kCapabilityWords = 8;

/// What the registers from kCapabilities on read in a unit of those parameters, which must be
/// valid.
[[nodiscard]] std::array<std::uint32_t, kCapabilityWords> capability_words(const EvalConfig& config,
                                                                           const UnitConfig& unit);

/// The bits of an address that hold what was written there and read as it: of all other bits and
/// addresses 0. (What the unit itself writes, as states, events and counters, is not among them.)
[[nodiscard]] std::uint32_t stored_bits(std::uint16_t address, const UnitConfig& unit);

}  // namespace ptm::reference
