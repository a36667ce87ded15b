#include "tests/fuzz/ptm_target.h"

// Uncompressed .ptm files: LRGB, RGB and LUM.
namespace ptm::tests {

bool fuzz_reads(const std::uint8_t* data, std::size_t size) {
  return read_map_of_coding(golden::Coding::raw, data, size);
}

std::vector<FuzzSeed> fuzz_seeds() {
  std::vector<FuzzSeed> seeds;
  add_maps(seeds, golden::MapKind::lrgb, "lrgb", {});
  add_maps(seeds, golden::MapKind::lrgb, "lrgb_1.1", {.version_1_1 = true});
  add_maps(seeds, golden::MapKind::rgb, "rgb", {});
  add_maps(seeds, golden::MapKind::lum, "lum", {});
  seeds.push_back(seed_of("lum_without_matrix", to_bytes(header_of("LUM", 2, 1)) + counting(16)));
  seeds.push_back(
      {"shared_lines",
       "PTM_1.2\r\nPTM_FORMAT_LRGB\r\n1 1\r\n1 -2 .5 1e3 1 1 0 0 0 0 0 0\r\n123456789"});
  return seeds;
}

}  // namespace ptm::tests

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  (void)ptm::tests::fuzz_reads(data, size);
  return 0;
}
