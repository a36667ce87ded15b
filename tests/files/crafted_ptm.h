#pragma once
#include <gtest/gtest.h>

#include <cstdint>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include "golden/files/lum_matrix.h"
#include "golden/files/plane_codec.h"
#include "golden/files/ptm_file.h"

/// Files made byte by byte, without the writer under test.
namespace ptm::tests {

using Bytes = std::vector<std::uint8_t>;

inline Bytes to_bytes(const std::string& text) { return {text.begin(), text.end()}; }

inline Bytes operator+(Bytes left, const Bytes& right) {
  left.insert(left.end(), right.begin(), right.end());
  return left;
}

/// The name of a test that runs for both codecs.
inline std::string coding_name(const testing::TestParamInfo<golden::Coding>& row) {
  return row.param == golden::Coding::jpeg ? "Jpeg" : "JpegLs";
}

/// 0, 1, 2, ...: every byte of a small payload tells its place.
inline Bytes counting(std::size_t count) {
  Bytes bytes(count);
  std::iota(bytes.begin(), bytes.end(), std::uint8_t{0});
  return bytes;
}

constexpr const char* scales_and_biases = "1 2 3 4 5 6\n0 10 20 30 40 50\n";

inline std::string header_of(const std::string& format, int width, int height,
                             const std::string& version = "PTM_1.2") {
  return version + "\nPTM_FORMAT_" + format + "\n" + std::to_string(width) + "\n" +
         std::to_string(height) + "\n" + scales_and_biases;
}

/// Expects an InputError and hands it back.
inline golden::InputError refusal_of(const Bytes& bytes) {
  try {
    (void)golden::parse_ptm(bytes, "crafted.ptm");
  } catch (const golden::InputError& error) {
    return error;
  }
  ADD_FAILURE() << "the file was accepted";
  return {"", "", "", ""};
}

/// A coded file; the planes are the bytes as coded, before prediction, bottom row first.
struct CraftedPlanes {
  golden::Coding coding = golden::Coding::jpegls;
  std::string format = "JPEGLS_LRGB";
  int width = 1, height = 1;
  std::vector<Bytes> planes;
  std::vector<int> transforms, motion_x, motion_y, order, references;
  std::vector<Bytes> side;
  std::vector<Bytes> streams;  ///< made from the planes where empty

  CraftedPlanes(golden::Coding c, std::string f, int w, int h, std::size_t count = 9)
      : coding(c),
        format(std::move(f)),
        width(w),
        height(h),
        planes(count, Bytes(static_cast<std::size_t>(w * h), 128)),
        transforms(count, 0),
        motion_x(count, 0),
        motion_y(count, 0),
        order(count),
        references(count, -1),
        side(count),
        streams(count) {
    std::iota(order.begin(), order.end(), 0);
  }

  void fill(std::size_t plane, std::uint8_t value) {
    planes[plane].assign(planes[plane].size(), value);
  }

  template <class Values>
  static std::string line(const Values& values) {
    std::string out;
    for (const auto& value : values) {
      if (!out.empty()) out += ' ';
      out += std::to_string(value);
    }
    return out + '\n';
  }

  [[nodiscard]] Bytes stream(std::size_t p) const {
    if (!streams[p].empty()) return streams[p];
    return coding == golden::Coding::jpeg ? golden::encode_jpeg_plane(planes[p], width, height, 100)
                                          : golden::encode_jpegls_plane(planes[p], width, height);
  }

  [[nodiscard]] Bytes bytes() const {
    std::vector<std::size_t> sizes, side_sizes;
    Bytes payload;
    for (std::size_t p = 0; p < planes.size(); ++p) {
      const Bytes coded = stream(p);
      sizes.push_back(coded.size());
      side_sizes.push_back(side[p].size());
      payload = payload + coded + side[p];
    }
    return to_bytes(header_of(format, width, height) + "95\n" + line(transforms) + line(motion_x) +
                    line(motion_y) + line(order) + line(references) + line(sizes) +
                    line(side_sizes)) +
           payload;
  }

  [[nodiscard]] golden::PtmFile parse() const { return golden::parse_ptm(bytes(), "crafted.ptm"); }
};

/// Noise, or waves that a codec likes; scales and biases as real files have them, and worse.
inline golden::PtmMap made_map(golden::MapKind kind, int width, int height, unsigned seed,
                               bool smooth = false) {
  std::mt19937 random(seed);
  golden::PtmMap map;
  map.kind = kind;
  map.width = width;
  map.height = height;
  map.scale = {2, 0.5, -0.1, 1e-30, 1.0 / 3, 12345678901.5};
  map.bias = {527, -715, 0, 255, INT32_MIN, INT32_MAX};
  if (kind == golden::MapKind::lum) map.lum_matrix = golden::jfif_lum_matrix();
  const auto fill = [&](std::vector<std::uint8_t>& bytes, std::size_t per_texel) {
    bytes.resize(map.texels() * per_texel);
    for (std::size_t i = 0; i < bytes.size(); ++i) {
      const std::size_t texel = i / per_texel;
      const std::size_t x = texel % static_cast<std::size_t>(width);
      const std::size_t y = texel / static_cast<std::size_t>(width);
      bytes[i] =
          static_cast<std::uint8_t>(smooth ? 100 + x + y + 7 * (i % per_texel) : random() & 255U);
    }
  };
  fill(map.coef, 6 * map.polynomials());
  fill(map.color, map.color_bytes());
  return map;
}

}  // namespace ptm::tests
