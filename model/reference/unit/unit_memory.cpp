#include "model/reference/unit/unit_memory.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "model/reference/fragment.h"

namespace ptm::reference {
namespace {

constexpr std::size_t kMemoryLines = std::size_t{1} << kLineBits;

[[noreturn]] void refuse(const std::string& what, std::size_t found, const std::string& expected) {
  throw std::invalid_argument(what + " = " + std::to_string(found) + ", expected " + expected);
}

void require_equal(const char* what, std::size_t found, std::size_t expected) {
  if (found != expected) refuse(what, found, std::to_string(expected));
}

void require_at_most(const char* what, std::size_t found, std::size_t most) {
  if (found > most) refuse(what, found, "at most " + std::to_string(most));
}

void require_fields(const EvalConfig& config, std::span<const std::uint16_t> coef) {
  const std::size_t most = (std::size_t{1} << config.coef_bits) - 1;
  for (const std::uint16_t c : coef) require_at_most("a coefficient", c, most);
}

/// Of a texel.
std::size_t coefficients(TextureFormat format) {
  return 6 * static_cast<std::size_t>(format_row(format).polynomials);
}

/// Texels of a level, and how many lines they take. Base is filled in.
template <class Level>
TextureLevels level_sizes(std::span<const Level> levels, int planes, std::size_t memory_lines) {
  if (levels.empty()) refuse("levels", 0, "1 to 13");
  TextureLevels out{levels[0].width, levels[0].height, static_cast<int>(levels.size()), {}};
  const auto longer = static_cast<unsigned>(std::max({out.width, out.height, 0}));
  if (std::min(out.width, out.height) < 1 || longer > kLargestSide) {
    throw std::invalid_argument("a texture of " + std::to_string(out.width) + " x " +
                                std::to_string(out.height) + " texels, expected 1 to " +
                                std::to_string(kLargestSide) + " a side");
  }
  std::size_t most = 1;
  while (longer >> most != 0) ++most;
  require_at_most("levels", levels.size(), most);
  std::size_t next = memory_lines;
  for (std::size_t l = 0; l < levels.size(); ++l) {
    const int level = static_cast<int>(l);
    if (levels[l].width != out.level_width(level) || levels[l].height != out.level_height(level)) {
      throw std::invalid_argument(
          "level " + std::to_string(l) + " of " + std::to_string(levels[l].width) + " x " +
          std::to_string(levels[l].height) + " texels, expected " +
          std::to_string(out.level_width(level)) + " x " + std::to_string(out.level_height(level)));
    }
    out.base[l] = static_cast<std::uint32_t>(next);
    next += level_lines(out, planes, level);
  }
  require_at_most("lines of memory", next, kMemoryLines);
  return out;
}

template <class Level>
std::size_t texels(const Level& level) {
  return static_cast<std::size_t>(level.width) * static_cast<std::size_t>(level.height);
}

/// Writes word_of(level's index, texel, plane) everywhere. The address is the contract's line
/// formula, not U6's function, which reads.
template <class WordOf>
void write_levels(const TextureLevels& at, int planes, std::vector<Line>& memory, WordOf word_of) {
  const std::size_t last = static_cast<std::size_t>(at.levels) - 1;
  memory.resize(at.base[last] + level_lines(at, planes, at.levels - 1));
  const auto plane_count = static_cast<std::size_t>(planes);
  for (std::size_t l = 0; l <= last; ++l) {
    const auto width = static_cast<std::size_t>(at.level_width(static_cast<int>(l)));
    const auto height = static_cast<std::size_t>(at.level_height(static_cast<int>(l)));
    const std::size_t across = (width + 3) / 4;
    for (std::size_t y = 0; y < height; ++y) {
      for (std::size_t x = 0; x < width; ++x) {
        const std::size_t tile = (y / 4) * across + x / 4;
        Line* lines = &memory[at.base[l] + tile * plane_count];
        for (std::size_t p = 0; p < plane_count; ++p) {
          lines[p][(y % 4) * 4 + x % 4] = word_of(l, y * width + x, p);
        }
      }
    }
  }
}

/// The first in the low bits.
template <class Word, class Count>
Word packed_fields(const std::uint16_t* fields, Count count, int bits) {
  Word word = 0;
  for (Count k = 0; k < count; ++k) word |= Word{fields[k]} << (static_cast<int>(k) * bits);
  return word;
}

std::uint32_t four_bytes(unsigned a, unsigned b, unsigned c, unsigned d) {
  return a | b << 8 | c << 16 | d << 24;
}

/// Entries of `words` words of three coefficients each.
template <std::size_t kWords>
void pack_entries(const EvalConfig& config, std::span<const std::uint16_t> coef,
                  std::array<std::uint64_t, kWords>* entries, std::size_t most) {
  require_fields(config, coef);
  if (coef.size() % (3 * kWords) != 0) {
    refuse("coefficients of a palette", coef.size(), "a multiple of " + std::to_string(3 * kWords));
  }
  require_at_most("entries of a palette", coef.size() / (3 * kWords), most);
  std::fill_n(entries, most, std::array<std::uint64_t, kWords>{});
  for (std::size_t word = 0; word < coef.size() / 3; ++word) {
    entries[word / kWords][word % kWords] =
        packed_fields<std::uint64_t>(&coef[word * 3], 3, field_bits(config));
  }
}

void require_map(const EvalConfig& config, std::span<const StoredTexture> levels) {
  const bool rgb = levels[0].rgb;
  for (const StoredTexture& level : levels) {
    require_equal("rgb of a level", level.rgb ? 1 : 0, rgb ? 1 : 0);
    require_equal("coefficients of a level", level.coef.size(),
                  texels(level) * coefficients(map_format(rgb)));
    if (!rgb) require_equal("colours of a level", level.color.size(), texels(level) * 3);
    require_fields(config, level.coef);
  }
}

void require_palette_map(std::span<const StoredPaletteMap> levels) {
  const bool rgb = levels[0].rgb;
  for (const StoredPaletteMap& level : levels) {
    require_equal("rgb of a level", level.rgb ? 1 : 0, rgb ? 1 : 0);
    require_equal("indices of a level", level.index.size(), texels(level));
    if (!rgb) require_equal("colours of a level", level.color.size(), texels(level) * 3);
    for (const std::uint16_t i : level.index)
      require_at_most("an index", i, (rgb ? kRgbEntries : kLrgbEntries) - 1);
  }
}

/// That the sets have the levels of a map that lies there.
void require_sets(const EvalConfig& config, const TextureLevels& at,
                  std::span<const StoredSet> sets) {
  for (const StoredSet& set : sets) {
    require_equal("levels of a set", set.size(), static_cast<std::size_t>(at.levels));
    for (std::size_t l = 0; l < set.size(); ++l) {
      const int level = static_cast<int>(l);
      require_equal("width of a set's level", static_cast<std::size_t>(set[l].width),
                    static_cast<std::size_t>(at.level_width(level)));
      require_equal("height of a set's level", static_cast<std::size_t>(set[l].height),
                    static_cast<std::size_t>(at.level_height(level)));
      require_equal("coefficients of a set's level", set[l].coef.size(), texels(set[l]) * 6);
      require_fields(config, set[l].coef);
    }
  }
}

std::size_t planes_with(const EvalConfig& config, std::size_t own,
                        std::span<const StoredSet> sets) {
  require_at_most("sets", sets.size(), kExtraSets);
  return own + static_cast<std::size_t>(polynomial_words(config)) * sets.size();
}

std::uint32_t set_word(const EvalConfig& config, std::span<const StoredSet> sets, std::size_t level,
                       std::size_t texel, std::size_t plane) {
  const auto planes = static_cast<std::size_t>(polynomial_words(config));
  const auto fields = static_cast<std::size_t>(coefficients_a_word(config));
  const std::uint16_t* coef = &sets[plane / planes][level].coef[texel * 6];
  return packed_fields<std::uint32_t>(coef + plane % planes * fields, fields, field_bits(config));
}

}  // namespace

TextureLevels append_map(const EvalConfig& config, std::span<const StoredTexture> levels,
                         std::vector<Line>& memory) {
  return append_map(config, levels, {}, memory);
}

TextureLevels append_map(const EvalConfig& config, std::span<const StoredTexture> levels,
                         std::span<const StoredSet> sets, std::vector<Line>& memory) {
  const bool rgb = !levels.empty() && levels[0].rgb;
  const contract::FormatWords& format = format_words(map_format(rgb), config);
  const auto own = static_cast<std::size_t>(format.planes);
  const int planes = static_cast<int>(planes_with(config, own, sets));
  const TextureLevels at = level_sizes(levels, planes, memory.size());
  require_map(config, levels);
  require_sets(config, at, sets);
  const int bits = field_bits(config);
  write_levels(at, planes, memory, [&](std::size_t l, std::size_t texel, std::size_t plane) {
    if (plane >= own) return set_word(config, sets, l, texel, plane - own);
    const contract::FormatWord& word = format.word[plane];
    if (word.kind == contract::WordKind::coefficients) {
      const std::size_t first = texel * coefficients(map_format(rgb)) + word.field;
      return packed_fields<std::uint32_t>(&levels[l].coef[first], word.fields, bits);
    }
    const std::uint8_t* color = &levels[l].color[texel * 3];
    return four_bytes(color[0], color[1], color[2], 255);
  });
  return at;
}

TextureLevels append_palette_map(std::span<const StoredPaletteMap> levels,
                                 std::vector<Line>& memory) {
  return append_palette_map({}, levels, {}, memory);
}

TextureLevels append_palette_map(const EvalConfig& config, std::span<const StoredPaletteMap> levels,
                                 std::span<const StoredSet> sets, std::vector<Line>& memory) {
  const bool rgb = !levels.empty() && levels[0].rgb;
  const auto own = static_cast<std::size_t>(map_planes(map_format(rgb, true), config));
  const int planes = static_cast<int>(planes_with(config, own, sets));
  const TextureLevels at = level_sizes(levels, planes, memory.size());
  require_palette_map(levels);
  require_sets(config, at, sets);
  write_levels(at, planes, memory, [&](std::size_t l, std::size_t texel, std::size_t plane) {
    if (plane >= own) return set_word(config, sets, l, texel, plane - own);
    const unsigned index = levels[l].index[texel];
    if (levels[l].rgb) return index;
    const std::uint8_t* color = &levels[l].color[texel * 3];
    return four_bytes(index, color[0], color[1], color[2]);
  });
  return at;
}

TextureLevels append_picture(std::span<const StoredPicture> levels, std::vector<Line>& memory) {
  const TextureLevels at = level_sizes(levels, 1, memory.size());
  for (const StoredPicture& level : levels) {
    require_equal("bytes of a level", level.rgba.size(), texels(level) * 4);
  }
  write_levels(at, 1, memory, [&](std::size_t l, std::size_t texel, std::size_t) {
    const std::uint8_t* rgba = &levels[l].rgba[texel * 4];
    return four_bytes(rgba[0], rgba[1], rgba[2], rgba[3]);
  });
  return at;
}

void append_lrgb_palette(const EvalConfig& config, std::span<const std::uint16_t> coef, int palette,
                         Palettes& palettes) {
  require_at_most("palette", static_cast<std::size_t>(palette), 3);
  std::vector<std::array<std::uint64_t, 2>> entries(kLrgbEntries);
  pack_entries(config, coef, entries.data(), kLrgbEntries);
  const std::size_t first = static_cast<std::size_t>(palette) * kLrgbEntries;
  palettes.lrgb.resize(std::max(palettes.lrgb.size(), first + kLrgbEntries));
  std::copy(entries.begin(), entries.end(),
            palettes.lrgb.begin() + static_cast<std::ptrdiff_t>(first));
}

void set_rgb_palette(const EvalConfig& config, std::span<const std::uint16_t> coef,
                     Palettes& palettes) {
  std::vector<std::array<std::uint64_t, 6>> entries(kRgbEntries);
  pack_entries(config, coef, entries.data(), kRgbEntries);
  palettes.rgb = std::move(entries);
}

}  // namespace ptm::reference
