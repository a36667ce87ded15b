#include "model/pipeline/unit/texture_unit.h"

#include <algorithm>
#include <string>

#include "model/pipeline/unit/texture_unit_feed.h"

namespace ptm::pipeline {

using reference::UnitCounter;

TextureUnit::TextureUnit(const sc_core::sc_module_name& name, const reference::UnitConfig& unit,
                         const std::vector<reference::Draw>& draws, const StreamTiming& timing,
                         const std::optional<MemoryFault>& fault, const sc_core::sc_time& clock,
                         const reference::EvalConfig& eval)
    : sc_module(name),
      memory("memory", clock, fault),
      unit_(unit),
      timing_(timing),
      sink_("sink", timing),
      chain_(unit.stages, sink_),
      combine_("combine", sink_, chain_),
      evaluator_("evaluator", combine_),
      filter_("filter", evaluator_),
      palette_("palette", filter_),
      fetch_("fetch", palette_, sink_, timing.output_stall > 0),
      commit_("commit", fetch_),
      ring_("miss_ring", memory, unit.miss_fifo),
      tags_("tags", unit, ring_, commit_),
      address_("address", plan_draws(draws, unit, eval), tags_) {}

void TextureUnit::reset(const UnitFrame& frame) {
  memory.reset();
  sink_.taken.clear();
  chain_.reset();
  combine_.reset();
  evaluator_.reset();
  filter_.reset();
  palette_.reset();
  fetch_.reset();
  commit_.reset();
  // The count of what is owed is 0 in the cycle after the last answer, the drain over in the next.
  ring_.reset(frame.owed_until ? *frame.owed_until + 2 : 0);
  tags_.reset(frame.keep_cache);
  address_.reset();
}

TextureUnit::Frame TextureUnit::run(const UnitFrame& frame, Cycle patience) {
  reset(frame);
  sink_.taken.reserve(frame.fragments.size());
  const bool effects = std::ranges::any_of(address_.draws(), &DrawPlan::effects);
  const Feed fed = effects ? feed_with_effects(frame.fragments) : feed<false>(frame.fragments);
  Frame out;
  out.result.taken = std::exchange(sink_.taken, {});
  out.result.answered = std::exchange(memory.answered, {});
  if (memory.waiting()) report_fault(out, fed.last, patience);
  report_counters(out, fed.accepted, fed.first);
  return out;
}

void TextureUnit::report_fault(Frame& frame, Cycle last_accepted, Cycle patience) {
  const MemoryPort::Waiting& waiting = *memory.waiting();
  std::vector<Cycle>& taken = frame.result.taken;
  std::erase_if(taken, [](Cycle cycle) { return cycle >= kStuck; });
  const bool silent = waiting.kind == MemoryFault::Kind::never;
  Cycle cycle = waiting.answered;
  if (silent) {
    cycle = std::max({last_accepted, memory.last_transfer(), taken.empty() ? 0 : taken.back()}) +
            patience;
  } else {
    std::erase_if(taken, [&](Cycle c) { return c > cycle; });
  }
  const std::string request = "request " + std::to_string(waiting.index) + " (line " +
                              std::to_string(waiting.line) + ", tag " +
                              std::to_string(waiting.slot) + ")";
  const std::string who = "; the fragment at (" + std::to_string(waiting.x) + ", " +
                          std::to_string(waiting.y) + ") waits for it";
  frame.result.fault =
      UnitFault{"cycle " + std::to_string(cycle) + ": the memory " +
                    (silent ? "has not answered " + request + " for " + std::to_string(patience) +
                                  " cycles without a transfer"
                            : "answered " + request + " with a tag that is not outstanding") +
                    who,
                cycle};
  frame.end = cycle + 1;
}

void TextureUnit::report_counters(Frame& frame, std::uint64_t accepted, Cycle first) {
  reference::UnitCounters& c = frame.result.counters;
  const std::vector<Cycle>& taken = frame.result.taken;
  if (!taken.empty()) {
    frame.end = std::max(frame.end, taken.back() + 1);
    c[UnitCounter::cycles] = taken.back() + 1 - first;
  }
  c[UnitCounter::fragments] = accepted;
  c[UnitCounter::pixels] = taken.size();
  c[UnitCounter::cycles_moved] = c[UnitCounter::beats] = commit_.beats();
  c[UnitCounter::cycles_output_blocked] = commit_.output_blocked();
  c[UnitCounter::cycles_line_wait] = commit_.line_wait();
  c[UnitCounter::cycles_ring_full] = tags_.counters().ring_full;
  c[UnitCounter::cycles_input_empty] = c[UnitCounter::cycles] - c[UnitCounter::cycles_moved] -
                                       c[UnitCounter::cycles_output_blocked] -
                                       c[UnitCounter::cycles_line_wait] -
                                       c[UnitCounter::cycles_ring_full];
  if (frame.result.fault) {  // its beats wait for ever
    for (auto n = static_cast<std::size_t>(UnitCounter::cycles);
         n <= static_cast<std::size_t>(UnitCounter::cycles_input_empty); ++n) {
      c.value[n] = 0;
    }
  }
  c[UnitCounter::bank_conflicts] = address_.counters().conflicts;
  c[UnitCounter::words] = address_.counters().words;
  c[UnitCounter::taps] = address_.counters().taps;
  c[UnitCounter::multiplies_address] = address_.counters().multiplies_address;
  c[UnitCounter::multiplies_filter] = address_.counters().multiplies_filter;
  c[UnitCounter::lines_read] = ring_.requests();
  c[UnitCounter::duplicate_lines] = tags_.counters().duplicates;
  c[UnitCounter::palette_lookups] = palette_.lookups();
  report_draws(c);
  c.keep_built(unit_);
}

void TextureUnit::report_draws(reference::UnitCounters& c) const {
  for (std::size_t d = 0; d < address_.draws().size(); ++d) {
    const DrawPlan& draw = address_.draws()[d];
    c[UnitCounter::multiplies_eval] += address_.fragments()[d] * draw.eval_multiplies;
    c[UnitCounter::multiplies_combine] += address_.fragments()[d] * draw.combine_multiplies;
    c[UnitCounter::multiplies_effects] += address_.fragments()[d] * draw.effect_multiplies;
    for (std::size_t t = 0; t < 2; ++t) {
      const std::uint64_t hits = tags_.counters().hits[d][t],
                          misses = tags_.counters().misses[d][t];
      c.hits(static_cast<int>(d), static_cast<int>(t)) = hits;
      c.misses(static_cast<int>(d), static_cast<int>(t)) = misses;
      c[UnitCounter::tag_hits] += hits;
      c[UnitCounter::tag_misses] += misses;
    }
  }
}

}  // namespace ptm::pipeline
