#include "golden/files/picture_row_writer.h"

#include <stdexcept>
#include <utility>

#include "golden/files/encoded_picture.h"

namespace ptm::golden {

struct PictureRowWriter::Output {
  EncodedPicture image;
};

PictureRowWriter::PictureRowWriter(const std::filesystem::path& path, int width, int height,
                                   int channels)
    : file_(path),
      output_(new Output{{path, OIIO::ImageSpec(width, height, channels, OIIO::TypeDesc::UINT8)}}),
      row_(static_cast<std::size_t>(width) * static_cast<std::size_t>(channels)) {}
PictureRowWriter::~PictureRowWriter() = default;

void PictureRowWriter::write(std::span<const std::uint8_t> rows) {
  if (rows.size() % row_ != 0) throw std::invalid_argument("a picture's rows of another size");
  const int end = next_row_ + static_cast<int>(rows.size() / row_);
  output_->image.rows(next_row_, end, rows.data());
  next_row_ = end;
}

void PictureRowWriter::finish() {
  if (!std::exchange(finished_, true)) file_.write(output_->image.finish());
}

void PictureRowWriter::commit() {
  finish();
  file_.commit();
}

}  // namespace ptm::golden
