#pragma once
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "testbench/run/timed_models.h"

namespace ptm::testbench {

/// Answers for any pixel: every operand and intermediate value, in any model. A hardware value is
/// printed as its integer code and, where it has a scale, the real number it stands for; golden's
/// row of the same name is that real number. The pipeline's values are the reference's, by
/// construction; its own are the cycles.
[[nodiscard]] PixelProbe make_probe(
    std::shared_ptr<const FlatJob> job,
    std::map<std::string, std::vector<std::vector<pipeline::Cycle>>> cycles);

}  // namespace ptm::testbench
