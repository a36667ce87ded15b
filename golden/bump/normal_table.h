#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "golden/bump/normal_fit.h"

namespace ptm::golden {

/// Polynomials of normals, looked up: section 3.5, steps 1 and 3.
///
/// Entry (i, j) holds the six coefficients of the normal at latitude i / (rows - 1) of 90 degrees,
/// measured from the zenith, and longitude j / columns of 360 degrees. Between entries each of the
/// six is interpolated bilinearly, longitude closing round.
///
/// Error     |N' - N| <= (pi / 2 / (rows - 1))^2 / 8 + (2 pi / columns)^2 / 8 in the normal that an
///           interpolated polynomial stands for: 2.3e-4 + 3.0e-4 at 65 x 128, an eighth of a level.
class NormalTable {
 public:
  explicit NormalTable(BumpDomain domain, std::size_t rows = 65, std::size_t columns = 128);

  /// a0..a5 for a unit normal, 1 for full light. A normal below the horizon (Nw < 0) is taken at
  /// the horizon: a surface seen from above has none.
  [[nodiscard]] std::array<double, 6> find(const std::array<double, 3>& normal) const;

 private:
  using Entry = std::array<double, 6>;
  std::size_t rows_, columns_;
  std::vector<Entry> entries_;  ///< [rows][columns]
};

}  // namespace ptm::golden
