#include "testbench/run/unit_section.h"

#include <algorithm>
#include <set>

#include "testbench/plan/scene_plan.h"

namespace ptm::testbench {
namespace {

constexpr std::uint64_t kWindows = 240;  ///< of the bandwidth chart

/// Lines that arrived a window, frames one after another.
std::vector<std::uint32_t> windows(const UnitTimed& timed, std::uint64_t window) {
  std::vector<std::uint32_t> lines;
  for (const pipeline::UnitFrameResult& frame : timed.frames) {
    const std::size_t first = lines.size();
    const std::uint64_t last = frame.taken.empty() ? 0 : frame.taken.back();
    lines.resize(first + last / window + 1);
    for (const pipeline::Cycle cycle : frame.answered) {
      if (cycle <= last) ++lines[first + cycle / window];
    }
  }
  return lines;
}

/// The cycles in which the frames' last pixels leave, added up.
std::uint64_t last_cycles(const UnitTimed& timed) {
  std::uint64_t sum = 0;
  for (const pipeline::UnitFrameResult& frame : timed.frames) {
    if (!frame.taken.empty()) sum += frame.taken.back();
  }
  return sum;
}

std::string texture_name(const UnitJob& job, int texture) {
  return texture < 0 ? "" : job.textures[static_cast<std::size_t>(texture)].name;
}

const UnitTimed* find(const std::vector<UnitTimed>& timed, const std::string& model) {
  const auto found = std::find_if(timed.begin(), timed.end(),
                                  [&](const UnitTimed& t) { return t.model == model; });
  return found == timed.end() ? nullptr : &*found;
}

}  // namespace

reference::UnitCounters total_counters(const UnitTimed& timed) {
  reference::UnitCounters sum;
  for (const pipeline::UnitFrameResult& frame : timed.frames) {
    for (std::size_t i = 0; i < sum.value.size(); ++i) sum.value[i] += frame.counters.value[i];
  }
  return sum;
}

std::uint64_t count_late_pixels(const UnitTimed& a, const UnitTimed& b) {
  std::uint64_t late = 0;
  for (std::size_t n = 0; n < std::max(a.frames.size(), b.frames.size()); ++n) {
    static const std::vector<pipeline::Cycle> none;
    const auto& x = n < a.frames.size() ? a.frames[n].taken : none;
    const auto& y = n < b.frames.size() ? b.frames[n].taken : none;
    const std::size_t both = std::min(x.size(), y.size());
    for (std::size_t i = 0; i < both; ++i) late += x[i] != y[i] ? 1U : 0U;
    late += std::max(x.size(), y.size()) - both;
  }
  return late;
}

std::vector<std::string> differing_counters(const UnitTimed& a, const UnitTimed& b) {
  const reference::UnitCounters none;
  std::set<std::size_t> differing;
  for (std::size_t n = 0; n < std::max(a.frames.size(), b.frames.size()); ++n) {
    const auto& x = n < a.frames.size() ? a.frames[n].counters : none;
    const auto& y = n < b.frames.size() ? b.frames[n].counters : none;
    for (std::size_t i = 0; i < reference::kUnitCounters; ++i) {
      if (x.value[i] != y.value[i]) differing.insert(i);
    }
  }
  std::vector<std::string> list;
  for (const std::size_t i : differing) list.emplace_back(reference::unit_counter_names()[i]);
  return list;
}

double warm_cycles_per_pixel(const UnitJob& job, int draw) {
  const reference::Draw& d = job.state.draws[static_cast<std::size_t>(draw)];
  double sum = 0, count = 0;
  for (const UnitFrameInput& frame : job.frames) {
    for (const reference::UnitFragment& fragment : frame.fragments) {
      if (fragment.draw != draw) continue;
      sum += warm_cycles(d, job.unit, fragment, job.config);
      ++count;
    }
  }
  return count > 0 ? sum / count : 0;
}

UnitSection make_unit_section(const UnitJob& job, const std::vector<UnitTimed>& timed) {
  UnitSection section;
  section.config = job.unit;
  section.memory = describe(job.memory);
  for (const PlannedBlock& block : job.plan.blocks) {
    std::string who;
    for (const std::string& name : block.effects) who += (who.empty() ? "" : ", ") + name;
    section.effect_blocks.push_back(block.what + " (" + block.name + ") for " + who);
  }
  std::uint64_t cycles = 0;
  for (const UnitTimed& model : timed) {
    cycles =
        std::max(cycles, job.unit.counters ? total_counters(model)[reference::UnitCounter::cycles]
                                           : last_cycles(model));
  }
  section.window = std::max<std::uint64_t>(1, cycles / kWindows);
  for (std::size_t d = 0; d < job.scene.draws.size(); ++d) {
    const golden::DrawSpec& spec = job.scene.draws[d];
    section.draws.push_back(
        {"draw " + std::to_string(d), texture_name(job, spec.map), texture_name(job, spec.color),
         warm_cycles_per_pixel(job, static_cast<int>(d)), job.plan.draws[d].effects});
  }
  for (const UnitTimed& model : timed) {
    const bool estimate = model.model == "loose";
    section.timings.push_back(
        {model.model, model.seconds, estimate, total_counters(model),
         estimate ? std::vector<std::uint32_t>{} : windows(model, section.window)});
  }
  const UnitTimed* exact = find(timed, "pipeline");
  const UnitTimed* rtl = find(timed, "rtl");
  if (exact && rtl) {
    section.late_pixels = count_late_pixels(*exact, *rtl);
    section.differing_counters = differing_counters(*exact, *rtl);
  }
  return section;
}

}  // namespace ptm::testbench
