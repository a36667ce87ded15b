#include "model/pipeline/estimate_texture_unit.h"

#include <cmath>
#include <cstdlib>

#include "model/pipeline/unit/loose_sample.h"
#include "model/pipeline/unit/loose_time.h"

namespace ptm::pipeline {
namespace {

using reference::UnitFragment;

/// Cycles from a beat's leaving the commit stage to its pixel's being taken.
constexpr double kDrain = 17;

/// Whether each TMU reads as many words of each texture as the others.
bool alike(const DrawPlan& draw, unsigned tmus) {
  return draw.words_of[0] % tmus == 0 && draw.words_of[1] % tmus == 0;
}

class LooseUnit {
 public:
  LooseUnit(const reference::UnitConfig& unit, const reference::UnitState& state,
            const MemoryModel& memory, int tile, const StreamTiming& timing)
      : draws_(plan_draws(state.draws, unit)),
        tmus_(static_cast<std::size_t>(unit.tmus)),
        tile_(static_cast<std::size_t>(tile)),
        map_(unit),
        time_(unit, make_memory(memory)) {
    for (int t = 0; t < unit.tmus; ++t) caches_.emplace_back(map_.rows(), unit.ways);
    const double waits = timing.input_gap * 2.5 + static_cast<double>(timing.idle) / timing.group;
    input_pace_ = 1 + waits;
    output_pace_ = 1 / (1 - timing.output_stall);
  }

  UnitEstimate run(std::span<const UnitFragment> fragments) {
    for (std::size_t n = 0; n < fragments.size();) {
      const std::size_t length = span_length(fragments.subspan(n));
      draw_span(fragments.subspan(n, length));
      n += length;
    }
    UnitEstimate out{.fragments = fragments.size()};
    if (fragments.empty()) return out;
    const unsigned passes = draws_[fragments.back().draw].passes;
    out.cycles = static_cast<std::uint64_t>(time_.commit() + kDrain + passes);
    out.beats = static_cast<std::uint64_t>(time_.beats());
    out.lines_read = time_.requests();
    return out;
  }

 private:
  [[nodiscard]] std::size_t span_length(std::span<const UnitFragment> rest) const {
    const UnitFragment& first = rest.front();
    const std::size_t most = std::min(tile_ - first.x % tile_, rest.size());
    const auto joins = [&](std::size_t n) {
      return rest[n].y == first.y && rest[n].x == first.x + n && rest[n].draw == first.draw;
    };
    if (joins(most - 1)) return most;
    std::size_t length = 1;
    while (length < most && joins(length)) ++length;
    return length;
  }

  /// Tiles of texels between two fragments, in steps along either side.
  [[nodiscard]] static std::size_t tiles_between(const DrawPlan& draw, const LooseEye::Part& part,
                                                 const UnitFragment& a, const UnitFragment& b) {
    const LevelPlan& level = part.texture->level[static_cast<std::size_t>(part.level)];
    const auto along = [](std::int32_t from, std::int32_t to, int size) {
      return static_cast<std::size_t>(std::abs(std::int64_t{to} - from) * size >> 22);
    };
    (void)draw;
    return along(a.u, b.u, level.width) + along(a.v, b.v, level.height);
  }

  void draw_span(std::span<const UnitFragment> span) {
    const DrawPlan& draw = draws_[span.front().draw];
    const LooseSample last = eye_.look(draw, span.back());
    const LooseSample first = eye_.look(draw, span.front());
    const bool known = missed_nothing_ && first.hash == first_hash_ && last.hash == last_hash_;
    if (known) return advance(first, span.size(), {}, 1);
    first_hash_ = first.hash;
    last_hash_ = last.hash;
    missed_nothing_ = true;
    const std::size_t steps = std::min(
        span.size(), 2 + tiles_between(draw, eye_.parts().front(), span.front(), span.back()));
    LooseSample sample = first;
    std::size_t at = 0;
    for (std::size_t step = 0; step < steps; ++step) {
      const std::size_t next = (step + 1) * (span.size() - 1) / std::max<std::size_t>(steps - 1, 1);
      const std::size_t end = step + 1 == steps ? span.size() : std::max(next, at + 1);
      look_up(draw, sample.hash);
      advance(sample, end - at, lines_, width_);
      if (end == span.size()) break;
      at = end;
      sample = eye_.look(draw, span[at]);
    }
  }

