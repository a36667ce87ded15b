#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string_view>

#include "tests/fuzz/fuzz_target.h"

// Part of each program that libFuzzer drives: TARGET_fuzz --seeds FOLDER writes the target's seeds
// and ends.
extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv) {
  if (*argc != 3 || std::string_view((*argv)[1]) != "--seeds") return 0;
  const std::filesystem::path folder = (*argv)[2];
  std::filesystem::create_directories(folder);
  for (const ptm::tests::FuzzSeed& seed : ptm::tests::fuzz_seeds()) {
    std::ofstream out(folder / seed.name, std::ios::binary);
    out << seed.bytes;
    out.close();
    if (!out) {
      std::fprintf(stderr, "%s cannot be written\n", (folder / seed.name).c_str());
      std::exit(1);
    }
  }
  std::exit(0);
}
