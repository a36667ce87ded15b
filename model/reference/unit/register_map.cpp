#include "model/reference/unit/register_map.h"

#include <bit>

#include "model/reference/unit/unit_memory.h"

namespace ptm::reference {
namespace {

struct Field {
  int value, low, bits;
};

/// Fields beside each other in a word; a negative value is its two's complement.
template <std::size_t N>
std::uint32_t word(const Field (&fields)[N]) {
  std::uint32_t out = 0;
  for (const Field& f : fields) {
    out |= (static_cast<std::uint32_t>(f.value) & ((std::uint32_t{1} << f.bits) - 1)) << f.low;
  }
  return out;
}

/// A bit for each code up to the last.
template <class Enumerator>
constexpr int codes_to(Enumerator last) {
  return (2 << static_cast<int>(last)) - 1;
}

constexpr int log2_of(std::size_t power_of_two) { return std::countr_zero(power_of_two); }

constexpr int kProbesLog2Max = 4;  // of a fragment: docs/spec/unit.md
constexpr std::uint32_t kBiasAndShift = 0x001f0fff, kLineAddress = (1U << kLineBits) - 1;

std::uint32_t stored_draw_bits(unsigned at, const UnitConfig& unit) {
  using namespace registers;
  if (at == 0) return 0xffff;
  if (at == 1 || at == 2) return 0x1fff1fff;
  if (at == 3) return 0x1fff0f0f;
  if (at >= 4 && at < 10) return kBiasAndShift;
  if (at == 10) return 0x07ffffff;
  if (at == 12 && unit.extra_passes > 0) {
    return 7U | ((1U << (4 * unit.extra_passes)) - 1) << 4;
  }
  if (at == 13) return (unit.extra_sets > 0 ? 7U : 0U) | (unit.stages != 0 ? 0xff00U : 0U);
  if (at == 14 && unit.stages != 0) return 0xffffffff;
  const bool map = at >= kMapBase && at < kMapBase + kLevelsMax;
  const bool color = at >= kColorBase && at < kColorBase + kLevelsMax;
  return map || color ? kLineAddress : 0;
}

}  // namespace

std::array<std::uint32_t, kCapabilityWords> capability_words(const EvalConfig& config,
                                                             const UnitConfig& unit) {
  const bool nearest = config.rounding == Rounding::nearest;
  return {word({{unit.tmus, 0, 2},
                {unit.ways, 4, 3},
                {unit.cache_kib, 8, 7},
                {unit.palette_lrgb_ports, 16, 3},
                {unit.palette_rgb_ports, 20, 3},
                {unit.eval_lanes, 24, 2},
                {unit.counters, 28, 1},
                {unit.duplicate_lines, 29, 1}}),
          word({{unit.fragment_fifo, 0, 11}, {unit.miss_fifo, 16, 9}}),
          word({{unit.extra_sets, 0, 3},
                {unit.extra_passes, 4, 3},
                {unit.half_vector, 8, 1},
                {static_cast<int>(unit.stages), 16, 8}}),
          word({{codes_to(TextureFormat::palette_rgb), 0, 8},
                {codes_to(Mip::linear), 8, 3},
                {codes_to(Wrap::clamp), 12, 3},
                {codes_to(Combine::replace), 16, 6},
                {1, 24, 1},  // bilinear
                {kProbesLog2Max, 28, 3}}),
          word({{kLargestSide, 0, 13}, {kLevelsMax, 16, 4}, {kDraws, 24, 3}, {kLineBits, 27, 5}}),
          word({{kDraws, 0, 3}, {log2_of(kLrgbEntries), 4, 4}, {log2_of(kRgbEntries), 8, 4}}),
          word({{config.coef_bits, 0, 4},
                {config.delta_bits, 4, 4},
                {config.light_int, 8, 2},
                {config.light_frac, 12, 4},
                {config.basis_frac, 16, 5},
                {config.guard, 24, 4},
                {nearest, 28, 1}}),
          word({{config.lum_bits, 0, 4},
                {config.lum_frac, 4, 3},
                {config.shift_min, 8, 4},
                {config.shift_groups, 12, 3},
                {config.filter_frac, 16, 3}})};
}

std::uint32_t stored_bits(std::uint16_t address, const UnitConfig& unit) {
  using namespace registers;
  if (address < kDraws * kDrawStride) return stored_draw_bits(address % kDrawStride, unit);
  if (address == kMemoryLines) return (2U << kLineBits) - 1;
  if (address == kMemoryBase) return kLineAddress;
  if (address == kEnable) return events::kAll;
  if (address >= kSets && address < kSets + 32 * kDraws) {
    const unsigned set = address / 8 % 4, coefficient = address % 8;
    return static_cast<int>(set) < unit.extra_sets && coefficient < 6 ? kBiasAndShift : 0;
  }
  return 0;
}

}  // namespace ptm::reference
