#pragma once
#include <cstdint>

namespace ptm::testbench {

/// What stands, before reset, in the registers and memories of every Verilated unit and evaluator
/// that this process constructs from now on: 0 everywhere (seed 0, the default), or random bits
/// made from the seed. Nothing that leaves a unit may depend on it. Not to be called while another
/// thread constructs one.
void set_rtl_initial_values(std::uint32_t seed);
[[nodiscard]] std::uint32_t rtl_initial_values();

/// The context of a Verilated class, made ready for its construction: the designs are verilated
/// with
/// `--x-initial unique`, so values are chosen when the class is constructed.
template <class Context>
[[nodiscard]] Context* with_initial_values(Context& context) {
  const std::uint32_t seed = rtl_initial_values();
  context.randReset(seed == 0 ? 0 : 2);
  if (seed != 0) context.randSeed(static_cast<int>(seed));
  return &context;
}

}  // namespace ptm::testbench
