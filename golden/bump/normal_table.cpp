#include "golden/bump/normal_table.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace ptm::golden {

using std::numbers::pi;

NormalTable::NormalTable(BumpDomain domain, std::size_t rows, std::size_t columns)
    : rows_(rows), columns_(columns) {
  if (rows < 2 || columns < 3)
    throw std::invalid_argument("a table of normals needs 2 x 3 or more");
  const Eigen::Matrix<double, 6, 3> fit = normal_fit(domain);
  for (std::size_t i = 0; i < rows; ++i) {
    for (std::size_t j = 0; j < columns; ++j) {
      const double latitude = pi / 2 * static_cast<double>(i) / static_cast<double>(rows - 1);
      const double longitude = 2 * pi * static_cast<double>(j) / static_cast<double>(columns);
      const Eigen::Vector3d normal(std::sin(latitude) * std::cos(longitude),
                                   std::sin(latitude) * std::sin(longitude), std::cos(latitude));
      const Eigen::Matrix<double, 6, 1> a = fit * normal;
      Entry& entry = entries_.emplace_back();
      std::copy(a.begin(), a.end(), entry.begin());
    }
  }
}

std::array<double, 6> NormalTable::find(const std::array<double, 3>& normal) const {
  const double across = std::hypot(normal[0], normal[1]);
  const double latitude = std::atan2(across, std::max(0.0, normal[2]));
  double longitude = std::atan2(normal[1], normal[0]);
  if (longitude < 0) longitude += 2 * pi;
  const double row = latitude / (pi / 2) * static_cast<double>(rows_ - 1);
  const double column = longitude / (2 * pi) * static_cast<double>(columns_);
  const std::size_t i = std::min(static_cast<std::size_t>(row), rows_ - 2);
  const std::size_t whole = static_cast<std::size_t>(column);
  const double f = row - static_cast<double>(i), g = column - static_cast<double>(whole);
  const std::size_t j = whole % columns_, next = (whole + 1) % columns_;
  std::array<double, 6> a{};
  for (std::size_t k = 0; k < 6; ++k) {
    const double upper =
        (1 - g) * entries_[i * columns_ + j][k] + g * entries_[i * columns_ + next][k];
    const double lower =
        (1 - g) * entries_[(i + 1) * columns_ + j][k] + g * entries_[(i + 1) * columns_ + next][k];
    a[k] = (1 - f) * upper + f * lower;
  }
  return a;
}

}  // namespace ptm::golden
