#pragma once
#include <array>
#include <deque>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "model/pipeline/unit_run.h"
#include "model/reference/unit/beats.h"

namespace ptm::tests {

/// docs/spec/unit-timing.md and docs/spec/effects.md stepped cycle by cycle: every register, FIFO,
/// slot and counter as the pages name it, decided from the state at the start of a cycle. Written
/// from the pages alone, to be slow and plain; the pipeline model's maxima and the RTL are held
/// against it.
class SteppedUnit {
 public:
  SteppedUnit(const reference::UnitConfig& unit, const std::vector<reference::Draw>& draws,
              const pipeline::StreamTiming& timing, pipeline::MemoryTiming& memory,
              const reference::EvalConfig& eval = {});

  /// One frame; the caches stay as they are if the frame says so.
  [[nodiscard]] pipeline::UnitFrameResult run(const pipeline::UnitFrame& frame);

 private:
  struct Tap {
    std::uint32_t line = 0;
    std::size_t bank = 0, set = 0;  ///< of the tags
    unsigned number = 0;            ///< 0..3: 00, 10, 01, 11
  };
  struct Word {
    std::size_t tmu = 0;
    int texture = 0, plane = 0;
    bool palette = false, set = false;  ///< looked up; of an extra set
    std::vector<Tap> taps;
  };
  struct LineRead {
    std::uint32_t line = 0;
    pipeline::Cycle pushed = 0;
    std::optional<pipeline::Cycle> arrives;
  };
  struct Beat {
    std::size_t fragment = 0;
    const reference::Draw* draw = nullptr;
    std::vector<Word> words;
    bool split_u = false, split_v = false;
    bool completes = true;     ///< the last or only sub-beat
    bool last = false;         ///< of its fragment, if it completes
    int looked_up_cycles = 0;  ///< look-up cycles in D so far
    bool looked_up = false;
    std::vector<std::vector<std::uint32_t>> ranks;  ///< lines to push
    std::size_t ranks_pushed = 0, ranks_committed = 0;
    std::vector<std::vector<std::size_t>> reads;  ///< of each pushed rank, into reads_
  };
  using Register = std::optional<Beat>;
  struct Way {
    bool valid = false;
    std::uint32_t line = 0;
    std::uint64_t used = 0;
  };

  void begin(bool keep_cache);
  void step();
  void step_output();
  void step_filter();
  void step_commit();
  void step_tags();
  void step_address();
  void step_requests();
  void classify();

  [[nodiscard]] std::vector<Beat> make_beats(std::size_t fragment);
  [[nodiscard]] Word make_word(const reference::Draw& draw, int word,
                               const std::array<reference::Footprint, 2>& footprints) const;
  [[nodiscard]] int own_words(const reference::Draw& draw) const;
  [[nodiscard]] int set_words(const reference::Draw& draw) const;
  [[nodiscard]] Tap make_tap(const reference::Draw& draw, const Word& word,
                             const reference::Footprint& at, unsigned number) const;
  void book_effects(const reference::Draw& draw);
  void book_beat(const Beat& beat, const reference::UnitFragment& fragment, int footprint);
  [[nodiscard]] static std::vector<Beat> split(const Beat& beat);
  void look_up(Beat& beat);
  [[nodiscard]] Way* find(std::size_t tmu, const Tap& tap);
  void allocate(std::size_t tmu, const Tap& tap);
  [[nodiscard]] int palette_cycles(const Beat& beat);
  [[nodiscard]] bool arrived(const Beat& beat) const;

  reference::UnitConfig unit_;
  reference::EvalConfig eval_;
  std::vector<reference::Draw> draws_;
  pipeline::StreamTiming timing_;
  pipeline::MemoryTiming& memory_;
  /// [tmu][bank][set][way]
  std::vector<std::vector<std::vector<std::vector<Way>>>> cache_;
  std::uint64_t uses_ = 0;

  std::span<const reference::UnitFragment> fragments_;
  pipeline::UnitFrameResult result_;
  pipeline::Cycle cycle_ = 0, offered_from_ = 0;
  std::size_t accepted_ = 0;
  std::optional<pipeline::Cycle> first_;

  std::deque<Beat> a0_;  ///< beats of the fragment in A0 still to be sent
  Register a1_, a2_;
  std::deque<Beat> a3_;  ///< sub-beats still to be sent
  Register t_;
  std::deque<Beat> fifo_;
  Register k_, f_, d_, q_, p_, l1_, l2_, l3_;
  struct Operands {
    int extra_left = 0, passes_left = 0;
  };
  std::optional<Operands> o_;
  enum class Pass { extra, part, last };  ///< the last one's pixel leaves with it
  std::array<std::optional<Pass>, 7> e_;
  std::deque<Pass> e_fifo_;
  bool c1_ = false, c2_ = false;
  std::vector<bool> chain_;  ///< registers behind C2: whether each holds a pixel
  int free_slots_ = 0;
  std::vector<LineRead> reads_;
  std::size_t requested_ = 0;

  // What the later steps of a cycle need of the earlier ones, and of the cycle's start.
  bool o_free_ = false, e_free_ = false, f_free_ = false, k_free_ = false, t_free_ = false;
  std::size_t fifo_size_ = 0;
  int free_at_start_ = 0, released_ = 0;
  bool k_held_ = false, k_left_ = false, f_accepted_ = false, ring_full_ = false;
};

}  // namespace ptm::tests
