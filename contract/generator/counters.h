#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "contract/generator/registers.h"

/// The table of counters, read and checked: contract/counters.toml says what its keys mean.
namespace ptm::contract {

struct Counter {
  std::string name, need;
  unsigned number = 0;
  bool spared = false;
};

/// A row of the table: a counter, or several that repeat.
struct CounterRow {
  std::string name, meaning, need, page;
  unsigned number = 0;
  bool spared = false;
  std::vector<Repeat> repeats{};
};

struct Counters {
  std::vector<CounterRow> rows;
  std::vector<Counter> all;  ///< by number
};

/// Throws TableError; numbers begin at 0 and leave none out.
[[nodiscard]] Counters read_counters(const std::filesystem::path& file,
                                     const std::vector<std::string>& parameters);

}  // namespace ptm::contract
