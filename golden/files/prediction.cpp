#include "golden/files/prediction.h"

#include "golden/files/input_error.h"

namespace ptm::golden {

void add_prediction(std::span<std::uint8_t> plane, std::span<const std::uint8_t> reference,
                    bool inverted) {
  for (std::size_t i = 0; i < plane.size(); ++i) {
    const int value = plane[i] + predictor(reference[i], inverted) - 128;
    plane[i] = static_cast<std::uint8_t>(value & 255);
  }
}

void apply_side_information(std::span<std::uint8_t> plane, std::span<const std::uint8_t> records,
                            const std::string& file, std::uint64_t first_byte) {
  constexpr std::size_t record_bytes = 5;
  for (std::size_t at = 0; at + record_bytes <= records.size(); at += record_bytes) {
    std::size_t texel = 0;
    for (std::size_t i = 0; i < 4; ++i) texel = texel << 8 | records[at + i];
    if (texel >= plane.size()) {
      throw InputError(file, "byte " + std::to_string(first_byte + at) + " (side information)",
                       "texel " + std::to_string(texel),
                       "a number below " + std::to_string(plane.size()));
    }
    plane[texel] = records[at + 4];
  }
}

void append_side_record(std::vector<std::uint8_t>& records, std::size_t texel, std::uint8_t value) {
  for (const int shift : {24, 16, 8, 0}) {
    records.push_back(static_cast<std::uint8_t>(texel >> shift & 255));
  }
  records.push_back(value);
}

}  // namespace ptm::golden
