#include "golden/files/figure_text.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace ptm::golden {
namespace {

bool hisses(std::string_view noun) {
  return noun.ends_with('s') || noun.ends_with('x') || noun.ends_with("ch") || noun.ends_with("sh");
}

/// Whether a final y becomes -ies: "entry", not "day".
bool changes_y(std::string_view noun) {
  if (noun.size() < 2 || !noun.ends_with('y')) return false;
  return std::string_view("aeiou").find(noun[noun.size() - 2]) == std::string_view::npos;
}

std::string plural_of(std::string_view noun) {
  if (changes_y(noun)) return std::string(noun.substr(0, noun.size() - 1)) + "ies";
  return std::string(noun) + (hisses(noun) ? "es" : "s");
}

}  // namespace

std::string count_of(std::string_view number, std::string_view noun) {
  return std::string(number) + " " + (number == "1" ? std::string(noun) : plural_of(noun));
}

std::string four_digits(double value) {
  std::array<char, 32> text{};
  const int length = std::snprintf(text.data(), text.size(), "%.4g", value);
  return {text.data(), static_cast<std::size_t>(length)};
}

std::string four_digits_bound(double bound) {
  std::string text = four_digits(bound);
  if (std::strtod(text.c_str(), nullptr) >= bound) return text;
  // Rounding to nearest lost half a unit of the fourth digit at most.
  return four_digits(bound + std::pow(10, std::floor(std::log10(bound)) - 3) / 2);
}

}  // namespace ptm::golden
