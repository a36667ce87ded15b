#include "model/pipeline/unit/tags.h"

namespace ptm::pipeline {

void Tags::reset(bool keep_cache) {
  if (!keep_cache) {
    for (TagCache& cache : caches_) cache.invalidate();
  }
  std::fill(fifo_.begin(), fifo_.end(), 0);
  next_place_ = 0;
  left_ = 0;
  commit_empty_ = missed_ = false;
  counters_ = {};
}

/// The different tiles that hold one texture's taps, at most four. They are ordered by the first
/// tap that needs each of them, the taps' order being 00, 10, 01, 11. Returns how many there are.
inline unsigned Tags::list_tiles(const UnitBeat& beat, const TexturePlan& texture,
                                 std::array<TilePlace, 4>& tiles) const {
  const FootprintTiles& at = (*beat.tiles)[static_cast<std::size_t>(texture.texture)];
  const LevelPlan& level = texture.level[at.level];
  const auto planes = static_cast<std::uint32_t>(texture.planes);
  const std::uint32_t salt = 3 * at.level + 5 * static_cast<std::uint32_t>(texture.texture);
  unsigned count = 0;
  if (beat.mask == 15) [[likely]] {
    if (at.taps == 0) return 0;
    const std::uint32_t right = at.tx1 - at.tx0;
    for (std::uint32_t ty = at.ty0;; ty = at.ty1) {
      const std::uint32_t line = level.base + (ty * level.across + at.tx0) * planes;
      tiles[count++] = map_.place(at.tx0, ty, salt, line);
      if (right != 0) tiles[count++] = map_.place(at.tx1, ty, salt, line + right * planes);
      if (ty == at.ty1) return count;
    }
  }
  unsigned seen = 0;
  for (unsigned tap = 0; tap < reference::kTaps; ++tap) {
    if ((at.taps & beat.mask & (1U << tap)) == 0) continue;
    // Where both columns lie in one tile, taps 0 and 1 share it, and so do taps 2 and 3; likewise
    // for rows. Masking away the bits that make no difference gives the lowest-numbered of the taps
    // that share this tap's tile, which stands for the tile.
    const unsigned tile = tap & ((at.tx0 != at.tx1 ? 1U : 0U) | (at.ty0 != at.ty1 ? 2U : 0U));
    if ((seen & (1U << tile)) != 0) continue;
    seen |= 1U << tile;
    const std::uint32_t tx = (tap & 1) != 0 ? at.tx1 : at.tx0;
    const std::uint32_t ty = (tap & 2) != 0 ? at.ty1 : at.ty0;
    tiles[count++] = map_.place(tx, ty, salt, level.base + (ty * level.across + tx) * planes);
  }
  return count;
}

/// Looks up the lines of one word, a line for each tile, in its TMU's cache, and changes nothing in
/// the cache. Sorts the look-ups into misses, hits on the line of their set that was used last,
/// which need no update, and other hits (`older_`), which do.
void Tags::look_up_word(const UnitBeat& beat, std::size_t tmu, std::uint32_t plane, unsigned count,
                        const std::array<TilePlace, 4>& tiles, std::size_t texture) {
  const TagCache& cache = caches_[tmu];
  unsigned misses = 0, older = 0;
  for (unsigned n = 0; n < count; ++n) {
    const LookUp at{map_.row(tiles[n], plane), tiles[n].line + plane};
    if (cache.used_last(at.row, at.line)) continue;  // a use of it would change no order
    if (cache.holds(at.row, at.line)) {
      older_[tmu][older++] = at;
    } else {
      misses_[tmu][misses++] = at;
    }
  }
  older_count_[tmu] = older;
  miss_count_[tmu] = misses;
  counters_.hits[draw_of(beat)][texture] += count - misses;
  counters_.misses[draw_of(beat)][texture] += misses;
}

/// Whether another TMU's cache holds the line in the same set and bank: the counter
/// duplicate_lines.
bool Tags::elsewhere(std::size_t tmu, const LookUp& at) const {
  for (std::size_t other = 0; other < caches_.size(); ++other) {
    if (other != tmu && caches_[other].holds(at.row, at.line)) return true;
  }
  return false;
}

/// Whether every look-up of the beat hits the line of its set that was used last. Such a beat
/// misses nothing and changes no order of replacement, so only its hits need counting. It is by far
/// the most common kind, which is why it is asked for first.
bool Tags::all_used_last(const BeatPlan& plan, const std::array<unsigned, 2>& counts,
                         const std::array<std::array<TilePlace, 4>, 2>& tiles) const {
  for (std::size_t tmu = 0; tmu < plan.words; ++tmu) {
    const WordPlan& word = plan.word[tmu];
    for (unsigned n = 0; n < counts[word.texture]; ++n) {
      const TilePlace& tile = tiles[word.texture][n];
      if (!caches_[tmu].used_last(map_.row(tile, word.plane), tile.line + word.plane)) return false;
    }
  }
  return true;
}

/// The beat's cycle of look-up in T, rule T2: all look-ups see the caches as the beat before left
/// them; only then are hits marked as used and misses allocated.
void Tags::look_up(UnitBeat& beat) {
  const BeatPlan& plan = *beat.plan;
  std::array<std::array<TilePlace, 4>, 2> tiles;
  std::array<unsigned, 2> tile_count{};
  for (unsigned n = 0; n < beat.draw->texture_count; ++n) {
    const TexturePlan& texture = beat.draw->texture[n];
    const auto t = static_cast<std::size_t>(texture.texture);
    if (plan.words_of[t] != 0) tile_count[t] = list_tiles(beat, texture, tiles[t]);
  }
  if (all_used_last(plan, tile_count, tiles)) {
    for (std::size_t t = 0; t < 2; ++t) {
      counters_.hits[draw_of(beat)][t] += plan.words_of[t] * tile_count[t];
    }
    return;
  }
  unsigned ranks = 0;
  for (std::size_t tmu = 0; tmu < plan.words; ++tmu) {
    const WordPlan& word = plan.word[tmu];
    look_up_word(beat, tmu, word.plane, tile_count[word.texture], tiles[word.texture],
                 word.texture);
    ranks = std::max(ranks, miss_count_[tmu]);
  }
  if (ranks != 0) {
    missed_ = true;
    for (std::size_t tmu = 0; tmu < plan.words; ++tmu) {
      for (unsigned r = 0; r < miss_count_[tmu]; ++r) {
        if (elsewhere(tmu, misses_[tmu][r])) ++counters_.duplicates;
      }
    }
  }
  for (std::size_t tmu = 0; tmu < plan.words; ++tmu) {
    for (unsigned n = 0; n < older_count_[tmu]; ++n) {
      caches_[tmu].use(older_[tmu][n].row, older_[tmu][n].line);
    }
    for (unsigned r = 0; r < miss_count_[tmu]; ++r) {
      caches_[tmu].use(misses_[tmu][r].row, misses_[tmu][r].line);
    }
  }
  beat.ranks = ranks;
}

/// Pushes the beat's missing lines to the miss ring, one rank a cycle, as slots become free;
/// `place` is the first cycle in which the fragment FIFO has a place for the beat. Returns the
/// cycle in which the last rank is pushed, which is the one in which the beat leaves T.
Cycle Tags::push_ranks(UnitBeat& beat, Cycle enter, Cycle place) {
  Cycle next = enter + 1;
  for (unsigned rank = 0; rank < beat.ranks; ++rank) {
    unsigned lines = 0;
    for (std::size_t tmu = 0; tmu < beat.plan->words; ++tmu) lines += miss_count_[tmu] > rank;
    const Cycle available = ring_.available(lines);
    // Counter 6, cycles_ring_full: K is empty and this rank lacks slots. That can be so in one
    // cycle only. The slots that are lacking belong to an earlier beat that has not left K yet. If
    // K is empty, that beat is still in the FIFO; it must be the one just before this, all older
    // ones having left K, and it is in the FIFO and not in K only in the cycle after it left T.
    if (rank == 0 && commit_empty_ && next == left_ + 1 && available > next) {
      ++counters_.ring_full;
    }
    next = std::max(next, available);
    if (rank + 1 == beat.ranks) next = std::max(next, place);
    Cycle usable = 0;
    for (std::size_t tmu = 0; tmu < beat.plan->words; ++tmu) {
      if (miss_count_[tmu] <= rank) continue;
      usable = std::max(usable, ring_.push(misses_[tmu][rank].line, next, beat));
    }
    beat.usable[rank] = usable;
    ++next;
  }
  return next - 1;
}

}  // namespace ptm::pipeline
