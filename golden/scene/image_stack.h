#pragma once
#include <array>
#include <vector>

#include "golden/scene/textures.h"

/// Sequences of pictures fitted to RGB maps of one parameter (section 4.2): lu runs from -1 to 1
/// over the sequence, lv has no say (its coefficients are 0).
namespace ptm::golden {

/// Three planes one behind the other, photographed at kFocusPictures distances of focus: lu = -1
/// is near, 1 far. A plane out of focus is blurred over a disc whose radius grows with its distance
/// from the plane in focus.
[[nodiscard]] LoadedTexture make_focus_stack(const TextureSpec& spec);
inline constexpr int kFocusPictures = 8;

/// A beach from dawn to dusk in kTidePictures pictures while the tide goes out.
[[nodiscard]] LoadedTexture make_tide(const TextureSpec& spec);
inline constexpr int kTidePictures = 40;

/// One picture of a sequence: [height][width][3] levels.
using StackPicture = std::vector<double>;
/// The pictures that are fitted, in order; also what a test compares a map with.
[[nodiscard]] std::vector<StackPicture> focus_pictures(const TextureSpec& spec);
[[nodiscard]] std::vector<StackPicture> tide_pictures(const TextureSpec& spec);

/// Least squares over lu = -1 .. 1, evenly spaced.
[[nodiscard]] LoadedTexture fit_stack(const TextureSpec& spec,
                                      const std::vector<StackPicture>& pictures);

}  // namespace ptm::golden