  void advance(const LooseSample& sample, std::size_t fragments,
               std::span<const std::uint32_t> lines, std::size_t width) {
    const auto count = static_cast<double>(fragments);
    time_.advance(sample.beats * count, std::max(sample.beats, input_pace_) * count,
                  std::max(sample.commit, output_pace_) * count, lines, width);
  }

  /// The lines that the fragment looked at last misses, rank by rank, into lines_.
  void look_up(const DrawPlan& draw, std::uint64_t hash) {
    lines_.clear();
    width_ = 1;
    if (hash == looked_up_) return;
    looked_up_ = hash;
    const bool one_for_all = alike(draw, static_cast<unsigned>(tmus_));
    for (const LooseEye::Part& part : eye_.parts()) look_up_part(draw, part, one_for_all);
    if (lines_.empty()) return;
    width_ = std::min<std::size_t>(tmus_, draw.words_of[0] + draw.words_of[1]);
    missed_nothing_ = false;
  }

  void look_up_part(const DrawPlan& draw, const LooseEye::Part& part, bool one_for_all) {
    const FootprintSpan& span = part.span;
    const LevelPlan& level = part.texture->level[static_cast<std::size_t>(part.level)];
    const auto planes = static_cast<std::uint32_t>(part.texture->planes);
    const auto salt = static_cast<std::uint32_t>(3 * part.level + 5 * part.texture->texture);
    for (std::uint32_t ty = span.down.t0;; ty = span.down.t1) {
      for (std::uint32_t tx = span.across.t0;; tx = span.across.t1) {
        const TilePlace tile =
            map_.place(tx, ty, salt, level.base + (ty * level.across + tx) * planes);
        look_up_tile(draw, part.texture->texture, tile, one_for_all);
        if (tx == span.across.t1) break;
      }
      if (ty == span.down.t1) break;
    }
  }

  void look_up_tile(const DrawPlan& draw, int texture, const TilePlace& tile, bool one_for_all) {
    for (unsigned b = 0; b < draw.beats; ++b) {
      const BeatPlan& beat = draw.beat[b];
      if (one_for_all) {
        const WordPlan& word = beat.word[0];
        if (static_cast<int>(word.texture) != texture) continue;
        if (caches_[0].use(map_.row(tile, word.plane), tile.line + word.plane)) continue;
        for (unsigned w = 0; w < beat.words; ++w) lines_.push_back(tile.line + beat.word[w].plane);
        continue;
      }
      for (unsigned w = 0; w < beat.words; ++w) {
        const WordPlan& word = beat.word[w];
        if (static_cast<int>(word.texture) != texture) continue;
        const std::uint32_t line = tile.line + word.plane;
        if (!caches_[w].use(map_.row(tile, word.plane), line)) lines_.push_back(line);
      }
    }
  }

  std::vector<DrawPlan> draws_;
  std::size_t tmus_, tile_;
  SetMap map_;
  std::vector<TagCache> caches_;
  LooseTime time_;
  double input_pace_ = 1, output_pace_ = 1;
  LooseEye eye_;
  std::vector<std::uint32_t> lines_;
  std::size_t width_ = 1;
  std::uint64_t first_hash_ = 0, last_hash_ = 0, looked_up_ = 0;
  bool missed_nothing_ = false;
};

}  // namespace

UnitEstimate estimate_texture_unit(const reference::UnitConfig& unit,
                                   const reference::UnitState& state, const UnitFrame& frame,
                                   const MemoryModel& memory, int tile,
                                   const StreamTiming& timing) {
  return LooseUnit(unit, state, memory, tile, timing).run(frame.fragments);
}

}  // namespace ptm::pipeline
