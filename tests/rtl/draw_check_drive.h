#pragma once
#include "model/reference/unit/register_map.h"
#include "tests/rtl/drive_frame.h"

/// Draws that are rewritten while fragments are offered: docs/spec/unit.md, Registers.
namespace ptm::tests {

/// The check of a draw looks at a level a cycle, 13 of the map and 13 of the colour texture, and
/// waits a cycle before them.
inline constexpr std::uint64_t kCheckCycles = 1 + 26;

/// What a draw's control register is written with, and its other registers.
struct DrawWrites {
  explicit DrawWrites(const reference::UnitState& state, int number) {
    const auto d = static_cast<std::size_t>(number);
    const reference::EffectTable table =
        d < state.tables.size() ? state.tables[d] : reference::EffectTable{};
    for (const auto& write : register_writes(state.draws[d], number, table)) {
      if (write.address == reference::registers::kDrawStride * d) {
        control = write;
      } else {
        others.push_back(write);
      }
    }
  }
  reference::RegisterWrite control{};
  std::vector<reference::RegisterWrite> others;
};

/// A control register written twice, in cycles 0 and `apart`, with fragments offered from cycle 1
/// on where `offers` says so, and from the second write on in any case.
struct Rewrite {
  std::uint64_t apart = 1;
  reference::RegisterWrite first, second;
  std::optional<reference::RegisterWrite> between =
      std::nullopt;  ///< in the cycle before the second
  bool offers = true;
};

struct Rewritten {
  DrivenFrame before, after;  ///< after: cycle 0 is the one after the second write
};

template <class Unit>
Rewritten drive_rewrite(Unit& unit, const reference::UnitState& state,
                        std::span<const reference::UnitFragment> fragments, unsigned slots,
                        const Rewrite& rewrite, std::uint64_t limit) {
  const auto write = [&unit](const reference::RegisterWrite& w) { unit.write(w.address, w.data); };
  Rewritten out;
  write(rewrite.first);
  const std::uint64_t cycles = rewrite.apart - 1 - (rewrite.between ? 1 : 0);
  if (rewrite.offers) {
    out.before = drive_frame(unit, state, fragments, slots, {.limit = cycles});
  } else {
    for (std::uint64_t n = 0; n < cycles; ++n) (void)unit.cycle({});
  }
  if (rewrite.between) write(*rewrite.between);
  write(rewrite.second);
  out.after = drive_frame(unit, state, fragments, slots, {.limit = limit});
  return out;
}

/// The cycle after the second write in which a fragment is accepted if the draw is legal then. A
/// check that has begun is finished first.
constexpr std::uint64_t accepted_after(std::uint64_t apart) {
  return apart <= kCheckCycles ? 2 * kCheckCycles - apart : kCheckCycles;
}

}  // namespace ptm::tests
