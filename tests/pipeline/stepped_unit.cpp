#include "tests/pipeline/stepped_unit.h"

#include <algorithm>
#include <stdexcept>

namespace ptm::tests {

using pipeline::Cycle;
using reference::Draw;
using reference::TextureFormat;
using reference::UnitCounter;

SteppedUnit::SteppedUnit(const reference::UnitConfig& unit, const std::vector<Draw>& draws,
                         const pipeline::StreamTiming& timing, pipeline::MemoryTiming& memory,
                         const reference::EvalConfig& eval)
    : unit_(unit), eval_(eval), draws_(draws), timing_(timing), memory_(memory) {
  constexpr std::array<std::size_t, 3> kStageRegisters{3, 1,
                                                       1};  // the page's: power, modulate, add
  for (std::size_t stage = 0; stage < kStageRegisters.size(); ++stage) {
    const std::size_t more = (unit.stages >> stage & 1) != 0 ? kStageRegisters[stage] : 0;
    chain_.resize(chain_.size() + more);
  }
  begin(false);
}

void SteppedUnit::begin(bool keep_cache) {
  if (!keep_cache) {
    const std::vector<Way> ways(static_cast<std::size_t>(unit_.ways));
    const std::vector<std::vector<Way>> sets(static_cast<std::size_t>(reference::cache_sets(unit_)),
                                             ways);
    cache_.assign(static_cast<std::size_t>(unit_.tmus), {sets, sets, sets, sets});
  }
  memory_.reset();
  result_ = {};
  cycle_ = 0;
  offered_from_ = gap(timing_, 0);
  accepted_ = requested_ = 0;
  first_.reset();
  reads_.clear();
  free_slots_ = unit_.miss_fifo;
}

pipeline::UnitFrameResult SteppedUnit::run(const pipeline::UnitFrame& frame) {
  begin(frame.keep_cache);
  fragments_ = frame.fragments;
  Cycle last_change = 0;
  std::size_t pixels = 0;
  for (; result_.taken.size() < fragments_.size(); ++cycle_) {
    step();
    if (result_.taken.size() != pixels) last_change = cycle_;
    pixels = result_.taken.size();
    if (cycle_ - last_change > 1000000) throw std::runtime_error("the stepped unit hangs");
  }
  for (const LineRead& read : reads_) result_.answered.push_back(read.arrives.value());
  auto& c = result_.counters;
  c[UnitCounter::fragments] = accepted_;
  c[UnitCounter::pixels] = result_.taken.size();
  if (first_) c[UnitCounter::cycles] = result_.taken.back() - *first_ + 1;
  return result_;
}

/// Blocks from the last to the first: who is ready follows from who leaves behind it.
void SteppedUnit::step() {
  fifo_size_ = fifo_.size();
  free_at_start_ = free_slots_;
  released_ = 0;
  k_held_ = k_.has_value();
  k_left_ = f_accepted_ = ring_full_ = false;
  step_output();
  step_filter();
  step_commit();
  step_tags();
  step_address();
  step_requests();
  free_slots_ += released_;
  if (first_) classify();
}

/// Counters 3 to 7, in their order.
void SteppedUnit::classify() {
  auto& c = result_.counters;
  if (k_left_) {
    ++c[UnitCounter::cycles_moved];
  } else if (k_held_ && !f_accepted_) {
    ++c[UnitCounter::cycles_output_blocked];
  } else if (k_held_) {
    ++c[UnitCounter::cycles_line_wait];
  } else if (ring_full_) {
    ++c[UnitCounter::cycles_ring_full];
  } else {
    ++c[UnitCounter::cycles_input_empty];
  }
}

/// Evaluator, its FIFO, C1, C2, the effect chain.
void SteppedUnit::step_output() {
  // The unit's output is the chain's last register, or C2 where there is no chain.
  for (std::size_t left = chain_.size() + 1; left-- > 0;) {
    if (left == 0 ? !c2_ : !chain_[left - 1]) continue;
    if (left == chain_.size() ? stalled(timing_, cycle_) : chain_[left]) continue;
    if (left == chain_.size()) {
      result_.taken.push_back(cycle_);
    } else {
      chain_[left] = true;
    }
    if (left == 0) {
      c2_ = false;
    } else {
      chain_[left - 1] = false;
    }
  }
  if (c1_ && !c2_) {
    c1_ = false;
    c2_ = true;
  }
  const bool fifo_accepts = e_fifo_.size() < 2;
  if (!e_fifo_.empty() && e_fifo_.front() == Pass::extra) {
    e_fifo_.pop_front();  // whatever C1 does
  } else if (!e_fifo_.empty() && !c1_) {
    e_fifo_.pop_front();
    c1_ = true;
  }
  if (e_.back() && (*e_.back() == Pass::part || fifo_accepts)) {
    if (*e_.back() != Pass::part) e_fifo_.push_back(*e_.back());
    e_.back().reset();
  }
  for (std::size_t i = e_.size() - 1; i-- > 0;) {
    if (e_[i] && !e_[i + 1]) std::swap(e_[i], e_[i + 1]);
  }
  e_free_ = !e_.front();
  if (o_ && e_free_) {
    if (o_->extra_left > 0) {
      --o_->extra_left;
      e_.front() = Pass::extra;
    } else {
      e_.front() = --o_->passes_left == 0 ? Pass::last : Pass::part;
    }
    if (o_->passes_left == 0) o_.reset();
  }
  o_free_ = !o_;
}

/// L3, L2, L1, P, Q, D, F.
void SteppedUnit::step_filter() {
  if (l3_ && (!l3_->last || o_free_)) {
    const Draw& draw = *l3_->draw;
    const bool three =
        draw.format == TextureFormat::rgb || draw.format == TextureFormat::palette_rgb;
    if (l3_->last) o_ = Operands{draw.effects.passes, three && unit_.eval_lanes == 1 ? 3 : 1};
    l3_.reset();
  }
  if (l2_ && !l3_) std::swap(l2_, l3_);
  if (l1_ && !l2_) std::swap(l1_, l2_);
  if (p_ && !l1_) std::swap(p_, l1_);
  if (q_ && !p_) std::swap(q_, p_);
  if (d_ && !q_ && ++d_->looked_up_cycles >= palette_cycles(*d_)) {
    if (d_->completes) {
      std::swap(d_, q_);
    } else {
      d_.reset();  // its taps are in Q's registers, which stays empty until the beat is whole
    }
  }
  if (f_ && !d_) {
    for (const Word& word : f_->words) {
      result_.counters[UnitCounter::taps] += word.taps.size();
      if (word.palette) result_.counters[UnitCounter::palette_lookups] += word.taps.size();
    }
    std::swap(f_, d_);
  }
  f_free_ = !f_;
}

int SteppedUnit::palette_cycles(const Beat& beat) {
  const bool lrgb = beat.draw->format == TextureFormat::palette_lrgb;
  const int ports = lrgb ? unit_.palette_lrgb_ports : unit_.palette_rgb_ports;
  int taps = 0;
  for (const Word& word : beat.words) {
    if (word.palette) taps += static_cast<int>(word.taps.size());
  }
  return std::max(1, (taps + ports - 1) / ports);
}

/// Whether the lines of the rank to be committed next are usable.
bool SteppedUnit::arrived(const Beat& beat) const {
  if (beat.reads.empty()) return true;
  return std::ranges::all_of(beat.reads[beat.ranks_committed], [&](std::size_t read) {
    return reads_[read].arrives && *reads_[read].arrives + 2 <= cycle_;
  });
}

/// K and the fragment FIFO's exit.
void SteppedUnit::step_commit() {
  f_accepted_ = f_free_;
  if (k_ && f_free_ && arrived(*k_)) {
    ++k_->ranks_committed;
    if (k_->ranks_committed >= k_->ranks.size()) {
      k_left_ = true;
      ++result_.counters[UnitCounter::beats];
      for (const auto& rank : k_->reads) released_ += static_cast<int>(rank.size());
      f_ = std::move(k_);
      k_.reset();
    }
  }
  if (!k_ && fifo_size_ > 0) {
    k_ = std::move(fifo_.front());
    fifo_.pop_front();
  }
}

/// T: look-up in the first cycle, a rank a cycle to the ring, the beat to the FIFO with the last.
void SteppedUnit::step_tags() {
  if (t_) {
    if (!t_->looked_up) look_up(*t_);
    const bool fifo_accepts = fifo_size_ < static_cast<std::size_t>(unit_.fragment_fifo);
    const bool last = t_->ranks_pushed + 1 >= t_->ranks.size();
    bool slots = true;
    if (t_->ranks_pushed < t_->ranks.size()) {
      const auto& rank = t_->ranks[t_->ranks_pushed];
      slots = free_at_start_ >= static_cast<int>(rank.size());
      ring_full_ = !slots;
      if (slots && (!last || fifo_accepts)) {
        std::vector<std::size_t> reads;
        for (const std::uint32_t line : rank) {
          reads.push_back(reads_.size());
          reads_.push_back({line, cycle_, {}});
          --free_slots_;
        }
        t_->reads.push_back(reads);
        ++t_->ranks_pushed;
      }
    }
    if (slots && last && fifo_accepts) {
      fifo_.push_back(std::move(*t_));
      t_.reset();
    }
  }
  t_free_ = !t_;
}

void SteppedUnit::step_requests() {
  if (requested_ == reads_.size() || reads_[requested_].pushed >= cycle_) return;
  LineRead& read = reads_[requested_];
  const Cycle done = memory_.line(requested_, read.line, cycle_);
  if (done <= cycle_) throw std::runtime_error("the memory answers before it is asked");
  for (const LineRead& other : reads_) {
    if (other.arrives == done) throw std::runtime_error("two lines in one cycle");
  }
  read.arrives = done;
  ++requested_;
  ++result_.counters[UnitCounter::lines_read];
}

/// A3, A2, A1, A0 and the source.
void SteppedUnit::step_address() {
  if (!a3_.empty() && t_free_) {
    t_ = std::move(a3_.front());
    a3_.pop_front();
  }
  if (a2_ && a3_.empty()) {
    for (Beat& beat : split(*a2_)) a3_.push_back(std::move(beat));
    result_.counters[UnitCounter::bank_conflicts] += a3_.size() - 1;
    a2_.reset();
  }
  if (a1_ && !a2_) std::swap(a1_, a2_);
  if (!a0_.empty() && !a1_) {
    a1_ = std::move(a0_.front());
    a0_.pop_front();
  }
  if (a0_.empty() && accepted_ < fragments_.size() && cycle_ >= offered_from_) {
    for (Beat& beat : make_beats(accepted_)) a0_.push_back(std::move(beat));
    if (!first_) first_ = cycle_;
    ++accepted_;
    offered_from_ = cycle_ + 1 + gap(timing_, accepted_);
  }
}

}  // namespace ptm::tests
