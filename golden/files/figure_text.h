#pragma once
#include <concepts>
#include <string>
#include <string_view>

/// Figures and counts as people read them, in messages and reports.
namespace ptm::golden {

/// A number that was printed already, and its noun: "1 level", "0.5 levels", "2 passes". Only the
/// text "1" takes the singular. The plural is the noun with -s; with -es if it ends in s, x, ch or
/// sh; and with -ies for a y that stands behind a consonant.
[[nodiscard]] std::string count_of(std::string_view number, std::string_view noun);

/// The same of an integer, printed as it is.
template <std::integral Number>
[[nodiscard]] std::string count_of(Number number, std::string_view noun) {
  return count_of(std::string_view(std::to_string(number)), noun);
}

/// Four significant digits, without zeros at the end: "16.11", "0.5", "1.2e-05", "nan".
[[nodiscard]] std::string four_digits(double value);

/// The same of a bound, which is not negative: rounded up, so that what is printed holds too.
[[nodiscard]] std::string four_digits_bound(double bound);

}  // namespace ptm::golden
