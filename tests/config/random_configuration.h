#pragma once
#include <algorithm>
#include <map>
#include <random>
#include <string>

#include "model/reference/unit/unit_config.h"

/// Random configurations, as texts by name.
namespace ptm::tests {

/// Legal parameters of evaluator and unit. It knows no range: it tries values until the contract
/// takes them, one parameter after another.
inline std::map<std::string, std::string> random_parameters(std::mt19937_64& rng) {
  using namespace reference;
  EvalConfig eval;
  UnitConfig unit;
  const auto draw = [&](auto& config, const ParameterRow& row, std::size_t index) {
    using Table = ParameterTable<std::remove_reference_t<decltype(config)>>;
    const std::int64_t before = Table::get(config, index);
    for (int tries = 0; tries < 200; ++tries) {
      const bool number = row.kind == ParameterKind::number;
      // Small numbers are as likely as large ones: ranges end at 4 and at 1,024.
      const std::int64_t most = std::int64_t{1} << rng() % 11;
      const auto value = number ? static_cast<std::int64_t>(rng() % 2048) % (2 * most + 1) - most
                                : static_cast<std::int64_t>(rng() % 2);
      Table::set(config, index, value);
      if (Table::get(config, index) == value && !unit_fault(eval, unit)) return;
    }
    Table::set(config, index, before);
  };
  // What others need comes before them now and then, so in random order.
  std::vector<std::pair<bool, std::size_t>> order;
  for (std::size_t i = 0; i < ParameterTable<EvalConfig>::kCount; ++i) order.emplace_back(true, i);
  for (std::size_t i = 0; i < ParameterTable<UnitConfig>::kCount; ++i) order.emplace_back(false, i);
  std::shuffle(order.begin(), order.end(), rng);
  for (const auto& [of_eval, i] : order) {
    if (of_eval) {
      draw(eval, ParameterTable<EvalConfig>::rows()[i], i);
    } else {
      draw(unit, ParameterTable<UnitConfig>::rows()[i], i);
    }
  }
  std::map<std::string, std::string> all;
  for (std::size_t i = 0; i < ParameterTable<EvalConfig>::kCount; ++i) {
    const ParameterRow& row = ParameterTable<EvalConfig>::rows()[i];
    all[std::string(row.name)] = parameter_text(row, ParameterTable<EvalConfig>::get(eval, i));
  }
  for (std::size_t i = 0; i < ParameterTable<UnitConfig>::kCount; ++i) {
    const ParameterRow& row = ParameterTable<UnitConfig>::rows()[i];
    all[std::string(row.name)] = parameter_text(row, ParameterTable<UnitConfig>::get(unit, i));
  }
  return all;
}

}  // namespace ptm::tests
