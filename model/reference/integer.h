#pragma once
#include <cstddef>
#include <cstdint>

namespace ptm::reference {

/// Steps of the contract, as groups under which a counting type books its operations.
enum class Step : std::uint8_t {
  unpack,          ///< D1
  basis,           ///< D2
  products,        ///< D3
  align,           ///< D4
  sum,             ///< D5
  luminance,       ///< D6
  color_products,  ///< D7, the three multiplies
  color_scale,     ///< D7, the division by 255
  narrow,          ///< the adders of rounding, wherever it stands
  lerp,            ///< Eq. 14
  wrap,            ///< U3
  scale,           ///< U4
  probes,          ///< U9
  combine,         ///< U11
  power,           ///< X2
  modulate,        ///< X3
  add,             ///< X4
};

/// The datapath is written once, for any integer type that has +, -, * and these functions, found
/// by argument-dependent lookup. std::int64_t holds every intermediate over all stated ranges; a
/// counting type counts (tests/reference/operation_count_test.cpp); a symbolic one can write the
/// netlist. Hence no `if` on data anywhere in the datapath.
using Value = std::int64_t;

/// x / 2^n rounded down; n >= 0, data or constant.
[[nodiscard]] constexpr Value shift_right(Value x, Value n) { return x >> n; }
/// x * 2^n; n >= 0 and constant.
[[nodiscard]] constexpr Value shift_left(Value x, int n) { return x * (Value{1} << n); }
/// Half a unit of 2^n, floor(2^n / 2): 0 for n = 0.
[[nodiscard]] constexpr Value half_of(Value n) { return (Value{1} << n) >> 1; }
[[nodiscard]] constexpr Value smaller(Value a, Value b) { return a < b ? a : b; }
[[nodiscard]] constexpr Value larger(Value a, Value b) { return a < b ? b : a; }
/// 1 if a != b, else 0.
[[nodiscard]] constexpr Value differs(Value a, Value b) { return a != b ? 1 : 0; }
/// 1 if either flag is 1.
[[nodiscard]] constexpr Value either(Value a, Value b) { return a | b; }

/// An entry of a table of constants; index within it.
template <class Table>
[[nodiscard]] constexpr Value look_up(const Table& table, Value index) {
  return Value{table[static_cast<std::size_t>(index)]};
}

/// Says which step the operations in its scope belong to. Nothing for plain integers.
template <class Int>
struct StepScope {
  constexpr explicit StepScope(Step) {}
};

}  // namespace ptm::reference
