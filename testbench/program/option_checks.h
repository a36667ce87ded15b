#pragma once
#include <CLI/CLI.hpp>
#include <limits>
#include <string>

#include "golden/files/number_text.h"

namespace ptm::testbench {

/// For options without a sign. CLI11 2.1 takes "-5" as 2^64 - 5 and anything larger than 2^64 as
/// 2^64 - 1; both are wrong usage here.
inline CLI::Validator whole_number() {
  return CLI::Validator(
      [](std::string& text) {
        constexpr std::int64_t most = std::numeric_limits<std::int64_t>::max();
        if (golden::parse_integer(text, 0, most)) return std::string();
        return "'" + text + "' is not a whole number from 0 to " + std::to_string(most);
      },
      "NUMBER", "whole number");
}

}  // namespace ptm::testbench
