#include "golden/files/picture_row_writer.h"

#include <stdexcept>

#include "golden/files/open_picture.h"

namespace ptm::golden {
namespace {

constexpr const char* kWritable = "a picture that can be written";

}  // namespace

struct PictureRowWriter::Output {
  std::unique_ptr<OIIO::ImageOutput> image;
};

PictureRowWriter::PictureRowWriter(const std::filesystem::path& path, int width, int height,
                                   int channels)
    : path_(path),
      file_(path),
      output_(std::make_unique<Output>()),
      row_(static_cast<std::size_t>(width) * static_cast<std::size_t>(channels)) {
  const std::string name = file_.path().string();
  output_->image = OIIO::ImageOutput::create(name);
  if (!output_->image) {
    fail_picture(path, "output", OIIO::geterror(), "an extension of a picture format");
  }
  if (!output_->image->open(name,
                            OIIO::ImageSpec(width, height, channels, OIIO::TypeDesc::UINT8))) {
    fail_picture(path, "output", output_->image->geterror(), kWritable);
  }
}
PictureRowWriter::~PictureRowWriter() = default;

void PictureRowWriter::write(std::span<const std::uint8_t> rows) {
  if (rows.size() % row_ != 0) throw std::invalid_argument("a picture's rows of another size");
  const int end = next_row_ + static_cast<int>(rows.size() / row_);
  if (!output_->image->write_scanlines(next_row_, end, 0, OIIO::TypeDesc::UINT8, rows.data())) {
    fail_picture(path_, "output", output_->image->geterror(), kWritable);
  }
  next_row_ = end;
}

void PictureRowWriter::commit() {
  if (!output_->image->close()) {
    fail_picture(path_, "output", output_->image->geterror(), kWritable);
  }
  file_.commit();
}

}  // namespace ptm::golden
