#include "golden/files/picture_rows.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>
#include <vector>

#include "golden/files/open_picture.h"
#include "golden/files/orientation.h"

namespace ptm::golden {
namespace {

namespace fs = std::filesystem;

constexpr double kBrightest = 1e9;  ///< levels; beyond it a picture holds no photograph

/// Rows decoded at once of a picture whose rows are the upright one's columns.
constexpr int kStripRows = 64;

/// Baseline JPEG: the first frame header is SOF0 or SOF1 (ITU-T T.81, B.1.1.3).
bool is_sequential_jpeg(std::ifstream& in) {
  in.seekg(2);
  while (in) {
    if (in.get() != 0xFF) return false;
    int marker = in.get();
    while (marker == 0xFF) marker = in.get();
    if (marker >= 0xC0 && marker <= 0xCF && marker != 0xC4 && marker != 0xC8 && marker != 0xCC) {
      return marker <= 0xC1;
    }
    const int high = in.get(), low = in.get();
    if (high < 0 || low < 0) return false;
    in.seekg(high * 256 + low - 2, std::ios::cur);
  }
  return false;
}

bool has_row_decoder(const fs::path& path, const OIIO::ImageInput& input) {
  const std::string format = input.format_name();
  if (input.spec().tile_width != 0) return false;
  if (format == "tiff" || format == "openexr") return true;
  std::ifstream in(path, std::ios::binary);
  if (format == "jpeg") return is_sequential_jpeg(in);
  if (format != "png") return false;
  in.seekg(28);  // IHDR's interlace method
  return in.get() == 0;
}

double srgb_to_linear(double s) {
  return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
}

/// The level of every stored integer, 0..white.
std::vector<float> level_table(std::size_t white, bool linear) {
  std::vector<float> table(white + 1);
  for (std::size_t s = 0; s <= white; ++s) {
    const double share = static_cast<double>(s) / static_cast<double>(white);
    const double level = 255 * (linear ? srgb_to_linear(share) : share);
    table[s] = static_cast<float>(level);
  }
  return table;
}

}  // namespace

struct PictureRows::State {
  fs::path path;
  std::unique_ptr<OIIO::ImageInput> input;
  OIIO::ImageSpec spec;
  bool streams = false;
  Orientation orientation;
  int next_row = 0;          ///< where the open decoder stands
  std::vector<float> table;  ///< integer pictures only

  /// Rows first..first+rows of all channels as stored.
  template <class Stored>
  std::vector<Stored> decode(int first, int rows, OIIO::TypeDesc type) {
    if (!input || first < next_row) input = open_picture(path);
    const auto channels = static_cast<std::size_t>(spec.nchannels);
    const std::size_t row = static_cast<std::size_t>(spec.width) * channels;
    const bool tiled = spec.tile_width != 0;
    std::vector<Stored> stored(row * static_cast<std::size_t>(tiled ? spec.height : rows));
    const int y = spec.y + first;
    const bool done =
        tiled ? input->read_image(0, 0, 0, spec.nchannels, type, stored.data())
              : input->read_scanlines(0, 0, y, y + rows, 0, 0, spec.nchannels, type, stored.data());
    // A codec may warn, fill the rest with grey, and call that a success.
    if (!done || input->has_error()) fail_picture(path, "pixels", input->geterror(), kAPicture);
    next_row = first + rows;
    if (!streams || next_row == spec.height) input.reset();
    if (tiled) {
      const auto at = [&](int r) { return stored.begin() + static_cast<std::ptrdiff_t>(row) * r; };
      stored = std::vector<Stored>(at(first), at(first + rows));
    }
    return stored;
  }

  /// Hands each sample of `region`, upright, to take(plane, index, stored value).
  template <class Stored, class Take>
  void for_each(const Region& region, OIIO::TypeDesc type, Take take) {
    const auto one = orientation.stored(region.x, region.y);
    const auto other =
        orientation.stored(region.x + region.width - 1, region.y + region.height - 1);
    const int top = std::min(one[1], other[1]), bottom = std::max(one[1], other[1]) + 1;
    // A turned picture's row needs all stored rows: a few at a time where the decoder lets them go.
    const int strip = orientation.swaps() && streams ? kStripRows : bottom - top;
    for (int y = top; y < bottom; y += strip) {
      const int rows = std::min(strip, bottom - y);
      const std::vector<Stored> stored = decode<Stored>(y, rows, type);
      for (int r = 0; r < rows; ++r) {
        const Stored* row =
            stored.data() + static_cast<std::ptrdiff_t>(r) * spec.width * spec.nchannels;
        take_row(region, row, y + r, std::min(one[0], other[0]), std::max(one[0], other[0]), take);
      }
    }
  }

