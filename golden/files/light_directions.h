#pragma once
#include <array>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace ptm::golden {

/// Makes unit vectors of the directions of a list of lights, and remembers what was odd.
class LightDirections {
 public:
  /// False if the light stands below the horizon (z < 0); the note says so and it is to be left
  /// out. Throws InputError (`file`, `place`) for (0, 0, 0) and for parts that are no numbers;
  /// every other vector, however short or long, has a direction.
  [[nodiscard]] bool take(std::array<double, 3>& direction, const std::string& file,
                          const std::string& place, std::vector<std::string>& notes);
  /// One note for all lights that were not of unit length; if all are shorter than half of it or
  /// longer than twice, it says that they look like positions.
  void finish(std::vector<std::string>& notes) const;

 private:
  std::size_t lights_ = 0, off_unit_ = 0, far_off_ = 0;
  double shortest_ = std::numeric_limits<double>::infinity(), longest_ = 0;
};

}  // namespace ptm::golden
