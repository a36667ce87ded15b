#include "golden/fit/capture.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <system_error>

#include "golden/files/light_table.h"

namespace ptm::golden {
namespace {

std::string size_of(int width, int height) {
  return std::to_string(width) + " x " + std::to_string(height);
}

LightPositions read_lights(const CaptureRequest& request) {
  std::error_code ignored;
  const bool folder = std::filesystem::is_directory(request.source, ignored);
  PictureSource source = request.pictures;
  source.positions = request.width_mm > 0;
  if (request.lights.empty()) {
    if (!folder) return read_light_positions(request.source, source);
    throw InputError(request.source.string(), "capture", "a folder without a table of lights",
                     "a .lp file, or --lights TABLE with the folder");
  }
  if (!folder) {
    throw InputError(request.source.string(), "capture", "no folder",
                     "the folder of the pictures that the table of lights lights");
  }
  return request.univariate ? read_parameter_table(request.lights, request.source)
                            : read_light_table(request.lights, request.source, source.positions);
}

/// Refuses a picture that another light has already, under whatever name: lists whose folders are
/// not there would else be read as one photograph under all lights.
class TakenPictures {
 public:
  void take(const LitPicture& lit, const std::string& list) {
    std::error_code error;
    const std::filesystem::path whole = std::filesystem::canonical(lit.picture, error);
    const auto [at, first] = lines_.emplace(error ? lit.picture : whole, lit.line);
    if (first) return;
    throw InputError(list, "line " + std::to_string(lit.line),
                     "the picture " + lit.picture.string() + ", which line " +
                         std::to_string(at->second) + " has already",
                     "a picture for each light, or --share-pictures");
  }

 private:
  std::map<std::filesystem::path, int> lines_;  ///< by file, links resolved
};

Region region_of(const CaptureRequest& request, int width, int height) {
  if (!request.region) return {0, 0, width, height};
  const Region& r = *request.region;
  const bool inside = r.x >= 0 && r.y >= 0 && r.width > 0 && r.height > 0 && r.x < width &&
                      r.y < height && r.width <= width - r.x && r.height <= height - r.y;
  if (!inside) {
    throw InputError(request.source.string(), "region",
                     std::to_string(r.x) + "," + std::to_string(r.y) + "," +
                         std::to_string(r.width) + "," + std::to_string(r.height),
                     "X,Y,W,H within " + size_of(width, height) + " pixels");
  }
  return r;
}

/// Says what was turned; of one camera that stood still, all photographs should be alike.
void tell_orientations(Capture& capture) {
  std::map<int, int> tags;
  for (const PictureRows& photograph : capture.photographs) ++tags[photograph.orientation()];
  if (tags.size() == 1 && tags.begin()->first == 1) return;
  std::string note = "photographs were turned or mirrored as their tag Orientation says: ";
  for (const auto& [tag, count] : tags) {
    note += (tag == tags.begin()->first ? "" : ", ") + std::to_string(count) + " with " +
            std::to_string(tag);
  }
  if (tags.size() > 1) {
    note += "; of a camera that stood still these tags would be one, --as-stored passes over them";
  }
  capture.notes.push_back(note);
}

/// Places the picture among lights whose positions are known.
void place_picture(const CaptureRequest& request, const std::string& list,
                   const LightPositions& lights, Capture& capture) {
  const PictureRows& first = capture.photographs.front();
  const double pixel = request.width_mm / first.width();
  capture.frame = PictureFrame{first.width(), first.height(), capture.region, pixel};
  const double across = request.width_mm / 2, up = pixel * first.height() / 2;
  bool unit = request.width_mm > 1;
  for (const LitPicture& lit : lights.pictures) {
    const auto& p = lit.position;
    unit = unit && std::abs(std::hypot(p[0], p[1], p[2]) - 1) < 1e-3;
    const double away = std::hypot(std::max(0.0, std::abs(p[0]) - across),
                                   std::max(0.0, std::abs(p[1]) - up), p[2]);
    if (!unit && away < pixel) {
      throw InputError(list, "line " + std::to_string(lit.line), "a light within the picture",
                       "positions in the unit of --width-mm, the picture's centre being (0, 0, 0)");
    }
  }
  if (unit) {
    throw InputError(list, "lights", "unit vectors, which are directions",
                     "positions in the unit of --width-mm, the picture's centre being (0, 0, 0)");
  }
  if (!request.linear) {
    capture.notes.emplace_back(
        "near lights' fall-off is taken off the values as they are stored; of photographs in sRGB "
        "it holds with --linear only");
  }
}

}  // namespace

Capture open_capture(const CaptureRequest& request) {
  LightPositions lights = read_lights(request);
  Capture capture;
  capture.notes = std::move(lights.notes);
  const std::string& list = (request.lights.empty() ? request.source : request.lights).string();
  TakenPictures taken;
  for (const LitPicture& lit : lights.pictures) {
    if (!request.share_pictures) taken.take(lit, list);
    PictureRows photograph(lit.picture, request.linear, request.as_stored);
    const int width = photograph.width(), height = photograph.height();
    if (capture.photographs.empty()) {
      capture.region = region_of(request, width, height);
    } else {
      const PictureRows& first = capture.photographs.front();
      if (width != first.width() || height != first.height()) {
        throw InputError(
            list, "line " + std::to_string(lit.line),
            lit.picture.filename().string() + " of " + size_of(width, height) + " pixels",
            size_of(first.width(), first.height()) + " like the first photograph" +
                (photograph.orientation() == first.orientation()
                     ? ""
                     : ", whose tag Orientation differs; --as-stored passes over these tags"));
      }
    }
    capture.photographs.push_back(std::move(photograph));
    capture.names.push_back(lit.picture.filename().string());
    capture.directions.push_back(lit.direction);
    if (request.width_mm > 0) capture.positions.push_back(lit.position);
  }
  if (request.width_mm > 0) place_picture(request, list, lights, capture);
  tell_orientations(capture);
  return capture;
}

}  // namespace ptm::golden
