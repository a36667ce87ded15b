#pragma once
#include "effects/pipeline_stages.h"
#include "model/reference/effects/stages.h"

namespace ptm::pipeline::effects {

/// Registers behind the combine stage of a unit built with these stages.
[[nodiscard]] constexpr int chain_registers(unsigned stages) {
  int registers = 0;
#define PTM_REGISTERS(id) \
  if ((stages & reference::effects::stage_bit(#id)) != 0) registers += id::registers;
  PTM_PIPELINE_STAGES(PTM_REGISTERS)
#undef PTM_REGISTERS
  return registers;
}

}  // namespace ptm::pipeline::effects
