#pragma once
#include <array>
#include <cstdint>

#include "contract/registers.h"
#include "model/reference/eval_config.h"
#include "model/reference/unit/unit_config.h"

/// The register port's addresses, and what they hold: docs/spec/unit.md and docs/spec/effects.md,
/// "Registers". Twin: rtl/registers/ptm_registers.sv.
namespace ptm::reference {

/// Addresses, made of contract/registers.toml.
namespace registers {
using namespace contract::registers;
/// Bits of a command.
inline constexpr std::uint32_t kInvalidate = contract::fields::command::kInvalidate.mask();
inline constexpr std::uint32_t kClear = contract::fields::command::kClear.mask();
inline constexpr unsigned kCounters = kCounterBlock;  ///< counter n: + 2 n the low half
inline constexpr unsigned kSets = kSetBlock, kTables = kTableBlock;
inline constexpr unsigned kLrgbPalettes = kLrgbPaletteBlock, kRgbPalette = kRgbPaletteBlock;
}  // namespace registers
namespace fields = contract::fields;

/// Bits of the event register and of its enable register.
namespace events {
inline constexpr std::uint32_t kIdle = fields::events::kIdle.mask();
inline constexpr std::uint32_t kDrawError = fields::events::kDrawError.mask();
inline constexpr std::uint32_t kWrongTag = fields::events::kWrongTag.mask();
inline constexpr std::uint32_t kFailedLine = fields::events::kFailedLine.mask();
inline constexpr std::uint32_t kRefused = fields::events::kRefused.mask();
inline constexpr std::uint32_t kAll = fields::events::kAll;
static_assert(kAll == fields::enable::kEvents.mask());
}  // namespace events

inline constexpr std::uint32_t kRegisterMagic = fields::magic::kReset;  ///< "PTMU"
inline constexpr std::uint32_t kRegisterMapVersion = fields::version::kReset;
using contract::registers::kCapabilityWords;

/// What the registers from kCapabilities on read in a unit of those parameters, which must be
/// valid.
[[nodiscard]] std::array<std::uint32_t, kCapabilityWords> capability_words(const EvalConfig& config,
                                                                           const UnitConfig& unit);

/// The bits of an address that hold what was written there and read as it: of all other bits and
/// addresses 0. (What the unit itself writes, as states, events and counters, is not among them.)
[[nodiscard]] std::uint32_t stored_bits(std::uint16_t address, const UnitConfig& unit,
                                        const EvalConfig& config = {});

}  // namespace ptm::reference
