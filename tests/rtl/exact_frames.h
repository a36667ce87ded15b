#pragma once
#include "model/pipeline/simulate_texture_unit.h"
#include "tests/rtl/unit_runs.h"

/// Frames of the RTL unit against the pipeline model's timing `exact`. SystemC elaborates once a
/// process, and so a test runs each model once.
namespace ptm::tests {

struct Condition {
  const char* name;
  pipeline::MemoryModel memory;
  pipeline::StreamTiming timing;
};

inline void expect_same(const pipeline::UnitFrameResult& rtl,
                        const pipeline::UnitFrameResult& model) {
  ASSERT_FALSE(rtl.fault) << rtl.fault->what;
  ASSERT_FALSE(model.fault) << model.fault->what;
  ASSERT_EQ(rtl.taken.size(), model.taken.size());
  for (std::size_t n = 0; n < rtl.taken.size(); ++n) {
    ASSERT_EQ(rtl.taken[n], model.taken[n]) << "pixel " << n;
  }
  EXPECT_EQ(rtl.answered, model.answered);
  const auto& names = reference::unit_counter_names();
  for (std::size_t n = 0; n < reference::kUnitCounters; ++n) {
    EXPECT_EQ(rtl.counters.value[n], model.counters.value[n]) << names[n];
  }
}

/// A frame and the same one with what stands in the caches, in both models.
inline void expect_same_frames(const testbench::RtlUnitVariant& variant, const Condition& condition,
                               const UnitScene& scene,
                               const std::vector<reference::UnitFragment>& fragments) {
  const auto unit = variant.make();
  unit->load(scene.state);
  const auto memory = make_memory(condition.memory);
  const std::array<pipeline::UnitFrame, 2> frames{{{fragments}, {fragments, true}}};
  pipeline::UnitSimulation simulation;
  simulation.unit = variant.unit;
  simulation.eval = variant.config;
  simulation.state = &scene.state;
  simulation.timing = condition.timing;
  simulation.memory = condition.memory;
  simulation.frames = {frames.size(), [&](std::size_t n) { return frames[n]; },
                       [&](std::size_t n, pipeline::UnitFrameResult&& model) {
                         SCOPED_TRACE("frame " + std::to_string(n));
                         const auto rtl = unit->run(frames[n], *memory, condition.timing);
                         expect_same(rtl, model);
                         expect_pixels(scene, fragments, rtl.pixels);
                       }};
  simulate_texture_unit(simulation);
}

}  // namespace ptm::tests
