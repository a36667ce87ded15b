#include "testbench/rtl/initial_values.h"

namespace ptm::testbench {
namespace {

std::uint32_t chosen_seed = 0;

}  // namespace

void set_rtl_initial_values(std::uint32_t seed) { chosen_seed = seed; }
std::uint32_t rtl_initial_values() { return chosen_seed; }

}  // namespace ptm::testbench
