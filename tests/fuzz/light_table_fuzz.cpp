#include <cmath>
#include <functional>

#include "golden/files/light_table.h"
#include "tests/fuzz/fuzz_folder.h"
#include "tests/fuzz/fuzz_target.h"

// Tables of lights, and tables of one parameter, for folders of three and of four pictures: a table
// for another count is read as a whole before it is refused.
namespace ptm::tests {
namespace {

const FuzzFolder& folder() {
  static const FuzzFolder made;
  static const bool filled = [] {
    for (const char* name : {"three/1.png", "three/2.png", "three/10.png", "four/1.png",
                             "four/2.png", "four/3.png", "four/4.png"}) {
      made.write(name, nullptr, 0);
    }
    return true;
  }();
  (void)filled;
  return made;
}

bool reads(const std::function<golden::LightPositions()>& read, bool unit) {
  try {
    const golden::LightPositions lights = read();
    if (lights.pictures.empty()) std::abort();
    for (const golden::LitPicture& light : lights.pictures) {
      const auto& [x, y, z] = light.direction;
      // Unit vectors, but for some roundings of each coordinate and of this sum; parameters lie
      // within -1..1.
      if (unit ? !(std::abs(x * x + y * y + z * z - 1) < 1e-14) || z < 0 : !(std::abs(x) <= 1)) {
        std::abort();
      }
    }
    return true;
  } catch (const golden::InputError&) {
    return false;
  }
}

}  // namespace

bool fuzz_reads(const std::uint8_t* data, std::size_t size) {
  const auto table = folder().write("table.txt", data, size);
  bool taken = false;
  for (const char* name : {"three", "four"}) {
    const auto pictures = folder().path() / name;
    taken |= reads([&] { return golden::read_light_table(table, pictures); }, true);
    taken |= reads([&] { return golden::read_parameter_table(table, pictures); }, false);
  }
  return taken;
}

std::vector<FuzzSeed> fuzz_seeds() {
  return {{"a_light_a_line", "# x y z\n0 0 1\n0.6, 0, 0.8\n\n-0.6;0;0.8\r\n"},
          {"a_coordinate_a_line", "0 0.6 -0.6 0\n0 0 0 0.6\n1 0.8 0.8 0.8\n"},
          {"far", "1e200 0 1e200\n-1e-200 1e-200 1e-200\n3\t4 12"},
          {"parameters", "-1\n0.25\n1\n"},
          {"parameters_far", "-1.7e308 0 1.7e308"},
          {"refused_words", "0 0 one\n"},
          {"refused_uneven", "0 0 1\n0 0\n0 0 1 1\n1 1 1\n"}};
}

}  // namespace ptm::tests

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  (void)ptm::tests::fuzz_reads(data, size);
  return 0;
}
