#pragma once
#include "contract/formats.h"
#include "contract/registers.h"

/// Texel formats of a map: contract/formats.toml, docs/spec/unit.md, "Draw descriptor".
namespace ptm::reference {

using contract::TextureFormat;

/// What the table says of a format: any code of the register's three bits.
[[nodiscard]] constexpr const contract::FormatRow& format_row(TextureFormat format) {
  return contract::kFormats[static_cast<std::size_t>(format)];
}

/// The format of a map with three polynomials a texel, or one and a colour.
[[nodiscard]] constexpr TextureFormat map_format(bool rgb, bool palettised = false) {
  if (palettised) return rgb ? TextureFormat::palette_rgb : TextureFormat::palette_lrgb;
  return rgb ? TextureFormat::rgb : TextureFormat::lrgb;
}

/// Planes of 32-bit words of the map's own polynomials and colour, 0 for none.
[[nodiscard]] constexpr int map_planes(TextureFormat format) { return format_row(format).planes; }

}  // namespace ptm::reference
