#pragma once
#include <stdexcept>
#include <string>
#include <vector>

#include "golden/scene/surface_samples.h"
#include "tests/golden/made_scene.h"

namespace ptm::golden {

inline const std::string kMap =
    "[[texture]]\nname = \"m\"\ngenerate = \"gradient\"\nsize = [64, 32]\n";

class Samples : public MadeScene {
 protected:
  void make(const std::string& text) {
    scene_ = read(text);
    textures_ = load_textures(scene_);
    samples_ = make_samples(scene_, textures_, 0);
  }
  /// The sample at a pixel; the pixel must be covered.
  [[nodiscard]] const SurfaceSample& at(int x, int y) const {
    for (const SurfaceSample& s : samples_) {
      if (s.x == x && s.y == y) return s;
    }
    throw std::out_of_range("no sample there");
  }

  UnitScene scene_;
  LoadedTextures textures_;
  std::vector<SurfaceSample> samples_;
};

inline const std::string kSquareOn =
    "[image]\nsize = [20, 12]\ntile = 8\n[camera]\northographic = true\nheight = 2\n"
    "[[object]]\nkind = \"plane\"\ntexture = \"m\"\norigin = [-5, 0, 5]\ni = [10, 0, 0]\n"
    "j = [0, 0, -10]\n";
inline const std::string kLight = "[[light]]\ndirection = [0, -1, 0]\n";

/// Three objects, each turned, before a camera that leans.
inline const std::string kThree = R"(
[image]
size = [96, 64]
[camera]
position = [0.5, -5, 2]
up = [0.2, 0.1, 1]
fov_degrees = 50
[[object]]
kind = "sphere"
texture = "m"
translate = [-1.2, 0, 0.3]
rotate = [20, 30, 40]
scale = [1, 1.5, 0.7]
[[object]]
kind = "cylinder"
texture = "m"
translate = [1.2, 0.2, 0]
rotate = [-15, 10, 0]
uv_scale = [2, -3]
[[object]]
kind = "plane"
texture = "m"
origin = [-30, 30, -1.3]
i = [60, 0, 0]
j = [0, -60, 0]
)";

}  // namespace ptm::golden
