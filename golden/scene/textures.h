#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "golden/files/ptm_map.h"
#include "golden/scene/unit_scene.h"

namespace ptm::golden {

inline constexpr int kLargestTexture = 4096;  ///< texels a side
/// What to do with a map that is larger, one sentence: the command that cuts a part out.
[[nodiscard]] std::string crop_advice(const std::filesystem::path& map_file, int width, int height);
inline constexpr int kMostLrgbEntries = 256;  ///< of an LRGB map's palette; RGB: 4096

/// A texture in real numbers, as its file or rule gives it; level 0 only.
struct LoadedTexture {
  std::string name;
  int width = 0, height = 0;
  int polynomials = 1;              ///< 1 LRGB, 3 RGB, 0 a plain picture
  std::vector<double> coef;         ///< [height][width][polynomials][6], a0 first, in levels
  std::vector<std::uint8_t> color;  ///< LRGB: [height][width][3]
  std::vector<double> rgba;         ///< picture: [height][width][4], levels; alpha 255 if none
  std::optional<PtmMap> stored;     ///< a .ptm's own bytes, LRGB or RGB
  std::vector<std::string> notes;   ///< odd things met while reading, said to the user
  [[nodiscard]] bool is_picture() const { return polynomials == 0; }
  [[nodiscard]] std::size_t texels() const {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  }
};

/// All textures of a scene, in its order.
///
///     ptm       coefficients by Eq. 7; a LUM file becomes RGB, exactly: each channel of
///               matrix * (Cr, L, Cb, 1) is a polynomial too
///     capture   fitted by least squares (golden/fit), not rounded
///     bump      normals' polynomials (section 3.5) for white, 255 levels
///     picture   as read_picture_with_alpha() gives it
///     generate  generate_texture()
///
/// Throws InputError: what the readers throw, sizes above kLargestTexture, a palette of more
/// entries than the hardware has.
[[nodiscard]] std::vector<LoadedTexture> load_textures(const UnitScene& scene);
using LoadedTextures = std::vector<LoadedTexture>;

}  // namespace ptm::golden
