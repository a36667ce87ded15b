#include "testbench/compare/run_difference.h"

#include <array>
#include <cmath>
#include <limits>

namespace ptm::testbench {

std::string_view kind_name(DifferenceKind kind) {
  constexpr std::array<std::string_view, kDifferenceKinds> names{
      "structure", "configuration", "agreement", "pixels", "cycles",
      "counters",  "figures",       "lists",     "notes"};
  return names[static_cast<std::size_t>(kind)];
}

std::optional<double> RunDifference::amount() const {
  if (!a.is_number() || !b.is_number()) return {};
  // Counts of more than 53 bits keep their difference.
  if (a.is_number_unsigned() && b.is_number_unsigned()) {
    const auto x = a.get<std::uint64_t>(), y = b.get<std::uint64_t>();
    return x < y ? static_cast<double>(y - x) : -static_cast<double>(x - y);
  }
  return b.get<double>() - a.get<double>();
}

std::optional<double> RunDifference::relative() const {
  const std::optional<double> difference = amount();
  if (!difference) return {};
  const double whole = std::abs(a.get<double>());
  if (whole == 0) return std::copysign(std::numeric_limits<double>::infinity(), *difference);
  return *difference / whole;
}

}  // namespace ptm::testbench
