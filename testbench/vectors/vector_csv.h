#pragma once
#include <cstdint>
#include <iosfwd>
#include <string>

#include "model/reference/eval_config.h"

namespace ptm::testbench {

enum class VectorKind : std::uint8_t { lrgb, rgb, lerp };

struct VectorRequest {
  reference::EvalConfig config;
  std::string model = "reference";  ///< reference, rtl or pipeline
  VectorKind kind = VectorKind::lrgb;
  std::uint64_t count = 1000;
  std::uint64_t seed = 1;
};

/// The columns of a kind of vectors, comma-separated; docs/spec/vectors.md explains each.
[[nodiscard]] std::string vector_header(VectorKind kind);

/// Writes the header and `count` rows: the operands of vector_generator.h, which are the same for
/// every model, and what the model makes of them. The pipeline's values come from the reference, so
/// its rows test only the way through the model. Elaborates SystemC if the model is the pipeline:
/// once a process.
void write_vectors(const VectorRequest& request, std::ostream& out);

}  // namespace ptm::testbench
