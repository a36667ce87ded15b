#pragma once
#include <array>
#include <optional>
#include <vector>

#include "golden/scene/textures.h"
#include "golden/scene/unit_scene.h"

namespace ptm::golden {

/// What the geometry asks of the texture unit at one pixel.
struct SurfaceSample {
  int x = 0, y = 0;  ///< the pixel; the ray goes through its centre
  int object = 0;
  int draw = 0;
  double u = 0, v = 0;            ///< 1.0 is the texture's width or height; v runs down
  double dudx = 0, dvdx = 0;      ///< a pixel to the right
  double dudy = 0, dvdy = 0;      ///< a pixel down
  double lod = 0;                 ///< log2 of texels of level 0; negative where magnified
  double axis_u = 0, axis_v = 0;  ///< from one probe to the next
  int probes_log2 = 0;
  std::array<double, 2> light{};         ///< (lu, lv), exact at the pixel
  std::array<double, 2> light_vertex{};  ///< the same interpolated from the triangle's corners
  bool lit = true;                       ///< n . l > 0 at the pixel
  std::array<double, 2> half{};  ///< (hu, hv); 0 unless one of the draw's effects asks for it
  std::array<double, 2> half_vertex{};  ///< interpolated likewise
};

/// Covered pixels in the order of traversal: tiles in rows from the top left, scan lines within a
/// tile; or scan lines. Pixels that no object covers are absent. Every pixel comes once.
///
/// **Derivatives** of a ray's hit with the tangent plane, exact at the pixel's centre. The cosine
/// between ray and plane counts as at least kGrazingCosine, |sin phi| at least kPoleSine, and no
/// derivative exceeds kLargestDerivative in size; on a sphere or cylinder du is at most |a|, a
/// turn.
///
/// **Level of detail**, with W x H the size of the draw's main texture (the slides' formula):
///
///     d_x = |(W dudx, H dvdx)|,  d_y likewise,  major = max(d_x, d_y),  minor = min(d_x, d_y)
///     N   = smallest power of two >= major / max(minor, 1), 1..draw.probes; 1 if major <= 1
///     lod = log2(major / N),     axis = (the longer of the two derivatives) / N
///
/// **Frame**: tangent along dP/du, bitangent the part of -dP/dv that is perpendicular to it, normal
/// to the side that is seen. (lu, lv) are the unit light vector's parts along the first two.
/// light_vertex interpolates these linearly over the triangle of the tessellation (section 3.2 of
/// Polynomial Texture Maps): shapes are cut in `segments` cells of p and q, each in two along its
/// diagonal from (p, q) to (p', q'); meshes have their own triangles.
///
/// **Half-vector** (section 3.5), in the same frame, if an effect of the draw asks for it: H = (L +
/// V) / |L + V|, V the unit vector toward the camera (against the view for an orthographic one), L
/// the unit vector toward the scene's light, whatever effects make of it; a local light's third
/// part is sqrt(1 - lu^2 - lv^2), and one beyond the disc is taken from the horizon: (lu, lv, 0) /
/// |(lu, lv)|. Opposite vectors have no half: (0, 0), as if it stood on the surface. half_vertex
/// interpolates it as light_vertex does. Effects then change light and light_vertex.
///
/// Runs on all cores; the result does not depend on their number. Throws InputError from a mesh's
/// file. `frame` is a light's index (std::out_of_range).
[[nodiscard]] std::vector<SurfaceSample> make_samples(const UnitScene& scene,
                                                      const LoadedTextures& textures, int frame);

/// What was odd about the files of the scene's meshes, one note each. Throws as make_samples()
/// does.
[[nodiscard]] std::vector<std::string> mesh_notes(const UnitScene& scene);

/// One pixel of the same; nothing if no object covers it.
[[nodiscard]] std::optional<SurfaceSample> sample_pixel(const UnitScene& scene,
                                                        const LoadedTextures& textures, int frame,
                                                        int x, int y);

inline constexpr double kGrazingCosine = 1e-6;
inline constexpr double kLargestDerivative = 64;
inline constexpr double kSmallestFootprint = 0x1p-32;  ///< texels; keeps lod finite

/// What is added to `lod` for a draw's colour texture: log2 max(Wc / Wm, Hc / Hm); 0 without a map.
[[nodiscard]] double color_lod(const DrawSpec& draw, const LoadedTextures& textures);

}  // namespace ptm::golden
