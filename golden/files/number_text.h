#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

/// Numbers in header lines, the same in every locale.
namespace ptm::golden {

/// A whole decimal integer in [low, high] and nothing else; a leading + is allowed.
[[nodiscard]] std::optional<std::int64_t> parse_integer(std::string_view text, std::int64_t low,
                                                        std::int64_t high);

/// A whole finite decimal number and nothing else; a leading + is allowed. "nan", "inf" and numbers
/// that a double cannot hold give nothing.
[[nodiscard]] std::optional<double> parse_real(std::string_view text);

/// The same with a decimal comma in place of the point, as programs of many countries write it; the
/// comma stands between digits. A number without a comma gives nothing: ask parse_real() first.
[[nodiscard]] std::optional<double> parse_decimal_comma(std::string_view text);

/// The shortest decimal text that reads back as the same double, always with a point or an
/// exponent: "2.0", "0.1", "1e-30". Old readers take a plain number for granted, so an exponent
/// appears only outside [1e-5, 1e9).
[[nodiscard]] std::string format_real(double value);

/// Text from a file made fit for one line of a message: at most 40 bytes, odd ones as \xHH.
[[nodiscard]] std::string quoted(std::string_view text);

}  // namespace ptm::golden
