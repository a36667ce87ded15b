// Register writes: docs/spec/unit.md and docs/spec/effects.md, "Registers".
#include <stdexcept>
#include <string>

#include "model/reference/unit/register_map.h"
#include "model/reference/unit/unit_memory.h"

namespace ptm::reference {
namespace {

using namespace registers;

/// A value at [low + bits - 1 : low]; two's complement if signed.
std::uint32_t field(const char* name, Value value, int low, int bits, bool is_signed = false) {
  const Value least = is_signed ? -(Value{1} << (bits - 1)) : 0;
  const Value most = least + (Value{1} << bits) - 1;
  if (value < least || value > most) {
    throw std::invalid_argument(std::string(name) + " = " + std::to_string(value) + ", expected " +
                                std::to_string(least) + " to " + std::to_string(most));
  }
  const auto code = static_cast<std::uint32_t>(value & ((Value{1} << bits) - 1));
  return code << low;
}

RegisterWrite write(unsigned address, std::uint32_t data) {
  return {static_cast<std::uint16_t>(address), data};
}

std::uint32_t control(const Draw& draw) {
  const auto code = [](auto enumerator) { return Value{static_cast<std::uint8_t>(enumerator)}; };
  return field("format", code(draw.format), 0, 3) | field("mip", code(draw.mip), 3, 2) |
         field("bilinear", draw.bilinear ? 1 : 0, 5, 1) | field("wrap_u", code(draw.wrap_u), 6, 2) |
         field("wrap_v", code(draw.wrap_v), 8, 2) | field("combine", code(draw.combine), 10, 3) |
         field("color", draw.color ? 1 : 0, 13, 1) | field("palette", draw.palette, 14, 2);
}

std::uint32_t sides(const TextureLevels& texture) {
  return field("width", texture.width, 0, 13) | field("height", texture.height, 16, 13);
}

void write_bases(const TextureLevels& texture, unsigned first, std::vector<RegisterWrite>& out) {
  for (unsigned l = 0; l < kLevelsMax; ++l) {
    out.push_back(write(first + l, field("base", texture.base[l], 0, kLineBits)));
  }
}

void write_palettes(const Palettes& palettes, std::vector<RegisterWrite>& out) {
  if (palettes.lrgb.size() > kDraws * kLrgbEntries || palettes.rgb.size() > kRgbEntries) {
    throw std::invalid_argument("a palette of more entries than the unit has");
  }
  const auto table = [&out](const auto& entries, unsigned first, unsigned stride) {
    for (unsigned e = 0; e < entries.size(); ++e) {
      for (unsigned w = 0; w < entries[e].size(); ++w) {
        out.push_back(write(first + stride * e + w, entries[e][w]));
      }
    }
  };
  table(palettes.lrgb, kLrgbPalettes, 2);
  table(palettes.rgb, kRgbPalette, 8);
}

std::uint32_t bias_and_shift(Value bias, Value shift) {
  return field("bias", bias, 0, 12) | field("shift", shift, 16, 5, true);
}

std::uint32_t passes_of(const DrawEffects& effects) {
  std::uint32_t out = field("passes", effects.passes, 0, 3);
  for (std::size_t k = 0; k < effects.pass.size(); ++k) {
    const int low = 4 * static_cast<int>(k) + 4;
    out |= field("set of a pass", effects.pass[k].set, low, 3) |
           field("half of a pass", effects.pass[k].half ? 1 : 0, low + 3, 1);
  }
  return out;
}

/// docs/spec/effects.md, "Registers".
void write_effects(const DrawEffects& effects, unsigned number, const EffectTable& table,
                   std::vector<RegisterWrite>& out) {
  const auto add = [&out](bool always, unsigned address, std::uint32_t data) {
    if (always || data != 0) out.push_back(write(address, data));
  };
  const unsigned d = number * kDrawStride;
  add(false, d + 12, passes_of(effects));
  add(false, d + 13, field("sets", effects.sets, 0, 3) | field("stages", effects.stages, 8, 8));
  add(false, d + 14, effects.argument);
  for (unsigned s = 0; s < kExtraSets; ++s) {
    for (unsigned i = 0; i < 6; ++i) {
      add(static_cast<int>(s) < effects.sets, kSets + 32 * number + 8 * s + i,
          bias_and_shift(effects.bias[s][i], effects.shift[s][i]));
    }
  }
  for (unsigned i = 0; i < table.size(); ++i) {
    add(effects.stages != 0, kTables + 256 * number + i,
        field("an entry of the table", table[i], 0, 12));
  }
}

}  // namespace

std::vector<RegisterWrite> register_writes(const Draw& draw, int number, const EffectTable& table) {
  if (number < 0 || number >= kDraws) {
    throw std::invalid_argument("draw = " + std::to_string(number) + ", expected 0 to 3");
  }
  const unsigned d = static_cast<unsigned>(number) * kDrawStride;
  std::vector<RegisterWrite> out;
  out.push_back(write(d + 1, sides(draw.map)));
  out.push_back(write(d + 2, sides(draw.color_texture)));
  out.push_back(write(d + 3, field("levels", draw.map.levels, 0, 4) |
                                 field("levels", draw.color_texture.levels, 8, 4) |
                                 field("color_lod", draw.color_lod, 16, 13, true)));
  for (unsigned i = 0; i < 6; ++i) {
    out.push_back(write(d + 4 + i, bias_and_shift(draw.bias[i], draw.shift[i])));
  }
  out.push_back(write(d + 10, field("ka", draw.ka, 0, 9) | field("kd", draw.kd, 9, 9) |
                                  field("ks", draw.ks, 18, 9)));
  write_bases(draw.map, d + kMapBase, out);
  write_bases(draw.color_texture, d + kColorBase, out);
  write_effects(draw.effects, static_cast<unsigned>(number), table, out);
  out.push_back(write(d, control(draw)));
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
