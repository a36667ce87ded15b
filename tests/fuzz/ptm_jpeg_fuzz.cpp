#include "tests/fuzz/ptm_target.h"

// .ptm files whose planes are coded by JPEG.
namespace ptm::tests {

bool fuzz_reads(const std::uint8_t* data, std::size_t size) {
  return read_map_of_coding(golden::Coding::jpeg, data, size);
}

std::vector<FuzzSeed> fuzz_seeds() {
  std::vector<FuzzSeed> seeds;
  const golden::PtmWriteOptions exact{.coding = golden::Coding::jpeg, .inversion = true};
  add_maps(seeds, golden::MapKind::lrgb, "lrgb", exact);
  add_maps(seeds, golden::MapKind::rgb, "rgb", exact);
  add_maps(seeds, golden::MapKind::lrgb, "lossy",
           {.coding = golden::Coding::jpeg, .jpeg_quality = 40, .exact = false});
  // Planes that build on others, one on an inverse, and a record of side information.
  CraftedPlanes file(golden::Coding::jpeg, "JPEG_LRGB", 3, 2);
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
