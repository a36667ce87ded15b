// Rates from the RTL's counters, as docs/spec/unit-timing.md defines them, and the timing loose.
#include <algorithm>
#include <iostream>

#include "tests/unit/unit_agreement.h"

namespace ptm::testbench {
namespace {

using reference::UnitCounter;

UnitTimed run_one(const UnitJob& job, const std::string& model) {
  ChildProcess child = start_unit_model(job, model);
  return take_unit_model(child, model);
}

double rate(const reference::UnitCounters& counters) {
  return static_cast<double>(counters[UnitCounter::pixels]) /
         static_cast<double>(counters[UnitCounter::cycles]);
}

TEST(UnitRates, WarmAPixelLeavesEveryCycle) {
  const UnitJob job = load_unit_scene("rate_warm");
  const UnitTimed rtl = run_one(job, "rtl");
  const reference::UnitCounters& counters = rtl.frames.at(0).counters;
  std::cout << "warm: " << rate(counters) << " pixels a cycle, "
            << counters[UnitCounter::tag_misses] << " misses\n";
  EXPECT_EQ(counters[UnitCounter::tag_misses], 0U);
  // From the first pixel on, one a cycle: only the pipeline's filling is not paid back.
  const auto& taken = rtl.frames.at(0).taken;
  EXPECT_EQ(taken.back() - taken.front() + 1, taken.size());
  EXPECT_LE(counters[UnitCounter::cycles], counters[UnitCounter::pixels] + 25);
}

TEST(UnitRates, ColdStaysWithinTheMemorysTime) {
  const UnitJob job = load_unit_scene("rate_cold");
  const UnitTimed rtl = run_one(job, "rtl");
  const reference::UnitCounters& counters = rtl.frames.at(0).counters;
  const auto& memory = std::get<pipeline::FixedMemory>(job.memory);
  const std::uint64_t beats = counters[UnitCounter::beats];
  const std::uint64_t lines = counters[UnitCounter::lines_read];
  const double allowed = static_cast<double>(std::max(beats, lines * memory.interval)) / 0.9 +
                         static_cast<double>(memory.latency) + 100;
  const std::uint64_t compulsory = std::uint64_t{1024 / 4} * (1024 / 4) * 3;
  std::cout << "cold: " << rate(counters) << " pixels a cycle, " << counters[UnitCounter::cycles]
            << " cycles, allowed " << allowed << ", lines " << lines << " = "
            << static_cast<double>(lines) / static_cast<double>(compulsory) << " x compulsory\n";
  EXPECT_LE(static_cast<double>(counters[UnitCounter::cycles]), allowed);
  EXPECT_LE(static_cast<double>(lines), 1.3 * static_cast<double>(compulsory));
}

TEST(UnitRates, LooseIsWithinThreePercentOfExactOnLargeScenes) {
  for (const char* scene : {"rate_cold", "rate_warm"}) {
    const UnitJob job = load_unit_scene(scene);
    ASSERT_GE(job.frames.at(0).fragments.size(), 65'536U);
    const UnitTimed exact = run_one(job, "pipeline");
    const UnitTimed loose = run_one(job, "loose");
    const auto e = static_cast<double>(exact.frames.at(0).counters[UnitCounter::cycles]);
    const auto l = static_cast<double>(loose.frames.at(0).counters[UnitCounter::cycles]);
    std::cout << scene << ": loose " << l << ", exact " << e << ", " << 100 * (l - e) / e << " %\n";
    EXPECT_LE(std::abs(l - e), 0.03 * e) << scene;
  }
}

}  // namespace
}  // namespace ptm::testbench
