#include "golden/files/light_directions.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

#include "golden/files/input_error.h"

namespace ptm::golden {
namespace {

/// Directions are written with six digits or so; only a length further off is worth a note.
constexpr double kUnitLength = 1e-3;

}  // namespace

bool LightDirections::take(std::array<double, 3>& d, const std::string& file,
                           const std::string& place, std::vector<std::string>& notes) {
  ++lights_;
  const double length = std::hypot(d[0], d[1], d[2]);
  if (length == 0) throw InputError(file, place, "light (0, 0, 0)", "a direction");
  if (!std::isfinite(length)) {
    throw InputError(file, place, "a light of endless length", "a direction of length 1");
  }
  if (std::abs(length - 1) > kUnitLength) {
    ++off_unit_;
    shortest_ = std::min(shortest_, length);
    longest_ = std::max(longest_, length);
  }
  for (double& c : d) c /= length;
  if (d[2] < 0) notes.push_back(place + ": light below the horizon, left out");
  return d[2] >= 0;
}

void LightDirections::finish(std::vector<std::string>& notes) const {
  if (off_unit_ == 0) return;
  std::ostringstream note;
  note << off_unit_ << " of " << lights_ << " lights were not of length 1 (" << std::setprecision(4)
       << shortest_ << " to " << longest_ << "), normalised";
  notes.push_back(note.str());
}

}  // namespace ptm::golden
