#pragma once
#include <array>
#include <vector>

#include "model/reference/eval_config.h"
#include "model/reference/unit/draw.h"
#include "model/reference/unit/unit_config.h"

/// What of a draw does not change from fragment to fragment, computed once a frame.
namespace ptm::pipeline {

inline constexpr int kTmusMax = 3;
/// Of an RGB map of more than 10 bits a coefficient, with a colour texture and four sets.
inline constexpr int kDrawWordsMax = 22;

struct LevelPlan {
  int width = 1, height = 1;
  std::uint32_t across = 1;  ///< tiles
  std::uint32_t base = 0;    ///< line
};

struct TexturePlan {
  int texture = 0;  ///< 0 the map, 1 the colour
  int planes = 1;
  int levels = 1;
  std::array<LevelPlan, reference::kLevelsMax> level{};
};

struct WordPlan {
  std::uint32_t texture = 0, plane = 0;
};

/// One beat of a footprint: a word a TMU.
struct BeatPlan {
  unsigned words = 0;
  std::array<WordPlan, kTmusMax> word{};
  std::array<unsigned, 2> words_of{};       ///< of map and colour
  std::array<unsigned, 2> filter_fields{};  ///< of those words, for multiplies: docs/spec/unit.md
  unsigned address_multiplies = 0;          ///< without those of probes
  unsigned palette_ports = 0;               ///< 0: no word of it is looked up
};

struct DrawPlan {
  reference::Draw draw;
  std::array<TexturePlan, 2> texture{};
  unsigned texture_count = 0;  ///< of `texture`; the map first, if there is one
  std::array<BeatPlan, kDrawWordsMax> beat{};
  unsigned beats = 0;  ///< a footprint
  /// Of a whole footprint, by texture or in all.
  std::array<unsigned, 2> words_of{}, filter_fields{};
  unsigned address_multiplies = 0;
  struct Reader {
    std::uint32_t tmu = 0, plane = 0;
  };
  /// Who reads a texture, in the order of its words: `words_of` of them.
  std::array<std::array<Reader, kDrawWordsMax>, 2> readers{};
  unsigned passes = 1;        ///< the map's own, in time
  unsigned extra_passes = 0;  ///< before them
  bool effects = false;       ///< there are such, or stages behind the combine stage
  /// One pass, no palette, no effects: a beat may be a fragment, and pass as it came.
  bool beats_alone = false;
  unsigned palette_ports = 0;  ///< 0: the map has no palette
  unsigned eval_multiplies = 0, combine_multiplies = 0, effect_multiplies = 0;
};

/// Words and the multiplies of effects depend on the evaluator's configuration.
[[nodiscard]] DrawPlan plan_draw(const reference::Draw& draw, const reference::UnitConfig& unit,
                                 const reference::EvalConfig& eval);
[[nodiscard]] std::vector<DrawPlan> plan_draws(const std::vector<reference::Draw>& draws,
                                               const reference::UnitConfig& unit,
                                               const reference::EvalConfig& eval);

}  // namespace ptm::pipeline
