#pragma once
#include <string>
#include <vector>

#include "golden/effects/effect.h"
#include "golden/render/unit_picture.h"
#include "tests/golden/made_samples.h"

namespace ptm::golden {

class Effects : public Samples {
 protected:
  void prepare(const std::string& text, int frame = 0) {
    scene_ = read(text);
    textures_ = load_textures(scene_);
    extras_ = prepare_effects(scene_, textures_);
    samples_ = make_samples(scene_, textures_, frame);
  }
  [[nodiscard]] Rgb shaded(const SurfaceSample& sample) const {
    return UnitRenderer(scene_, textures_, extras_).shade(sample, sample.light);
  }
  /// What the effects add: against the same scene shaded without extras.
  [[nodiscard]] Rgb added(const SurfaceSample& sample) const {
    const Rgb with = shaded(sample);
    const Rgb without = UnitRenderer(scene_, textures_).shade(sample, sample.light);
    return {with[0] - without[0], with[1] - without[1], with[2] - without[2]};
  }
  std::vector<DrawExtras> extras_;
};

inline constexpr double kPi = std::numbers::pi;
inline const std::string kDark =
    "[[texture]]\nname = \"m\"\ngenerate = \"metal\"\nsize = [16, 16]\n";
inline const std::string kStuds =
    "[[texture]]\nname = \"m\"\ngenerate = \"studs\"\nsize = [24, 24]\nfilter = \"point\"\n";
inline const std::string kSquare =
    "[image]\nsize = [12, 12]\n[camera]\northographic = true\nheight = 2\n"
    "[[object]]\nkind = \"plane\"\ntexture = \"m\"\n";

inline std::string effect(const std::string& kind, const std::string& keys = "") {
  return "[[object.effect]]\nkind = \"" + kind + "\"\n" + keys;
}
inline std::string local(double lu, double lv) {
  return "[[light]]\ndirection = [" + std::to_string(lu) + ", " + std::to_string(lv) + "]\n";
}

}  // namespace ptm::golden
