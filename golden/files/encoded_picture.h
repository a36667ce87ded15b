#pragma once
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

namespace ptm::golden {

/// An 8-bit picture that OpenImageIO encodes into memory, rows from the top. Its codecs do not say
/// so when a disk is full, and one of them ends the program; so nothing of theirs goes to a disk,
/// and the bytes are written by PendingFile, which looks.
/// Throws InputError about `path`, whose extension chooses the format.
class EncodedPicture {
 public:
  EncodedPicture(std::filesystem::path path, int width, int height, int channels);
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
