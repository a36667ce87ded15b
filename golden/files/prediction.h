#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

/// Planes told as differences from planes decoded before them, and the bytes set right afterwards.
///
///     r     = reference, or 255 - reference where the plane inverts it
///     value = (coded + r - 128) mod 256
///
/// docs/spec/ptm-file.md, section 5.
namespace ptm::golden {

/// The reference's byte as the prediction uses it.
[[nodiscard]] constexpr int predictor(std::uint8_t reference, bool inverted) {
  return inverted ? 255 - reference : reference;
}

/// Turns a decoded plane into values, in place. Both spans are of one length.
void add_prediction(std::span<std::uint8_t> plane, std::span<const std::uint8_t> reference,
                    bool inverted);

/// The coded byte for a value, modulo 256; add_prediction() undoes it exactly.
[[nodiscard]] constexpr std::uint8_t wrapped_difference(std::uint8_t value, int predicted) {
  return static_cast<std::uint8_t>((value - predicted + 128) & 255);
}

/// The coded byte for a value, held within 0..255 instead of wrapped: a wrap is an edge of 255
/// levels, which a lossy codec would smear over its neighbours.
[[nodiscard]] constexpr std::uint8_t clamped_difference(std::uint8_t value, int predicted) {
  const int difference = value - predicted + 128;
  return static_cast<std::uint8_t>(difference < 0 ? 0 : difference > 255 ? 255 : difference);
}

/// Side information: records of a big-endian 32-bit texel index, bottom row first, and the byte
/// that the texel takes. Throws InputError for an index outside the plane.
void apply_side_information(std::span<std::uint8_t> plane, std::span<const std::uint8_t> records,
                            const std::string& file, std::uint64_t first_byte);

/// Appends one record.
void append_side_record(std::vector<std::uint8_t>& records, std::size_t texel, std::uint8_t value);

}  // namespace ptm::golden
