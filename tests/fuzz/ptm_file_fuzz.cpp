#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>

#include "golden/files/ptm_file.h"

// libFuzzer target: any bytes give a map or an InputError. What was read is written and read again.
// Build and run: scripts/fuzz_ptm_file [seconds].
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const ptm::golden::PtmMap map = ptm::golden::parse_ptm(std::span(data, size), "fuzz").map;
    if (map.texels() > 4096) return 0;
    const auto written = ptm::golden::format_ptm(map);
    if (ptm::golden::parse_ptm(written, "written").map != map) std::abort();
  } catch (const ptm::golden::InputError&) {
  }
  return 0;
}
