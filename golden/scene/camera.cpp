#include "golden/scene/camera.h"

#include <cmath>

#include "golden/geometry/direction.h"

namespace ptm::golden {

Camera::Camera(const CameraSpec& spec, const std::array<int, 2>& size)
    : position_(spec.position), size_(size), orthographic_(spec.orthographic) {
  ahead_ = unit(spec.target - spec.position);
  const double half = spec.fov_degrees * std::numbers::pi / 360;
  const double height = spec.orthographic ? spec.height : 2 * std::tan(half);
  right_ = unit(ahead_.cross(spec.up)) * (height / size[1]);
  down_ = ahead_.cross(right_);
}

PixelRay Camera::ray(int x, int y) const {
  const Vec3 offset = (x + 0.5 - size_[0] / 2.0) * right_ + (y + 0.5 - size_[1] / 2.0) * down_;
  const Vec3 none(0, 0, 0);
  if (orthographic_) return {{position_ + offset, ahead_}, {right_, none}, {down_, none}};
  return {{position_, ahead_ + offset}, {none, right_}, {none, down_}};
}

Vec3 Camera::toward(const Vec3& point) const {
  if (orthographic_) return -ahead_;
  return unit(position_ - point);
}

}  // namespace ptm::golden
