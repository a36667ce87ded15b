#include "model/reference/unit/register_map.h"

#include <cstddef>

namespace ptm::reference {

std::array<std::uint32_t, kCapabilityWords> capability_words(const EvalConfig& config,
                                                             const UnitConfig& unit){
#include "contract/capability_words.inc"
}

std::uint32_t stored_bits(std::uint16_t address, const UnitConfig& unit, const EvalConfig& config) {
#include "contract/stored_bits.inc"
}

}  // namespace ptm::reference
