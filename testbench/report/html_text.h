#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

/// Text and figures as the report's page prints them.
namespace ptm::testbench {

struct FrameLight;  // testbench/run/run_result.h

/// Text that may stand between tags and inside quoted attributes: & < > " ' are escaped, control
/// characters other than tab and newline become U+FFFD.
[[nodiscard]] std::string html_escape(std::string_view text);
[[nodiscard]] std::string base64(std::span<const std::uint8_t> bytes);  ///< RFC 4648, padded
[[nodiscard]] std::string png_uri(std::span<const std::uint8_t> png);   ///< data:image/png;...

[[nodiscard]] std::string fixed(double value, int digits);  ///< 57.49
[[nodiscard]] std::string grouped(std::uint64_t value);     ///< 786,432
/// A measured number, not negative: four significant digits, zeros at the end included, so that
/// figures of a column line up: 0.5581, 3.500, 14.00, 12,346 from 1,000 on. 0 is "0".
[[nodiscard]] std::string significant(double value);
[[nodiscard]] std::string decibels(double psnr);  ///< 57.49 dB, 101.3 dB; infinity: "∞ dB"
/// Errors in 8-bit levels: an integer as it is, else four significant digits.
[[nodiscard]] std::string levels(double error);
[[nodiscard]] std::string share(double part);        ///< 12.35 %, the same about zero
[[nodiscard]] std::string similarity(double ssim);   ///< 0.99751, and 1 for equal pictures only
[[nodiscard]] std::string duration(double seconds);  ///< 1.24 s, 12.4 ms, 310 us
/// "(lu, lv) = (-1.000, 0.250)", "direction (0.000, -0.600, 0.800)", "position (...)"; numbers
/// unbroken.
[[nodiscard]] std::string light_text(const FrameLight& light);
[[nodiscard]] std::string plural(std::size_t count, const std::string& noun);  ///< "1 light"

}  // namespace ptm::testbench
