#pragma once
#include <verilated.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <random>
#include <string>
#include <vector>

/// One tag bank of a TMU's cache, for a Verilated ptm_front_tag_bank of four sets, whose own TMU is
/// the second of three, against a list of uses a set. Includes nothing of this project: tests
/// compile it against changed RTL too.
namespace ptm::tests {

inline constexpr unsigned kBankSets = 4, kBankTmus = 3, kBankTmu = 1;

/// What stands in a set: a line or nothing in each way, and the ways from the one used last to the
/// one used longest ago.
struct ListedSet {
  explicit ListedSet(unsigned ways) : line(ways) {}

  struct Use {
    bool hit;
    unsigned way;
  };
  /// A look-up: of a hit the way, else the lowest that holds nothing, else the one used longest
  /// ago.
  Use use(std::uint32_t wanted) {
    unsigned way = 0;
    const bool hit = holds(wanted);
    if (hit) {
      way = static_cast<unsigned>(std::find(line.begin(), line.end(), wanted) - line.begin());
    } else if (const auto empty = std::find(line.begin(), line.end(), std::nullopt);
               empty != line.end()) {
      way = static_cast<unsigned>(empty - line.begin());
    } else {
      way = used.back();
    }
    line[way] = wanted;
    std::erase(used, way);
    used.insert(used.begin(), way);
    return {hit, way};
  }
  [[nodiscard]] bool holds(std::uint32_t wanted) const {
    return std::find(line.begin(), line.end(), wanted) != line.end();
  }
  void invalidate() {
    std::fill(line.begin(), line.end(), std::nullopt);
    used.clear();
  }

  std::vector<std::optional<std::uint32_t>> line;
  std::vector<unsigned> used;
};

template <class Dut>
class TagBankCheck {
 public:
  explicit TagBankCheck(unsigned ways) : ways_(ways), sets_(kBankSets, ListedSet(ways)) {
    replaced_.resize(ways);
    held_in_way_.resize(ways);
  }

  /// Random look-ups, cycle after cycle and with gaps, and misses of the other TMUs; what is wrong
  /// first, or nothing.
  std::string run() {
    reset();
    for (int cycle = 0; cycle < 60'000; ++cycle) {
      const std::string wrong = step();
      if (!wrong.empty()) return "cycle " + std::to_string(cycle) + ": " + wrong;
    }
    dut_.final();
    for (unsigned way = 0; way < ways_; ++way) {
      if (replaced_[way] < 500) return "way " + std::to_string(way) + " is hardly ever replaced";
      if (held_in_way_[way] < 500) return "way " + std::to_string(way) + " hardly ever holds";
    }
    return "";
  }

 private:
  struct LookUp {
    unsigned set;
    std::uint32_t line;
  };
  struct OthersMiss {
    std::uint32_t line = 0;
    bool held = false;
  };

  unsigned below(unsigned limit) { return static_cast<unsigned>(rng_() % limit); }
  bool one_in(unsigned n) { return below(n) == 0; }

  /// Lines of a set: one that is asked for most often, and those that differ from it in one of the
  /// 26 bits alone, a few of them often.
  std::uint32_t pick_line(unsigned set) {
    const std::uint32_t first = 0x1234560U + set;
    if (one_in(4)) return first;
    return first ^ (1U << (one_in(3) ? below(26) : 5 * below(ways_ + 2) % 26));
  }

  template <class Pin>
  static void put(Pin& pin, std::uint64_t value) {
    pin = static_cast<Pin>(value);
  }

  void reset() {
    put(dut_.clk_i, 0);
    put(dut_.look_up_i, 0);
    put(dut_.read_i, 0);
    put(dut_.invalidate_i, 0);
    put(dut_.any_miss_i, 0);
    put(dut_.any_missed_i, 0);
    put(dut_.rst_ni, 1);
    dut_.eval();
    put(dut_.rst_ni, 0);
    dut_.eval();
    edge();
    put(dut_.rst_ni, 1);
    dut_.eval();
  }
  void edge() {
    put(dut_.clk_i, 1);
    dut_.eval();
    put(dut_.clk_i, 0);
    dut_.eval();
  }

