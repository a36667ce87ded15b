#include "golden/files/figure_text.h"

#include <array>
#include <cstdio>

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

}  // namespace ptm::golden
