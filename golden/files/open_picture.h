#pragma once
#include <OpenImageIO/imageio.h>

#include <filesystem>
#include <memory>
#include <string>

namespace ptm::golden {

inline constexpr const char* kAPicture = "a picture that OpenImageIO reads";

/// Opens a picture. Its first bytes must be those of a format that is read (file_kind.h), and its
/// size is checked before anything is decoded: at most 2^28 pixels, and no more than the file can
/// hold. Alpha is not multiplied in.
/// Throws InputError.
[[nodiscard]] std::unique_ptr<OIIO::ImageInput> open_picture(const std::filesystem::path& path);

/// Throws InputError about a picture; an empty `found` and line ends in it are mended.
[[noreturn]] void fail_picture(const std::filesystem::path& path, const std::string& place,
                               std::string found, const std::string& expected);

}  // namespace ptm::golden
