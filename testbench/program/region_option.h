#pragma once
#include <CLI/CLI.hpp>
#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>

#include "golden/files/number_text.h"
#include "golden/files/picture_rows.h"

namespace ptm::testbench {

/// "X,Y,W,H" in pixels from the top left, W and H at least 1, of --region and --crop. Anything else
/// is wrong usage. Whether the picture has such a part is not known here.
inline golden::Region parse_region(const std::string& option, const std::string& text) {
  std::array<int, 4> numbers{};
  std::string_view rest = text;
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t comma = i < 3 ? rest.find(',') : rest.size();
    const auto number = comma == std::string_view::npos
                            ? std::nullopt
                            : golden::parse_integer(rest.substr(0, comma), i < 2 ? 0 : 1,
                                                    std::numeric_limits<int>::max());
    if (!number) {
      throw CLI::ValidationError(option, "'" + text +
                                             "' is not X,Y,W,H: the left and upper edge in pixels "
                                             "from the top left, the width and the height");
    }
    numbers[i] = static_cast<int>(*number);
    rest.remove_prefix(i < 3 ? comma + 1 : comma);
  }
  return {numbers[0], numbers[1], numbers[2], numbers[3]};
}

}  // namespace ptm::testbench