  /// The samples left..right of a stored row, to where they stand upright.
  template <class Stored, class Take>
  void take_row(const Region& region, const Stored* row, int y, int left, int right,
                Take take) const {
    const auto index = [&](int x) {
      const auto at = orientation.upright(x, y);
      return std::ptrdiff_t{at[1] - region.y} * region.width + (at[0] - region.x);
    };
    const std::ptrdiff_t first = index(left), step = left < right ? index(left + 1) - first : 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const Stored* from =
          row + static_cast<std::ptrdiff_t>(left) * spec.nchannels + (spec.nchannels < 3 ? 0 : c);
      std::ptrdiff_t at = first;
      for (int x = left; x <= right; ++x, at += step, from += spec.nchannels) {
        take(c, static_cast<std::size_t>(at), *from);
      }
    }
  }

  template <class Stored>
  void read_integers(const Region& region, const std::array<std::span<float>, 3>& planes,
                     OIIO::TypeDesc type, SampleCounts& counts) {
    const std::size_t white = table.size() - 1;
    for_each<Stored>(region, type, [&](std::size_t plane, std::size_t at, Stored s) {
      counts.saturated += s == white ? 1U : 0U;
      planes[plane][at] = table[s];
    });
  }

  void read_floats(const Region& region, const std::array<std::span<float>, 3>& planes,
                   SampleCounts& counts) {
    const auto width = static_cast<std::size_t>(region.width);
    for_each<float>(region, OIIO::TypeDesc::FLOAT, [&](std::size_t plane, std::size_t at, float s) {
      const double level = 255 * double{s};
      if (!(std::abs(level) <= kBrightest)) {
        fail_picture(path,
                     "pixel " + std::to_string(static_cast<std::size_t>(region.x) + at % width) +
                         ", " + std::to_string(static_cast<std::size_t>(region.y) + at / width),
                     "sample " + std::to_string(s), "a level that light can have");
      }
      counts.saturated += level >= 255 ? 1U : 0U;
      counts.negative += level < 0 ? 1U : 0U;
      planes[plane][at] = static_cast<float>(std::max(level, 0.0));
    });
  }
};

PictureRows::PictureRows(const fs::path& path, bool linear, bool as_stored)
    : state_(std::make_unique<State>()) {
  state_->path = path;
  const auto input = open_picture(path);
  state_->spec = input->spec();
  const OIIO::ImageSpec& spec = state_->spec;
  state_->orientation = Orientation(as_stored ? 1 : spec.get_int_attribute("Orientation", 1),
                                    spec.width, spec.height);
  state_->streams = has_row_decoder(path, *input);
  if (state_->spec.format == OIIO::TypeDesc::UINT8) state_->table = level_table(255, linear);
  if (state_->spec.format == OIIO::TypeDesc::UINT16) state_->table = level_table(65535, linear);
}
PictureRows::PictureRows(PictureRows&&) noexcept = default;
PictureRows& PictureRows::operator=(PictureRows&&) noexcept = default;
PictureRows::~PictureRows() = default;

int PictureRows::width() const { return state_->orientation.width(); }
int PictureRows::height() const { return state_->orientation.height(); }
int PictureRows::orientation() const { return state_->orientation.tag(); }
bool PictureRows::streams() const { return state_->streams; }
bool PictureRows::decodes_once() const {
  return state_->streams && state_->orientation.keeps_rows();
}

void PictureRows::read(const Region& region, const std::array<std::span<float>, 3>& planes,
                       SampleCounts& counts) {
  if (state_->spec.format == OIIO::TypeDesc::UINT8) {
    state_->read_integers<std::uint8_t>(region, planes, OIIO::TypeDesc::UINT8, counts);
  } else if (state_->spec.format == OIIO::TypeDesc::UINT16) {
    state_->read_integers<std::uint16_t>(region, planes, OIIO::TypeDesc::UINT16, counts);
  } else {
    state_->read_floats(region, planes, counts);
  }
}

}  // namespace ptm::golden
