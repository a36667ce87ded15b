#include <array>
#include <cmath>

#include "golden/files/light_positions.h"
#include "tests/fuzz/fuzz_folder.h"
#include "tests/fuzz/fuzz_target.h"

// Lists of photographs and their lights (.lp). Pictures are sought, but not opened, by the reader:
// the folder has some for the list to name.
namespace ptm::tests {
namespace {

const FuzzFolder& folder() {
  static const FuzzFolder made;
  static const bool filled = [] {
    for (const char* name : {"1.png", "2.png", "3.png", "a b.png", "sub/4.png"}) {
      made.write(name, nullptr, 0);
    }
    return true;
  }();
  (void)filled;
  return made;
}

}  // namespace

bool fuzz_reads(const std::uint8_t* data, std::size_t size) {
  try {
    const auto lights =
        golden::read_light_positions(folder().write("fuzz.lp", data, size)).pictures;
    if (lights.empty()) std::abort();
    for (const golden::LitPicture& light : lights) {
      const auto& [x, y, z] = light.direction;
      // Unit vectors, but for some roundings of each coordinate and of this sum.
      if (!(std::abs(x * x + y * y + z * z - 1) < 1e-14) || z < 0) std::abort();
      if (!std::filesystem::is_regular_file(light.picture)) std::abort();
    }
    return true;
  } catch (const golden::InputError&) {
    return false;
  }
}

std::vector<FuzzSeed> fuzz_seeds() {
  return {{"plain", "3\n1.png 0 0 1\n2.png 0.6 0 0.8\n3.png -0.6 0 0.8\n"},
          {"odd",
           "\xEF\xBB\xBF"
           "9\r\n\r\n a b.png\t1e-3  -.5 +2 \r\nsub\\4.png 0 1 0\r\n"
           "C:/pictures/1.png 3 4 12\r\n2.png 0 0 -1"},
          {"no_count", "sub/4.png -1e200 1e200 1e-200\n"},
          {"refused_no_picture", "1\nnone.png 0 0 1\n"},
          {"refused_light", "1.png 0 0 0\n2.png nan inf 1\n"}};
}

}  // namespace ptm::tests

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  (void)ptm::tests::fuzz_reads(data, size);
  return 0;
}
