#pragma once
#include <cstdint>
#include <cstdlib>
#include <span>
#include <string>
#include <vector>

#include "golden/files/ptm_header.h"
#include "tests/files/crafted_ptm.h"
#include "tests/fuzz/fuzz_target.h"

namespace ptm::tests {

/// The target of one coding: files of another coding are passed over, so that each target's inputs
/// stay of its kind. What was read is written and read again.
inline bool read_map_of_coding(golden::Coding coding, const std::uint8_t* data, std::size_t size) {
  constexpr std::size_t most_texels = 4096;  // writing takes time
  try {
    const std::span bytes(data, size);
    if (golden::parse_ptm_header(bytes, "fuzz").info.coding != coding) return false;
    const golden::PtmMap map = golden::parse_ptm(bytes, "fuzz").map;
    if (map.coef.size() != map.texels() * 6 * map.polynomials() ||
        map.color.size() != map.texels() * map.color_bytes()) {
      std::abort();
    }
    if (map.texels() > most_texels) return true;
    const auto written = golden::format_ptm(map, {.coding = coding});
    if (golden::parse_ptm(written, "written").map != map) std::abort();
    return true;
  } catch (const golden::InputError&) {
    return false;
  }
}

inline FuzzSeed seed_of(const std::string& name, const Bytes& bytes) {
  return {name, {bytes.begin(), bytes.end()}};
}

/// A smooth map and noise; exact JPEG of noise has side information.
inline void add_maps(std::vector<FuzzSeed>& seeds, golden::MapKind kind, const std::string& name,
                     const golden::PtmWriteOptions& options) {
  seeds.push_back(
      seed_of(name + "_smooth", golden::format_ptm(made_map(kind, 8, 8, 1, true), options)));
  seeds.push_back(seed_of(name + "_noise", golden::format_ptm(made_map(kind, 5, 3, 2), options)));
}

}  // namespace ptm::tests
