#include "tests/fuzz/ptm_target.h"

// .ptm files whose planes are coded by JPEG-LS.
namespace ptm::tests {

bool fuzz_reads(const std::uint8_t* data, std::size_t size) {
  return read_map_of_coding(golden::Coding::jpegls, data, size);
}

std::vector<FuzzSeed> fuzz_seeds() {
  std::vector<FuzzSeed> seeds;
  add_maps(seeds, golden::MapKind::lrgb, "lrgb", {.coding = golden::Coding::jpegls});
  add_maps(seeds, golden::MapKind::rgb, "rgb", {.coding = golden::Coding::jpegls});
  add_maps(seeds, golden::MapKind::lrgb, "near", {.coding = golden::Coding::jpegls, .near = 3});
  // Planes that build on others, one on an inverse, and a record of side information.
  CraftedPlanes file(golden::Coding::jpegls, "JPEGLS_LRGB", 3, 2);
  file.references[1] = 0;
  file.references[2] = 1;
  file.transforms[2] = 1;
  file.side[2] = {0, 0, 0, 5, 77};
  seeds.push_back(seed_of("built_on_others", file.bytes()));
  return seeds;
}

}  // namespace ptm::tests

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  (void)ptm::tests::fuzz_reads(data, size);
  return 0;
}
