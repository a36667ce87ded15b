#pragma once
#include <nlohmann/json.hpp>
#include <string>

#include "golden/files/figure_text.h"

namespace ptm::testbench {

/// A figure of a command's JSON as its text prints it: four significant digits, integers in full, a
/// list's in brackets, null as "none".
[[nodiscard]] inline std::string figure(const nlohmann::ordered_json& value) {
  if (value.is_null()) return "none";
  if (value.is_array()) {
    std::string list;
    for (const auto& part : value) list += (list.empty() ? "" : ", ") + figure(part);
    return "[" + list + "]";
  }
  if (!value.is_number_float()) return value.dump();
  return golden::four_digits(value.get<double>());
}

}  // namespace ptm::testbench
