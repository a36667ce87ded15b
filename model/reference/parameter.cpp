#include "model/reference/parameter.h"

#include <algorithm>
#include <charconv>

namespace ptm::reference {
namespace {

std::string listed(std::span<const std::string_view> words) {
  std::string list;
  for (const std::string_view word : words) list.append(list.empty() ? "" : ", ").append(word);
  return list;
}

}  // namespace

std::string parameter_text(const ParameterRow& row, std::int64_t value) {
  if (row.kind == ParameterKind::flag) return value != 0 ? "true" : "false";
  if (row.kind == ParameterKind::choice) {
    return std::string(row.choices[static_cast<std::size_t>(value)]);
  }
  return std::to_string(value);
}

std::optional<std::int64_t> parse_parameter(const ParameterRow& row, std::string_view text) {
  if (row.kind == ParameterKind::flag) {
    if (text == "true") return 1;
    if (text == "false") return 0;
    return {};
  }
  if (row.kind == ParameterKind::choice) {
    const auto found = std::find(row.choices.begin(), row.choices.end(), text);
    if (found == row.choices.end()) return {};
    return found - row.choices.begin();
  }
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return {};
  return value;
}

std::string expected_text(const ParameterRow& row) {
  if (row.kind == ParameterKind::flag) return "true or false";
  if (row.kind == ParameterKind::choice) return "one of " + listed(row.choices);
  return "a whole number";
}

std::optional<ParameterFault> outside(std::string_view name, std::int64_t value, std::int64_t low,
                                      std::int64_t high) {
  return breaks(name, value, value >= low && value <= high,
                std::to_string(low) + " to " + std::to_string(high));
}

std::optional<ParameterFault> not_among(std::string_view name, std::int64_t value,
                                        std::initializer_list<std::int64_t> values) {
  if (std::find(values.begin(), values.end(), value) != values.end()) return {};
  std::string list;
  for (const std::int64_t v : values) list += (list.empty() ? "" : ", ") + std::to_string(v);
  return breaks(name, value, false, "one of " + list);
}

std::optional<ParameterFault> beyond_mask(std::string_view name, std::int64_t value,
                                          std::int64_t mask) {
  return breaks(name, value, (value & ~mask) == 0,
                "a part of " + std::to_string(mask) + ", the stages of this build");
}

std::optional<ParameterFault> breaks(std::string_view name, std::int64_t value, bool holds,
                                     std::string_view expected) {
  if (holds) return {};
  return ParameterFault{std::string(name), std::to_string(value), std::string(expected)};
}

}  // namespace ptm::reference
