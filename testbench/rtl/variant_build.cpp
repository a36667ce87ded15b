#include "testbench/rtl/variant_build.h"

#include <cerrno>
#include <cstring>
#include <fstream>

#include "golden/files/input_error.h"

namespace ptm::testbench {

void unpack_sources(const std::filesystem::path& folder) {
  for (const EmbeddedSource& source : embedded_sources()) {
    const std::filesystem::path path = folder / source.name;
    std::error_code error;
    std::filesystem::create_directories(path.parent_path(), error);
    std::ofstream file(path, std::ios::binary);
    file << source.text;
    file.close();
    if (!file) {
      throw golden::InputError(path.string(), "output", std::strerror(errno),
                               "a place where the sources of a unit can be written");
    }
  }
}

}  // namespace ptm::testbench
