#pragma once
#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "golden/files/light_positions.h"
#include "golden/files/picture_rows.h"
#include "golden/fit/near_lights.h"

namespace ptm::golden {

struct CaptureRequest {
  std::filesystem::path source;  ///< a .lp file, or with `lights` a folder of pictures
  std::filesystem::path lights;  ///< a light table; with `univariate` one number a picture
  PictureSource pictures;        ///< of a .lp file: where its pictures are, if not as it says
  bool univariate = false;
  bool share_pictures = false;  ///< several lights may have the same picture
  bool linear = false;          ///< integer samples are sRGB and are decoded to linear light
  bool as_stored = false;       ///< the photographs' tag Orientation is passed over
  double width_mm = 0;  ///< above 0: lights are near, at positions in the unit of this width
                        ///< of the whole picture
  std::optional<Region> region;  ///< the part to fit; all of it without
};

/// Photographs of one thing from one place, each under one light; their pixels are still on disk.
struct Capture {
  Region region;                                  ///< the part of every photograph that counts
  std::vector<std::string> names;                 ///< one a photograph
  std::vector<std::array<double, 3>> directions;  ///< unit vectors to the lights, or (u, 0, 0)
  std::optional<PictureFrame> frame;              ///< of near lights
  std::vector<std::array<double, 3>> positions;   ///< as the list has them, in the frame's unit
  std::vector<PictureRows> photographs;
  std::vector<std::string> notes;  ///< what was odd about the input, said to the user
};

/// Reads the list of lights and the headers of all photographs.
/// Throws InputError: what read_light_positions(), read_light_table() and PictureRows throw,
/// photographs of different sizes (the line of the list is named), a region outside them; of near
/// lights, unit vectors for a picture wider than 1, and a light less than a pixel from the picture.
[[nodiscard]] Capture open_capture(const CaptureRequest& request);

}  // namespace ptm::golden
