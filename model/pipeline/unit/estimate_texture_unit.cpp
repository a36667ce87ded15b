#include "model/pipeline/estimate_texture_unit.h"

#include <cmath>
#include <cstdlib>

#include "model/pipeline/effects/stages.h"
#include "model/pipeline/unit/loose_sample.h"
#include "model/pipeline/unit/loose_time.h"

namespace ptm::pipeline {
namespace {

using reference::UnitFragment;

/// Cycles from a beat's leaving the commit stage to its pixel's being taken, without effects.
constexpr double kDrain = 18;
/// Cycles after which saved fragments are spent at the latest, so that FIFO and ring are felt.
constexpr double kSaved = 32;

class LooseUnit {
 public:
  LooseUnit(const reference::UnitConfig& unit, const reference::UnitState& state,
            const MemoryModel& memory, int tile, const StreamTiming& timing,
            const reference::EvalConfig& eval)
      : draws_(plan_draws(state.draws, unit, eval)),
        tmus_(static_cast<std::size_t>(unit.tmus)),
        tile_(static_cast<std::size_t>(tile)),
        chain_(effects::chain_registers(unit.stages)),
        map_(unit),
        time_(unit, state.base, make_memory(memory)) {
    for (int t = 0; t < unit.tmus; ++t) caches_.emplace_back(map_.rows(), unit.ways);
    const double waits = timing.input_gap * 2.5 + static_cast<double>(timing.idle) / timing.group;
    input_pace_ = 1 + waits;
    output_pace_ = 1 / (1 - timing.output_stall);
  }

  UnitEstimate run(std::span<const UnitFragment> fragments) {
    for (std::size_t n = 0; n < fragments.size();) {
      prefetch(fragments, n + kAhead * tile_);
      prefetch(fragments, n + kAhead * tile_ + tile_ - 1);
      const std::size_t length = span_length(fragments.subspan(n));
      draw_span(fragments.subspan(n, length));
      n += length;
    }
    advance();
    UnitEstimate out{.fragments = fragments.size()};
    if (fragments.empty()) return out;
    const DrawPlan& draw = draws_[fragments.back().draw];
    const double behind = kDrain + draw.passes + draw.extra_passes + chain_;
    out.cycles = static_cast<std::uint64_t>(time_.commit() + behind);
    out.beats = static_cast<std::uint64_t>(time_.beats());
    out.lines_read = time_.requests();
    return out;
  }

 private:
  /// Most fragments are never looked at, and memory's own prefetch does not guess which are.
  static constexpr std::size_t kAhead = 12;
  static void prefetch(std::span<const UnitFragment> fragments, std::size_t n) {
    if (n < fragments.size()) __builtin_prefetch(&fragments[n]);
  }

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

  void draw_span(std::span<const UnitFragment> span) {
    const DrawPlan& draw = draws_[span.front().draw];
    const std::uint64_t last = eye_.look(draw, span.back());
    const LooseEye::Part last_part = eye_.parts().front();
    const bool palette = draw.palette_ports != 0;
    const double last_commit = palette ? eye_.cost(draw).commit : 0;
    const std::uint64_t first = eye_.look(draw, span.front());
    if (palette) {  // taps make its time, and change where tiles do not
      cost_ = eye_.cost(draw);
      cost_.commit = (cost_.commit + last_commit) / 2;
    }
    if (all_hit_ && first == first_hash_ && last == last_hash_) return spend(span.size());
    first_hash_ = first;
    last_hash_ = last;
    all_hit_ = true;
    if (!palette) cost_ = eye_.cost(draw);
    const LooseEye::Part& part = eye_.parts().front();
    const Distance distance = between(part, span.front(), span.back());
    if (eye_.parts().size() == 1 && along_a_row(part, last_part, distance)) {
      walk_row(draw, part, last_part.span, span.size());
    } else {
      walk(draw, first, span, 3 + std::abs(distance.x) + std::abs(distance.y));
    }
  }

  /// Tiles of texels between two fragments, rounded down.
  struct Distance {
    std::int64_t x = 0, y = 0;
  };
  [[nodiscard]] static Distance between(const LooseEye::Part& part, const UnitFragment& a,
                                        const UnitFragment& b) {
    const LevelPlan& level = part.texture->level[static_cast<std::size_t>(part.level)];
    return {(std::int64_t{b.u} - a.u) * level.width >> 22,
            (std::int64_t{b.v} - a.v) * level.height >> 22};
  }

  /// Whether a span stays in one row of tiles, or between two, and crosses no seam.
  [[nodiscard]] static bool along_a_row(const LooseEye::Part& a, const LooseEye::Part& b,
                                        Distance distance) {
    const std::int64_t columns = std::int64_t{b.span.across.t0} - a.span.across.t0;
    return a.level == b.level && a.span.down.t0 == b.span.down.t0 &&
           a.span.down.t1 == b.span.down.t1 && distance.x >= 0 && columns >= distance.x &&
           columns <= distance.x + 1;
  }

  void walk_row(const DrawPlan& draw, const LooseEye::Part& part, const FootprintSpan& last,
                std::size_t fragments) {
    const Box box{part.texture,        part.level,
                  part.span.across.t0, std::max(last.across.t0, last.across.t1),
                  part.span.down.t0,   part.span.down.t1};
    LooseEye::Part column = part;
    TileSpan& down = column.span.down;
    const bool upper = !in_box(box, down.t0), lower = !in_box(box, down.t1);
    box_ = box;
    looked_up_ = 0;
    if (!upper && !lower) return spend(fragments);
    if (!upper) down.t0 = down.t1;
    if (!lower) down.t1 = down.t0;
    const std::uint32_t count = box.right - box.left + 1;
    std::size_t at = 0;
    for (std::uint32_t n = 0; n < count; ++n) {
      column.span.across.t0 = column.span.across.t1 = box.left + n;
      look_up_part(draw, column);
      const std::size_t next = n + 1 == count ? fragments : fragments * (n + 1) / count;
      if (next != at) spend(next - at);
      at = next;
    }
  }

