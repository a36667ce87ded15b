#pragma once
#include <cstdint>

/// What probe_o of testbench/sv/ptm_evaluator_tb.sv shows for each value of probe_i. Values stand
/// in the stage register that holds them; where there are several, by index.
namespace ptm::testbench::probe {

inline constexpr std::uint8_t kNone = 0;
inline constexpr std::uint8_t kD = 1;  ///< R1: d0..d5
inline constexpr std::uint8_t kUu = 7;
inline constexpr std::uint8_t kVv = 8;
inline constexpr std::uint8_t kUv = 9;
inline constexpr std::uint8_t kP = 10;    ///< R2: p0..p5
inline constexpr std::uint8_t kT = 16;    ///< R3: t0..t5
inline constexpr std::uint8_t kAcc = 22;  ///< R4
inline constexpr std::uint8_t kLum = 23;  ///< R5
inline constexpr std::uint8_t kLumSaturated = 24;
inline constexpr std::uint8_t kProduct = 25;  ///< R6: red, green, blue
inline constexpr std::uint8_t kOut = 28;      ///< R7: red, green, blue
inline constexpr std::uint8_t kColorSaturated = 31;

inline constexpr std::uint8_t kWidths = 64;       ///< EvalWidths, in order of its members
inline constexpr int kWidthCount = 32;            ///< four, four of six each, four
inline constexpr std::uint8_t kParameters = 128;  ///< in order of rtl_parameters()

}  // namespace ptm::testbench::probe
