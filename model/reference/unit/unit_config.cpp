#include "model/reference/unit/unit_config.h"

#include <algorithm>
#include <initializer_list>
#include <stdexcept>
#include <string>

#include "model/reference/effects/stages.h"

namespace ptm::reference {
namespace {

void require_range(const char* field, int value, int low, int high) {
  if (value >= low && value <= high) return;
  throw std::invalid_argument(std::string(field) + " = " + std::to_string(value) + ", expected " +
                              std::to_string(low) + " to " + std::to_string(high));
}

void require_one_of(const char* field, int value, std::initializer_list<int> values) {
  if (std::find(values.begin(), values.end(), value) != values.end()) return;
  std::string all;
  for (const int v : values) all += (all.empty() ? "" : ", ") + std::to_string(v);
  throw std::invalid_argument(std::string(field) + " = " + std::to_string(value) +
                              ", expected one of " + all);
}

}  // namespace

void validate(const UnitConfig& config) {
  require_range("tmus", config.tmus, 1, 3);
  require_one_of("cache_kib", config.cache_kib, {1, 2, 4, 8, 16, 32, 64});
  require_one_of("ways", config.ways, {1, 2, 4});
  require_range("fragment_fifo", config.fragment_fifo, 4, 1024);
  require_range("miss_fifo", config.miss_fifo, 4 * config.tmus, 256);
  require_one_of("palette_lrgb_ports", config.palette_lrgb_ports, {1, 2, 4});
  require_one_of("palette_rgb_ports", config.palette_rgb_ports, {1, 2, 4});
  require_one_of("eval_lanes", config.eval_lanes, {1, 3});
  require_range("extra_passes", config.extra_passes, 0, kExtraPasses);
  require_range("extra_sets", config.extra_sets, 0, std::min(config.extra_passes, kExtraSets));
  require_range("half_vector", config.half_vector ? 1 : 0, 0, config.extra_passes > 0 ? 1 : 0);
  require_range("duplicate_lines", config.duplicate_lines ? 1 : 0, 0, config.counters ? 1 : 0);
  if ((config.stages & ~effects::kStages) != 0) {
    throw std::invalid_argument("stages = " + std::to_string(config.stages) +
                                ", expected a part of " + std::to_string(effects::kStages) +
                                ", the stages of this build");
  }
}

}  // namespace ptm::reference