  /// Tiles that the walk before has just used.
  struct Box {
    const TexturePlan* texture = nullptr;
    int level = 0;
    std::uint32_t left = 0, right = 0, top = 0, bottom = 0;
  };
  [[nodiscard]] bool in_box(const Box& box, std::uint32_t row) const {
    return box_.texture == box.texture && box_.level == box.level && box_.left <= box.left &&
           box.right <= box_.right && (row == box_.top || row == box_.bottom);
  }

  void walk(const DrawPlan& draw, std::uint64_t first, std::span<const UnitFragment> span,
            std::int64_t looks) {
    box_ = {};
    const std::size_t steps = std::min(span.size(), static_cast<std::size_t>(looks));
    std::uint64_t hash = first;
    std::size_t at = 0;
    for (std::size_t step = 0; step < steps; ++step) {
      const std::size_t next = (step + 1) * (span.size() - 1) / std::max<std::size_t>(steps - 1, 1);
      const std::size_t end = step + 1 == steps ? span.size() : std::max(next, at + 1);
      look_up(draw, hash);
      spend(end - at);
      if (end == span.size()) break;
      at = end;
      hash = eye_.look(draw, span[at]);
      cost_ = eye_.cost(draw);
    }
  }

  /// Fragments that cost what the one looked at last did. They are saved up until a line is missed.
  void spend(std::size_t fragments) {
    const auto count = static_cast<double>(fragments);
    if (saved_beats_ == 0) first_beats_ = cost_.beats;
    saved_beats_ += cost_.beats * count;
    saved_tags_ += std::max(cost_.beats, input_pace_) * count;
    saved_commit_ += std::max(cost_.commit, output_pace_) * count;
    if (saved_tags_ >= kSaved) advance();
  }
  void advance() {
    if (saved_beats_ == 0) return;
    time_.advance(saved_beats_, saved_tags_, saved_commit_, lines_, width_, first_beats_);
    saved_beats_ = saved_tags_ = saved_commit_ = 0;
    lines_.clear();
  }

  /// The lines that the fragment looked at last misses, rank by rank, into lines_.
  void look_up(const DrawPlan& draw, std::uint64_t hash) {
    if (hash == looked_up_) return;
    looked_up_ = hash;
    for (const LooseEye::Part& part : eye_.parts()) look_up_part(draw, part);
  }

  void look_up_part(const DrawPlan& draw, const LooseEye::Part& part) {
    const FootprintSpan& span = part.span;
    const LevelPlan& level = part.texture->level[static_cast<std::size_t>(part.level)];
    const auto planes = static_cast<std::uint32_t>(part.texture->planes);
    const auto salt = static_cast<std::uint32_t>(3 * part.level + 5 * part.texture->texture);
    for (std::uint32_t ty = span.down.t0;; ty = span.down.t1) {
      for (std::uint32_t tx = span.across.t0;; tx = span.across.t1) {
        const TilePlace tile =
            map_.place(tx, ty, salt, level.base + (ty * level.across + tx) * planes);
        look_up_tile(draw, static_cast<std::size_t>(part.texture->texture), tile);
        if (tx == span.across.t1) break;
      }
      if (ty == span.down.t1) break;
    }
  }

  void look_up_tile(const DrawPlan& draw, std::size_t texture, const TilePlace& tile) {
    for (unsigned w = 0; w < draw.words_of[texture]; ++w) {
      const DrawPlan::Reader& reader = draw.readers[texture][w];
      const std::uint32_t line = tile.line + reader.plane;
      if (caches_[reader.tmu].use(map_.row(tile, reader.plane), line)) continue;
      if (saved_beats_ != 0) advance();
      all_hit_ = false;
      width_ = std::min<std::size_t>(tmus_, draw.words_of[0] + draw.words_of[1]);
      lines_.push_back(line);
    }
  }

  std::vector<DrawPlan> draws_;
  std::size_t tmus_, tile_;
  double chain_;  ///< registers behind the combine stage
  SetMap map_;
  std::vector<TagCache> caches_;
  LooseTime time_;
  double input_pace_ = 1, output_pace_ = 1;
  LooseEye eye_;
  LooseCost cost_;
  Box box_;
  std::vector<std::uint32_t> lines_;
  std::size_t width_ = 1;  ///< lines of a rank
  std::uint64_t first_hash_ = 0, last_hash_ = 0, looked_up_ = 0;
  bool all_hit_ = false;    ///< in the last walk
  double first_beats_ = 1;  ///< of the first of the fragments saved up
  double saved_beats_ = 0, saved_tags_ = 0, saved_commit_ = 0;
};

}  // namespace

UnitEstimate estimate_texture_unit(const reference::UnitConfig& unit,
                                   const reference::UnitState& state, const UnitFrame& frame,
                                   const MemoryModel& memory, int tile, const StreamTiming& timing,
                                   const reference::EvalConfig& eval) {
  return LooseUnit(unit, state, memory, tile, timing, eval).run(frame.fragments);
}

}  // namespace ptm::pipeline
