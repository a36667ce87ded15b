// Register writes: docs/spec/unit.md and docs/spec/effects.md, "Registers".
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>

#include "model/reference/unit/register_map.h"
#include "model/reference/unit/unit_memory.h"

namespace ptm::reference {
namespace {

using contract::RegisterField;
using namespace registers;

/// A value in its field of a register, refused by what it is (by the field's name, if nothing is
/// said) if the field does not hold it.
std::uint32_t packed(const RegisterField& field, Value value, std::string_view what = {}) {
  if (value < field.least() || value > field.most()) {
    throw std::invalid_argument(
        std::string(what.empty() ? field.name : what) + " = " + std::to_string(value) +
        ", expected " + std::to_string(field.least()) + " to " + std::to_string(field.most()));
  }
  return field.pack(value);
}
template <class Enumerator>
requires std::is_enum_v<Enumerator> std::uint32_t packed(const RegisterField& field,
                                                         Enumerator code) {
  return packed(field, Value{static_cast<std::uint8_t>(code)});
}

RegisterWrite write(unsigned address, std::uint32_t data) {
  return {static_cast<std::uint16_t>(address), data};
}

std::uint32_t control(const Draw& draw) {
  namespace f = fields::draw_control;
  return packed(f::kFormat, draw.format) | packed(f::kMip, draw.mip) |
         packed(f::kBilinear, draw.bilinear ? 1 : 0) | packed(f::kWrapU, draw.wrap_u) |
         packed(f::kWrapV, draw.wrap_v) | packed(f::kCombine, draw.combine) |
         packed(f::kColor, draw.color ? 1 : 0) | packed(f::kPalette, draw.palette);
}

std::uint32_t map_size(const TextureLevels& map) {
  namespace f = fields::draw_map_size;
  return packed(f::kWidth, map.width) | packed(f::kHeight, map.height);
}
std::uint32_t color_size(const TextureLevels& color) {
  namespace f = fields::draw_color_size;
  return packed(f::kWidth, color.width) | packed(f::kHeight, color.height);
}
std::uint32_t levels(const Draw& draw) {
  namespace f = fields::draw_levels;
  return packed(f::kMap, draw.map.levels, "levels") |
         packed(f::kColor, draw.color_texture.levels, "levels") |
         packed(f::kColorLod, draw.color_lod);
}
std::uint32_t weights(const Draw& draw) {
  namespace f = fields::draw_weights;
  return packed(f::kKa, draw.ka) | packed(f::kKd, draw.kd) | packed(f::kKs, draw.ks);
}

void write_palettes(const Palettes& palettes, std::vector<RegisterWrite>& out) {
  if (palettes.lrgb.size() > kDraws * kLrgbEntries || palettes.rgb.size() > kRgbEntries) {
    throw std::invalid_argument("a palette of more entries than the unit has");
  }
  std::uint32_t upper = 0;  // of the register, which stays
  const auto table = [&](const auto& entries, unsigned first, unsigned stride) {
    for (unsigned e = 0; e < entries.size(); ++e) {
      for (unsigned w = 0; w < entries[e].size(); ++w) {
        const std::uint64_t word = entries[e][w];
        const std::uint32_t bits =
            packed(fields::palette_upper::kBits, static_cast<Value>(word >> 32),
                   "bits of a palette's word above 31");
        if (bits != upper) out.push_back(write(kPaletteUpper, upper = bits));
        out.push_back(write(first + stride * e + w, static_cast<std::uint32_t>(word)));
      }
    }
  };
  table(palettes.lrgb, kLrgbPaletteBlock, kLrgbPaletteStride);
  table(palettes.rgb, kRgbPaletteBlock, kRgbPaletteStride);
  if (upper != 0) out.push_back(write(kPaletteUpper, 0));
}

std::uint32_t coefficient(Value bias, Value shift) {
  namespace f = fields::draw_coefficient;
  return packed(f::kBias, bias) | packed(f::kShift, shift);
}
std::uint32_t set_coefficient(Value bias, Value shift) {
  namespace f = fields::set_coefficient;
  return packed(f::kBias, bias) | packed(f::kShift, shift);
}

std::uint32_t passes_of(const DrawEffects& effects) {
  namespace f = fields::draw_passes;
  static_assert(f::kSetCount == kExtraPasses && f::kHalfCount == kExtraPasses);
  std::uint32_t out = packed(f::kPasses, effects.passes);
  for (unsigned k = 0; k < effects.pass.size(); ++k) {
    out |= packed(f::kSet.higher(f::kSetStride * k), effects.pass[k].set, "set of a pass") |
           packed(f::kHalf.higher(f::kHalfStride * k), effects.pass[k].half ? 1 : 0);
  }
  return out;
}

/// docs/spec/effects.md, "Registers".
void write_effects(const DrawEffects& effects, unsigned d, const EffectTable& table,
                   std::vector<RegisterWrite>& out) {
  const auto add = [&out](bool always, unsigned address, std::uint32_t data) {
    if (always || data != 0) out.push_back(write(address, data));
  };
  namespace f = fields::draw_effects;
  add(false, draw_passes_address(d), passes_of(effects));
  add(false, draw_effects_address(d),
      packed(f::kSets, effects.sets) | packed(f::kStages, effects.stages));
  add(false, draw_argument_address(d), effects.argument);
  for (unsigned s = 0; s < kExtraSets; ++s) {
    for (unsigned i = 0; i < 6; ++i) {
      add(static_cast<int>(s) < effects.sets, set_coefficient_address(d, s, i),
          set_coefficient(effects.bias[s][i], effects.shift[s][i]));
    }
  }
  for (unsigned i = 0; i < table.size(); ++i) {
    add(effects.stages != 0, table_entry_address(d, i),
        packed(fields::table_entry::kEntry, table[i], "an entry of the table"));
  }
}

}  // namespace

std::vector<RegisterWrite> register_writes(const Draw& draw, int number, const EffectTable& table) {
  if (number < 0 || number >= kDraws) {
    throw std::invalid_argument("draw = " + std::to_string(number) + ", expected 0 to 3");
  }
  const auto d = static_cast<unsigned>(number);
  std::vector<RegisterWrite> out;
  out.push_back(write(draw_map_size_address(d), map_size(draw.map)));
  out.push_back(write(draw_color_size_address(d), color_size(draw.color_texture)));
  out.push_back(write(draw_levels_address(d), levels(draw)));
  for (unsigned i = 0; i < 6; ++i) {
    out.push_back(write(draw_coefficient_address(d, i), coefficient(draw.bias[i], draw.shift[i])));
  }
  out.push_back(write(draw_weights_address(d), weights(draw)));
  for (unsigned l = 0; l < kLevelsMax; ++l) {
    out.push_back(
        write(draw_map_base_address(d, l), packed(fields::draw_map_base::kBase, draw.map.base[l])));
  }
  for (unsigned l = 0; l < kLevelsMax; ++l) {
    out.push_back(write(draw_color_base_address(d, l),
                        packed(fields::draw_color_base::kBase, draw.color_texture.base[l])));
  }
  write_effects(draw.effects, d, table, out);
  out.push_back(write(draw_control_address(d), control(draw)));
  return out;
}

std::vector<RegisterWrite> register_writes(const UnitState& state) {
  std::vector<RegisterWrite> out;
  const auto lines = static_cast<Value>(state.memory.size());
  if (lines > Value{1} << kLineBits) {
    throw std::invalid_argument("lines of memory = " + std::to_string(lines) +
                                ", expected at most " + std::to_string(Value{1} << kLineBits));
  }
  out.push_back(write(kMemoryLines, static_cast<std::uint32_t>(lines)));
  if (state.base != 0) out.push_back(write(kMemoryBase, state.base & kOuterMask));
  write_palettes(state.palettes, out);
  for (std::size_t d = 0; d < state.draws.size(); ++d) {
    const EffectTable table = d < state.tables.size() ? state.tables[d] : EffectTable{};
    const std::vector<RegisterWrite> draw =
        register_writes(state.draws[d], static_cast<int>(d), table);
    out.insert(out.end(), draw.begin(), draw.end());
  }
  return out;
}

}  // namespace ptm::reference
