#include "model/reference/unit/unit_counters.h"

namespace ptm::reference {

const std::array<std::string_view, kUnitCounters>& unit_counter_names() {
  static constexpr std::array<std::string_view, kUnitCounters> kNames{"fragments",
                                                                      "pixels",
                                                                      "cycles",
                                                                      "cycles_moved",
                                                                      "cycles_output_blocked",
                                                                      "cycles_line_wait",
                                                                      "cycles_ring_full",
                                                                      "cycles_input_empty",
                                                                      "beats",
                                                                      "bank_conflicts",
                                                                      "words",
                                                                      "taps",
                                                                      "tag_hits",
                                                                      "tag_misses",
                                                                      "lines_read",
                                                                      "duplicate_lines",
                                                                      "palette_lookups",
                                                                      "multiplies_address",
                                                                      "multiplies_filter",
                                                                      "multiplies_eval",
                                                                      "multiplies_combine",
                                                                      "hits_d0_map",
                                                                      "misses_d0_map",
                                                                      "hits_d0_color",
                                                                      "misses_d0_color",
                                                                      "hits_d1_map",
                                                                      "misses_d1_map",
                                                                      "hits_d1_color",
                                                                      "misses_d1_color",
                                                                      "hits_d2_map",
                                                                      "misses_d2_map",
                                                                      "hits_d2_color",
                                                                      "misses_d2_color",
                                                                      "hits_d3_map",
                                                                      "misses_d3_map",
                                                                      "hits_d3_color",
                                                                      "misses_d3_color",
                                                                      "multiplies_effects"};
  return kNames;
}

}  // namespace ptm::reference
