#pragma once
#include <array>

#include "golden/scene/shape.h"
#include "golden/scene/unit_scene.h"

namespace ptm::golden {

/// A ray and how it changes from pixel to pixel.
struct PixelRay {
  Ray ray;
  Ray dx, dy;  ///< change of origin and direction, a pixel to the right, a pixel down
};

/// Looks from `position` to `target`, `up` upwards in the picture; pixels are square.
class Camera {
 public:
  Camera(const CameraSpec& spec, const std::array<int, 2>& size);
  /// Through the centre of a pixel. The direction is not of unit length: its part along the view
  /// is 1.
  [[nodiscard]] PixelRay ray(int x, int y) const;
  /// From a point of the world toward the camera; of unit length unless the point is the camera.
  [[nodiscard]] Vec3 toward(const Vec3& point) const;

 private:
  Vec3 position_, ahead_, right_, down_;  ///< right_ and down_ a pixel long
  std::array<int, 2> size_;
  bool orthographic_;
};

}  // namespace ptm::golden
