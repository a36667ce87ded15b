#pragma once
#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "golden/files/input_error.h"
#include "golden/scene/setting.h"

namespace ptm::golden {

/// A directional light: the first two coordinates of the unit vector toward it, x right and y up.
struct Light {
  double u = 0, v = 0;
  std::string place;  ///< where the scene says it, for errors: "line 12 (light[0].direction)"
};

/// A scene as its TOML file says it; docs/spec/scene.md has every key. A flat map seen square-on.
struct Scene {
  std::filesystem::path file;              ///< the scene itself
  std::filesystem::path map;               ///< resolved against the scene's folder
  std::optional<std::array<int, 2>> size;  ///< picture's width and height; the map's if absent
  std::vector<Light> lights;               ///< at least one; one frame each
  Settings hardware;                       ///< testbench/config/configuration.h reads them
  std::vector<std::string> models;         ///< all four if the scene names none
};

inline constexpr std::array<const char*, 4> kModels{"golden", "reference", "pipeline", "rtl"};
inline constexpr int kLargestPicture = 16384;  ///< pixels a side

/// Reads a scene. Unknown keys but of [hardware], wrong types and values out of range throw
/// InputError with the line.
[[nodiscard]] Scene read_scene(const std::filesystem::path& path);

}  // namespace ptm::golden
