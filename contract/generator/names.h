#pragma once
#include <cstdint>
#include <string>
#include <string_view>

/// Names and numbers of the tables as each language writes them. Names of the tables are words of
/// small letters and digits with underscores between.
namespace ptm::contract {

/// "lrgb_palette" as "LrgbPalette".
[[nodiscard]] std::string camel(std::string_view name);
/// "lrgb_palette" as "LRGB_PALETTE".
[[nodiscard]] std::string upper(std::string_view name);
/// 0x1000 as "0x1000", of at least that many digits.
[[nodiscard]] std::string hex(std::uint64_t value, int digits);
/// Bits of a field that holds 0 to count - 1; at least 1.
[[nodiscard]] unsigned bits_for(std::uint64_t count);
[[nodiscard]] constexpr bool is_power_of_two(std::uint64_t value) {
  return value != 0 && (value & (value - 1)) == 0;
}
/// "[4:0]", or "[7]" of one bit.
[[nodiscard]] std::string bit_range(unsigned low, unsigned width);

}  // namespace ptm::contract
