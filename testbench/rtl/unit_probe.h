#pragma once
#include <cstdint>

/// What probe_o of testbench/sv/ptm_unit_tb.sv shows for each value of probe_i.
namespace ptm::testbench::unit_probe {

inline constexpr std::uint8_t kNone = 0;
inline constexpr std::uint8_t kHolds = 1;  ///< a beat stands at K
inline constexpr std::uint8_t kX = 2, kY = 3;
inline constexpr std::uint8_t kSlot = 4, kLine = 5;  ///< the first that K has not committed
inline constexpr std::uint8_t kParameters = 128;     ///< in order of rtl_parameters()

}  // namespace ptm::testbench::unit_probe
