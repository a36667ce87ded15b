#pragma once
#include "model/pipeline/unit/miss_ring.h"
#include "model/pipeline/unit/tag_cache.h"
#include "model/reference/unit/unit_counters.h"

namespace ptm::pipeline {

/// T and the fragment FIFO: look-ups in order, misses to the ring, beats to K.
class Tags final : public sc_core::sc_module {
 public:
  Tags(const sc_core::sc_module_name& name, const reference::UnitConfig& unit, MissRing& ring,
       Commit& out)
      : sc_module(name),
        ring_(ring),
        out_(out),
        map_(unit),
        fifo_(static_cast<std::size_t>(unit.fragment_fifo)) {
    for (int t = 0; t < unit.tmus; ++t) caches_.emplace_back(map_.rows(), unit.ways);
  }

  /// Returns the cycle in which T takes the beat.
  template <bool kEffects>
  Cycle accept(UnitBeat& beat, Cycle offered) {
    const Cycle enter = std::max(offered, left_);
    beat.ranks = 0;
    if (beat.repeats) [[likely]] {
      count_repeated(beat);
    } else {
      look_up(beat);
    }
    Cycle& place = fifo_[next_place_];
    const Cycle pushed =
        beat.ranks == 0 ? std::max(enter + 1, place) : push_ranks(beat, enter, place);
    const Commit::Stay stay = out_.accept<kEffects>(beat, pushed + 1);
    if (beat.ranks != 0) ring_.release(stay.leave);
    place = stay.enter + 1;
    next_place_ = next_place_ + 1 == fifo_.size() ? 0 : next_place_ + 1;
    left_ = pushed;
    commit_empty_ = stay.was_empty;
    return enter;
  }

  void reset(bool keep_cache);
  /// Whether a beat has missed since the last call.
  [[nodiscard]] bool take_missed() { return std::exchange(missed_, false); }

  struct Counters {
    std::array<std::array<std::uint64_t, 2>, reference::kDraws> hits{}, misses{};
    std::uint64_t duplicates = 0, ring_full = 0;
  };
  [[nodiscard]] const Counters& counters() const { return counters_; }

 private:
  struct LookUp {
    std::uint32_t row = 0, line = 0;
  };

  void count_repeated(const UnitBeat& beat) {
    for (std::size_t t = 0; t < 2; ++t) {
      counters_.hits[draw_of(beat)][t] += beat.plan->words_of[t] * (*beat.tiles)[t].tiles;
    }
  }
  void look_up(UnitBeat& beat);
  [[nodiscard]] Cycle push_ranks(UnitBeat& beat, Cycle enter, Cycle place);
  [[nodiscard]] unsigned list_tiles(const UnitBeat& beat, const TexturePlan& texture,
                                    std::array<TilePlace, 4>& tiles) const;
  void look_up_word(const UnitBeat& beat, std::size_t tmu, std::uint32_t plane, unsigned count,
                    const std::array<TilePlace, 4>& tiles, std::size_t texture);
  [[nodiscard]] bool all_used_last(const BeatPlan& plan, const std::array<unsigned, 2>& counts,
                                   const std::array<std::array<TilePlace, 4>, 2>& tiles) const;
  [[nodiscard]] bool elsewhere(std::size_t tmu, const LookUp& at) const;
  [[nodiscard]] static std::size_t draw_of(const UnitBeat& beat) { return beat.fragment->draw; }

  MissRing& ring_;
  Commit& out_;
  SetMap map_;
  std::vector<TagCache> caches_;
  std::vector<Cycle> fifo_;  ///< when each place of the fragment FIFO may be filled
  std::size_t next_place_ = 0;
  Cycle left_ = 0;             ///< when the beat before left T
  bool commit_empty_ = false;  ///< K was empty in the cycle in which that beat entered it
  bool missed_ = false;
  std::array<std::array<LookUp, 4>, kTmusMax> misses_{};  ///< of the beat at hand, by TMU and rank
  std::array<unsigned, kTmusMax> miss_count_{};
  std::array<std::array<LookUp, 4>, kTmusMax> older_{};  ///< hits that were not the last used
  std::array<unsigned, kTmusMax> older_count_{};
  Counters counters_;
};

}  // namespace ptm::pipeline
