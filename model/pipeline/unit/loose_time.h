#pragma once
#include <algorithm>
#include <array>
#include <memory>
#include <span>
#include <vector>

#include "model/pipeline/memory_timing.h"
#include "model/reference/unit/unit_config.h"
#include "model/reference/unit/unit_memory.h"

namespace ptm::pipeline {

/// The two clocks of timing `loose`: tags, which run ahead, and commit, which waits for lines.
class LooseTime {
 public:
  LooseTime(const reference::UnitConfig& unit, std::uint32_t base,
            std::unique_ptr<MemoryTiming> memory)
      : memory_(std::move(memory)),
        base_(base),
        slots_(static_cast<std::size_t>(unit.miss_fifo)),
        depth_(unit.fragment_fifo) {}

  /// Beats that follow each other, in `tags` cycles at the tags and `commit` at the commit stage;
  /// the first fragment's, `own` of them, miss `lines`, `width` in each rank.
  void advance(double beats, double tags, double commit, std::span<const std::uint32_t> lines,
               std::size_t width, double own) {
    double pushed = std::max(tags_ + 1, place_for(beats_ + 1));
    double ready = 0, ranks = 0;
    const std::size_t first = requests_;
    for (std::size_t n = 0; n < lines.size(); ++n) {
      if (n % width == 0) {
        const std::size_t last = (first + std::min(n + width, lines.size()) - 1) % slots_.size();
        pushed = std::max(pushed + (n == 0 ? 0 : 1), slots_[last]);
        ++ranks;
      }
      ready = std::max(ready, request(lines[n], pushed));
    }
    ranks = std::max(ranks, 1.0);
    const double used = std::min(ranks, own);  // a beat's first rank takes no time of its own
    const double begins = std::max({commit_ + ranks, pushed + 2, ready});
    for (std::size_t n = 0; n < lines.size(); ++n) slots_[(first + n) % slots_.size()] = begins + 1;
    beats_ += beats;
    tags_ = std::max(pushed + tags - used, place_for(beats_));
    commit_ = std::max(begins + commit - used, tags_ + 2);
    history_[newest_ = (newest_ + 1) % kHistory] = {beats_, commit_};
  }

  [[nodiscard]] double commit() const { return commit_; }
  [[nodiscard]] double beats() const { return beats_; }
  [[nodiscard]] std::uint64_t requests() const { return requests_; }

 private:
  struct Mark {
    double beats = 0, left = 0;
  };
  static constexpr std::size_t kHistory = 2048;  // more than the deepest FIFO has beats

  /// From when on the FIFO has a place for that beat: the one `depth` before has gone on to K.
  double place_for(double beat) {
    const double gone = beat - depth_;
    if (gone <= 0) return 0;
    while (oldest_ != newest_ && history_[oldest_].beats < gone) oldest_ = (oldest_ + 1) % kHistory;
    const Mark& mark = history_[oldest_];
    return mark.left - std::max(0.0, mark.beats - gone);
  }

  /// Returns from when on the line may be committed.
  double request(std::uint32_t line, double pushed) {
    sent_ = std::max(static_cast<Cycle>(pushed) + 1, sent_ + 1);
    return static_cast<double>(
        memory_->line(requests_++, reference::outer_line(base_, line), sent_) + 2);
  }

  std::unique_ptr<MemoryTiming> memory_;
  std::uint32_t base_;
  std::vector<double> slots_;  ///< when each is free
  std::array<Mark, kHistory> history_{};
  std::size_t oldest_ = 0, newest_ = 0;
  double depth_;
  double tags_ = 4, commit_ = 6, beats_ = 0;  // of the beat before the first: unit-timing.md
  std::uint64_t requests_ = 0;
  Cycle sent_ = 0;
};

}  // namespace ptm::pipeline
