#pragma once

namespace ptm::pipeline::effects {

struct negative {
  static constexpr int registers = 1;
};

}  // namespace ptm::pipeline::effects
