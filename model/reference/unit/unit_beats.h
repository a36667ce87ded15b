#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "model/reference/unit/beats.h"
#include "model/reference/unit/unit_counters.h"

/// The beats of a fragment, untimed: what the address stages of docs/spec/unit-timing.md (A0 to A3)
/// send to the tags, in order. Written plainly, to check other twins' beats and counters against.
namespace ptm::reference {

inline constexpr unsigned kTmusMax = 3;

/// One texel that is read.
struct TapRead {
  std::int32_t i = 0, j = 0;            ///< column and row in its level
  std::int32_t tile_x = 0, tile_y = 0;  ///< tile of the texel: its tag bank is their parity
  TexelPlace place;                     ///< line address, word in the line

  /// 0..3: parity of the row twice, plus parity of the column.
  [[nodiscard]] unsigned tag_bank() const { return parity(tile_x, tile_y); }
  [[nodiscard]] unsigned data_bank() const { return parity(i, j); }
  bool operator==(const TapRead&) const = default;

 private:
  static unsigned parity(std::int32_t column, std::int32_t row) {
    return (static_cast<unsigned>(row) & 1U) * 2 + (static_cast<unsigned>(column) & 1U);
  }
};

/// One TMU's part of a beat.
struct BeatWord {
  bool present = false;  ///< false: the draw has no word here
  int word = 0;          ///< of the draw
  int texture = 0;       ///< 0 map, 1 colour
  int plane = 0;         ///< within its texture
  int level = 0;
  unsigned taps = 0;                 ///< bit t: tap t (00, 10, 01, 11) is fetched
  std::array<TapRead, kTaps> tap{};  ///< of fetched taps; the others are all 0
  bool operator==(const BeatWord&) const = default;
};

struct Beat {
  int probe = 0, footprint = 0;
  int group = 0;         ///< beat of the footprint: words group * tmus and on
  bool last = false;     ///< of its fragment
  bool sub_last = true;  ///< of the beat that was split
  std::array<BeatWord, kTmusMax> tmu{};
  bool operator==(const Beat&) const = default;
};

/// U1 to U6 of a fragment, in order of probe, footprint and group, before seams are split. Requires
/// a legal draw and configuration.
[[nodiscard]] std::vector<Beat> fragment_beats(const Draw& draw, const UnitFragment& fragment,
                                               const UnitConfig& config,
                                               const EvalConfig& eval = {});

/// The directions in which a beat collides: unit-timing.md, "Seam split".
struct SeamCollision {
  bool in_u = false, in_v = false;
};
[[nodiscard]] SeamCollision seam_collision(const Beat& beat);

/// 1, 2 or 4 sub-beats: the beat with a part of its taps each (a TMU's, or all, may be none).
[[nodiscard]] std::vector<Beat> split_beat(const Beat& beat);

/// Adds what a fragment counts whatever the time: fragments, pixels, beats, bank_conflicts, words,
/// taps, palette_lookups and the multiplies; it leaves the other counters alone. Words and the
/// multiplies of effects depend on the evaluator's configuration.
void count_fragment(const Draw& draw, const UnitFragment& fragment, const UnitConfig& config,
                    UnitCounters& counters, const EvalConfig& eval = {});

}  // namespace ptm::reference
