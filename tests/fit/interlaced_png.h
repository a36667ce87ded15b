#pragma once
#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include "golden/files/image.h"

/// PNGs that no decoder reads row by row: Adam7, made byte by byte since OpenImageIO writes none.
namespace ptm::tests {

using PngBytes = std::vector<std::uint8_t>;

inline void append_number(PngBytes& out, std::uint32_t number) {
  for (int shift = 24; shift >= 0; shift -= 8) {
    out.push_back(static_cast<std::uint8_t>(number >> shift));
  }
}

/// A chunk with its length and CRC-32 (PNG specification, 5.3 and annex D).
inline void append_chunk(PngBytes& out, std::string_view name, const PngBytes& data) {
  append_number(out, static_cast<std::uint32_t>(data.size()));
  const std::size_t first = out.size();
  out.insert(out.end(), name.begin(), name.end());
  out.insert(out.end(), data.begin(), data.end());
  std::uint32_t crc = 0xFFFFFFFF;
  for (std::size_t k = first; k < out.size(); ++k) {
    crc ^= out[k];
    for (int bit = 0; bit < 8; ++bit) crc = (crc & 1U) != 0 ? crc >> 1 ^ 0xEDB88320U : crc >> 1;
  }
  append_number(out, ~crc);
}

/// A zlib stream of blocks that are not compressed (RFC 1950, RFC 1951).
inline PngBytes stored_zlib(const PngBytes& data) {
  PngBytes out{0x78, 0x01};
  std::uint32_t low = 1, high = 0;
  for (const std::uint8_t byte : data) {
    low = (low + byte) % 65521;
    high = (high + low) % 65521;
  }
  for (std::size_t first = 0; first < data.size(); first += 65535) {
    const std::size_t size = std::min<std::size_t>(65535, data.size() - first);
    out.push_back(first + size == data.size() ? 1 : 0);
    for (const std::size_t word : {size, ~size}) {
      out.push_back(static_cast<std::uint8_t>(word));
      out.push_back(static_cast<std::uint8_t>(word >> 8));
    }
    const auto at = data.begin() + static_cast<std::ptrdiff_t>(first);
    out.insert(out.end(), at, at + static_cast<std::ptrdiff_t>(size));
  }
  append_number(out, high << 16 | low);
  return out;
}

/// An RGB picture in the seven passes of the PNG specification, 8.2.
inline void write_interlaced_png(const std::filesystem::path& path, const golden::Image8& image) {
  struct Pass {
    int x, y, step_x, step_y;
  };
  constexpr std::array<Pass, 7> kPasses{{{0, 0, 8, 8},
                                         {4, 0, 8, 8},
                                         {0, 4, 4, 8},
                                         {2, 0, 4, 4},
                                         {0, 2, 2, 4},
                                         {1, 0, 2, 2},
                                         {0, 1, 1, 2}}};
  PngBytes rows;
  for (const Pass& pass : kPasses) {
    for (int y = pass.y; y < image.height && pass.x < image.width; y += pass.step_y) {
      rows.push_back(0);  // no filter
      for (int x = pass.x; x < image.width; x += pass.step_x) {
        for (int c = 0; c < 3; ++c) rows.push_back(image.at(x, y, c));
      }
    }
  }
  PngBytes header;
  append_number(header, static_cast<std::uint32_t>(image.width));
  append_number(header, static_cast<std::uint32_t>(image.height));
  for (const int field : {8, 2, 0, 0, 1}) header.push_back(static_cast<std::uint8_t>(field));
  PngBytes file{0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
  append_chunk(file, "IHDR", header);
  append_chunk(file, "IDAT", stored_zlib(rows));
  append_chunk(file, "IEND", {});
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(file.data()), static_cast<std::streamsize>(file.size()));
}

}  // namespace ptm::tests
