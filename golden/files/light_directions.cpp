#include "golden/files/light_directions.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

#include "golden/files/input_error.h"
#include "golden/geometry/direction.h"

namespace ptm::golden {
namespace {

/// Directions are written with six digits or so; only a length further off is worth a note.
constexpr double kUnitLength = 1e-3;

}  // namespace

bool LightDirections::take(std::array<double, 3>& d, const std::string& file,
                           const std::string& place, std::vector<std::string>& notes) {
  ++lights_;
  const Eigen::Vector3d vector(d[0], d[1], d[2]);
  if (vector.isZero(0)) throw InputError(file, place, "light (0, 0, 0)", "a direction");
  if (!vector.allFinite()) {
    throw InputError(file, place, "a light that is no vector of numbers", "a direction of length 1");
  }
  const double size = length(vector);
  if (std::abs(size - 1) > kUnitLength) {
    ++off_unit_;
    shortest_ = std::min(shortest_, size);
    longest_ = std::max(longest_, size);
  }
  if (size < 0.5 || size > 2) ++far_off_;
  const Eigen::Vector3d direction = unit(vector);
  std::copy(direction.begin(), direction.end(), d.begin());
  if (d[2] < 0) notes.push_back(place + ": light below the horizon, left out");
  return d[2] >= 0;
}

void LightDirections::finish(std::vector<std::string>& notes) const {
  if (off_unit_ == 0) return;
  std::ostringstream note;
  note << off_unit_ << " of " << lights_ << " lights were not of length 1 (" << std::setprecision(4)
       << shortest_ << " to " << longest_ << "), ";
  if (far_off_ == lights_) {
    note << "as positions are; they are taken as directions, as if all light came from afar: "
            "--width-mm WIDTH fits near lights";
  } else {
    note << "normalised";
  }
  notes.push_back(note.str());
}

}  // namespace ptm::golden
