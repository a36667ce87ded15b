#pragma once
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

namespace ptm::golden {

/// Whether the name's extension is that of a format in which pictures are written.
[[nodiscard]] bool is_picture_extension(const std::filesystem::path& path);

/// Throws InputError about the output unless is_picture_extension().
void check_picture_name(const std::filesystem::path& path);

/// An 8-bit picture that OpenImageIO encodes into memory, rows from the top. Some of its codecs do
/// not report a write that failed, and libjpeg ends the program then. So no codec writes to a
/// disk: PendingFile writes the bytes and checks every write.
/// Throws InputError about `path`, whose extension chooses the format; nothing is written to it.
class EncodedPicture {
 public:
  EncodedPicture(std::filesystem::path path, const OIIO::ImageSpec& spec);
  ~EncodedPicture();
  EncodedPicture(const EncodedPicture&) = delete;
  EncodedPicture& operator=(const EncodedPicture&) = delete;

  /// Rows `first` to `end` - 1, in order.
  void rows(int first, int end, const std::uint8_t* samples);
  /// The whole file; no call may follow.
  [[nodiscard]] std::vector<std::uint8_t> finish();

 private:
  [[noreturn]] void fail() const;

  std::filesystem::path path_;
  OIIO::Filesystem::IOVecOutput memory_;  ///< for codecs that write where they are told
  int descriptor_ = -1;                   ///< a file in memory for the others
  std::unique_ptr<OIIO::ImageOutput> output_;
};

}  // namespace ptm::golden
