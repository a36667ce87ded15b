#pragma once
#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "golden/files/input_error.h"
#include "golden/files/ptm_map.h"
#include "golden/scene/setting.h"
#include "golden/scene/shape.h"

/// A scene for the whole texture unit, as its TOML file says it; docs/spec/scene.md has every key
/// with its range, and docs/design/scene.md why they mean what they mean.
namespace ptm::golden {

enum class Traversal : std::uint8_t { scan, tiles };
enum class WrapMode : std::uint8_t { repeat, mirror, clamp };
enum class MipMode : std::uint8_t { none, nearest, linear };
enum class CombineMode : std::uint8_t { none, modulate, decal, blend, add, replace };

/// A filter's two choices: within a level, and between levels.
struct FilterMode {
  bool bilinear = true;
  MipMode mip = MipMode::none;
  bool operator==(const FilterMode&) const = default;
};

struct CameraSpec {
  Vec3 position{0, -4, 0}, target{0, 0, 0}, up{0, 0, 1};
  bool orthographic = false;
  double fov_degrees = 40;  ///< vertical, of the whole picture
  double height = 2;        ///< orthographic: world height of the picture
};

enum class TextureSource : std::uint8_t {
  ptm,
  capture,
  bump_heights,
  bump_normals,
  picture,
  generate
};

inline constexpr int kFullPalette = -1;  ///< as many entries as the hardware has for the format

/// One [[texture]]. What is not said is empty: a draw's two textures share their sampling.
struct TextureSpec {
  std::string name;
  std::string place;  ///< where the scene says it: "line 7 (texture[0])"
  TextureSource source = TextureSource::generate;
  std::filesystem::path file;         ///< all sources but generate; resolved
  MapKind kind = MapKind::lrgb;       ///< capture, generate: lrgb or rgb
  bool plain = false;                 ///< generate: a picture instead of a map
  std::optional<double> strength;     ///< of a bump map's heights (16) or normals (1)
  bool green_down = false;            ///< of a map of normals
  std::string pattern;                ///< generate
  std::array<int, 2> size{256, 256};  ///< generate
  std::uint64_t seed = 1;             ///< generate
  int palette =
      0;  ///< entries of the palette that hardware stores it with; 0: none, or kFullPalette
  std::optional<WrapMode> wrap_u, wrap_v;
  std::optional<FilterMode> filter;
  std::optional<int> probes;
  [[nodiscard]] bool is_picture() const { return plain || source == TextureSource::picture; }
};

struct TransformSpec {
  Vec3 translate{0, 0, 0};
  Vec3 rotate{0, 0, 0};  ///< degrees about x, then y, then z
  Vec3 scale{1, 1, 1};   ///< not 0; first of all
};

/// How a mesh gets its coordinates.
enum class MeshMapping : std::uint8_t {
  own,             ///< the OBJ's vt
  object_normal,   ///< two-stage: along the mesh's normal to the intermediate surface
  surface_normal,  ///< two-stage: along the intermediate surface's normal
  centroid         ///< two-stage: from the mesh's centroid through the point
};

struct ObjectSpec {
  std::string place;
  bool mesh = false;
  Shape shape;                 ///< the object, or the intermediate surface of a two-stage mapping
  std::filesystem::path file;  ///< of a mesh; resolved
  MeshMapping mapping = MeshMapping::own;
  TransformSpec transform;
  std::array<double, 2> uv_scale{1, 1}, uv_offset{0, 0};  ///< u' = offset + scale * u
  std::array<int, 2> segments{32, 16};  ///< cells along u and v for light per vertex; not of meshes
  int draw = 0;
};

/// One [[object.effect]]: docs/spec/scene.md; its keys are those of golden/effects/effect.h.
struct EffectSpec {
  std::string effect;                        ///< its name
  std::string place;                         ///< where the scene says it
  std::vector<std::vector<double>> numbers;  ///< one a key; of a texture its index, of a word its
                                             ///< place among the choices
  /// Where it stands is no part of what it is.
  bool operator==(const EffectSpec& other) const {
    return effect == other.effect && numbers == other.numbers;
  }
};

/// What of an object the unit's descriptor holds; objects that agree share a draw.
struct DrawSpec {
  int map = -1;    ///< index of the texture, -1: none
  int color = -1;  ///< index of the plain picture, -1: none
  CombineMode combine = CombineMode::none;
  double ka = 0, kd = 1;
  WrapMode wrap_u = WrapMode::repeat, wrap_v = WrapMode::repeat;
  FilterMode filter{};
  int probes = 1;                   ///< most probes of footprint assembly; a power of two
  std::vector<EffectSpec> effects;  ///< in the order of the rows of effects.def
  bool operator==(const DrawSpec&) const = default;
  /// The texture whose texels `SurfaceSample::lod` counts.
  [[nodiscard]] int main_texture() const { return map >= 0 ? map : color; }
};
inline constexpr int kMostDraws = 4;
inline constexpr std::int64_t kMostPixels = std::int64_t{1} << 24;  ///< each is held in memory

enum class LightKind : std::uint8_t {
  local,        ///< the same (lu, lv) in every point's own frame, as a flat scene has it
  directional,  ///< a direction in the world
  point         ///< a position in the world
};
struct LightSpec {
  LightKind kind = LightKind::directional;
  Vec3 vector{0, 0, 1};  ///< unit vector toward the light; its position; (lu, lv, 0)
  std::string place;
};

/// Random gaps at the input and stalls at the output: in how many of 256 cycles.
struct StressSpec {
  int input_gap = 0, output_stall = 0;
  std::uint64_t seed = 1;
};

struct UnitScene {
  std::filesystem::path file;
  std::array<int, 2> size{256, 256};
  Traversal traversal = Traversal::tiles;
  int tile = 16;
  std::array<double, 3> background{0, 0, 0};  ///< levels, where no object is
  CameraSpec camera;
  std::vector<TextureSpec> textures;
  std::vector<ObjectSpec> objects;  ///< at least one
  std::vector<DrawSpec> draws;      ///< 1..kMostDraws
  std::vector<LightSpec> lights;    ///< at least one; a frame each
  Settings hardware, memory;        ///< testbench/config/configuration.h reads them
  StressSpec stress;
  bool keep_cache = false;          ///< caches keep their lines from frame to frame
  bool draw_twice = false;          ///< every frame is drawn twice and the second time counts
  std::vector<std::string> models;  ///< all four if the scene names none
};

/// Whether the file has [[object]] or [[texture]], so that read_unit_scene() is to read it and not
/// read_scene(). Throws InputError if it is no TOML.
[[nodiscard]] bool is_unit_scene(const std::filesystem::path& path);

/// Reads a unit scene. Unknown keys but of [hardware] and [memory], keys that mean nothing where
/// they stand, wrong types, values out of range, names of no texture and more than kMostDraws draws
/// throw InputError with the line. Files that the scene names are not opened yet.
[[nodiscard]] UnitScene read_unit_scene(const std::filesystem::path& path);

}  // namespace ptm::golden