  /// A cycle: the look-up whose set was read in the one before, the next one's read, misses of
  /// others, and the lines of those of the cycle before.
  std::string step() {
    const std::optional<LookUp> now = next_;
    next_.reset();
    const bool invalidate = !now && one_in(200);
    if (!invalidate && !one_in(5)) {
      const unsigned set = one_in(2) ? 0 : below(kBankSets);
      next_ = LookUp{set, pick_line(set)};
    }
    put(dut_.invalidate_i, invalidate);
    put(dut_.read_i, next_.has_value());
    put(dut_.read_set_i, next_ ? next_->set : below(256));
    put(dut_.look_up_i, now.has_value());
    put(dut_.set_i, now ? now->set : below(kBankSets));
    put(dut_.line_i, now ? now->line : below(1U << 26));
    const std::vector<OthersMiss> before = others_;
    put(dut_.any_missed_i, any_miss_);
    drive_others();
    for (unsigned t = 0; t < kBankTmus; ++t) put_line(t, before[t].line);
    dut_.eval();

    std::string wrong = compare_look_up(now);
    for (unsigned t = 0; t < kBankTmus && wrong.empty(); ++t) {
      const bool held = (dut_.held_o >> t & 1) != 0;
      if (held != before[t].held) {
        wrong = "TMU " + std::to_string(t) + "'s missed line is " + (held ? "" : "not ") + "held";
      }
    }
    edge();
    if (invalidate) {
      for (ListedSet& set : sets_) set.invalidate();
    }
    return wrong;
  }

  std::string compare_look_up(const std::optional<LookUp>& now) {
    const bool hit = dut_.hit_o != 0;
    if (!now) return hit ? "a hit without a look-up" : "";
    ListedSet& set = sets_[now->set];
    const bool full = set.used.size() == ways_;
    const ListedSet::Use use = set.use(now->line);
    const unsigned place = now->set * ways_ + use.way;
    if (!use.hit && full) ++replaced_[use.way];
    if (hit == use.hit && dut_.place_o == place) return "";
    return std::string(hit ? "a hit" : "a miss") + " at " + std::to_string(dut_.place_o) +
           ", expected " + (use.hit ? "a hit" : "a miss") + " at " + std::to_string(place);
  }

  /// What other TMUs look up in a cycle with a miss is looked for in what stood here at its start.
  void drive_others() {
    std::uint32_t miss_set = 0;
    any_miss_ = one_in(2);
    for (unsigned t = 0; t < kBankTmus; ++t) {
      others_[t] = {below(1U << 26), false};
      const unsigned number = below(kBankSets);
      miss_set |= number << 8 * t;
      if (!any_miss_) continue;
      const ListedSet& set = sets_[number];
      const std::optional<std::uint32_t> stands = set.line[below(ways_)];
      others_[t].line = stands && one_in(2) ? *stands : pick_line(number);
      if (t == kBankTmu) continue;  // its own misses are nobody's duplicates
      others_[t].held = set.holds(others_[t].line);
      for (unsigned way = 0; way < ways_; ++way) {
        held_in_way_[way] += set.line[way] == others_[t].line;
      }
    }
    put(dut_.any_miss_i, any_miss_);
    put(dut_.miss_set_i, miss_set);
  }
  /// Bits 26 t and on of a port of 78 bits.
  void put_line(unsigned t, std::uint32_t line) {
    for (unsigned bit = 0; bit < 26; ++bit) {
      const unsigned at = 26 * t + bit;
      const std::uint32_t mask = std::uint32_t{1} << at % 32;
      auto& word = dut_.missed_line_i[at / 32];
      word = (line >> bit & 1) != 0 ? word | mask : word & ~mask;
    }
  }

  unsigned ways_;
  std::vector<ListedSet> sets_;
  std::vector<unsigned> replaced_, held_in_way_;
  std::vector<OthersMiss> others_ = std::vector<OthersMiss>(kBankTmus);
  bool any_miss_ = false;
  std::optional<LookUp> next_;
  std::mt19937 rng_{3};
  VerilatedContext context_;
  Dut dut_{&context_};
};

/// Which way holds what after any order of uses, which is replaced, and which lines other TMUs find
/// there; what is wrong first, or nothing.
template <class Dut>
std::string check_tag_bank(unsigned ways) {
  return TagBankCheck<Dut>(ways).run();
}

}  // namespace ptm::tests
