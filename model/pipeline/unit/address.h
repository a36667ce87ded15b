#pragma once
#include "model/pipeline/unit/tags.h"

namespace ptm::pipeline {

/// A0 to A3: a fragment becomes beats, one a cycle, and a beat that meets itself across a seam
/// sub-beats.
class Address final : public sc_core::sc_module {
 public:
  Address(const sc_core::sc_module_name& name, std::vector<DrawPlan> draws, Tags& out)
      : sc_module(name), draws_(std::move(draws)), out_(out) {}
  /// Not inline: GCC 12 at -O2 checks the type of a member whose inlined destructor has run.
  ~Address() override;

  /// Returns the cycle in which A0 takes the fragment.
  template <bool kEffects>
  Cycle accept(const reference::UnitFragment& fragment, Cycle offered) {
    const Cycle enter = std::max(offered, free_);
    UnitBeat beat;
    beat.draw = &draws_[fragment.draw];
    beat.fragment = &fragment;
    const unsigned footprints = gather(*beat.draw, fragment, beat.repeats);
    Cycle sent = enter;
    for (unsigned f = 0; f < footprints; ++f) {
      beat.tiles = &tiles_[f];
      for (unsigned b = 0; b < beat.draw->beats; ++b) {
        beat.plan = &beat.draw->beat[b];
        beat.last = f + 1 == footprints && b + 1 == beat.draw->beats;
        sent = send<kEffects>(beat, sent + 1);
      }
    }
    free_ = sent;
    all_hit_ = !out_.take_missed();
    ++fragments_[fragment.draw];
    return enter;
  }

  void reset();

  struct Counters {
    std::uint64_t words = 0, taps = 0, conflicts = 0;
    std::uint64_t multiplies_address = 0, multiplies_filter = 0;
  };
  [[nodiscard]] const Counters& counters() const { return counters_; }
  /// Fragments by draw.
  [[nodiscard]] const std::array<std::uint64_t, reference::kDraws>& fragments() const {
    return fragments_;
  }
  [[nodiscard]] const std::vector<DrawPlan>& draws() const { return draws_; }

 private:
  static constexpr std::size_t kFootprintsMax = 32;  // 16 probes, two levels

  /// Steps U1 to U6 for every probe and level, into tiles_; returns their number.
  unsigned gather(const DrawPlan& draw, const reference::UnitFragment& fragment, bool& repeats);
  void gather_texture(const DrawPlan& draw, const TexturePlan& texture,
                      const reference::UnitFragment& fragment, int level, bool two_levels,
                      bool fetches_second);
  void place(const DrawPlan& draw, const TexturePlan& texture, unsigned at, int level,
             reference::Value u, reference::Value v, bool second);

  template <bool kEffects>
  Cycle send(UnitBeat& beat, Cycle offered) {
    return registers_.accept(offered, [&](Cycle in_a3) {
      const unsigned split = split_of(beat);
      if (split == 0) [[likely]] {
        return out_.accept<kEffects>(beat, in_a3);
      }
      return send_split<kEffects>(beat, split, in_a3);
    });
  }
  [[nodiscard]] static unsigned split_of(const UnitBeat& beat) {
    return (beat.plan->words_of[0] != 0 ? (*beat.tiles)[0].split : 0) |
           (beat.plan->words_of[1] != 0 ? (*beat.tiles)[1].split : 0);
  }
  template <bool kEffects>
  Cycle send_split(UnitBeat& beat, unsigned split, Cycle offered);

  std::vector<DrawPlan> draws_;
  Tags& out_;
  RegisterChain<3> registers_;
  Cycle free_ = 0;  ///< when the last beat of the fragment before left A0

  std::array<std::array<FootprintTiles, 2>, kFootprintsMax> tiles_{};  ///< of the fragment at hand
  unsigned footprints_ = 0;  ///< of the fragment before; 0: there is none
  int draw_ = 0;             ///< its draw
  bool all_hit_ = false;     ///< its look-ups
  bool same_ = false, split_ = false;

  Counters counters_;
  std::array<std::uint64_t, reference::kDraws> fragments_{};
};

}  // namespace ptm::pipeline
