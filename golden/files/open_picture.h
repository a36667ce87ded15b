#pragma once
#include <OpenImageIO/imageio.h>

#include <filesystem>
#include <memory>
#include <string>

namespace ptm::golden {

inline constexpr const char* kAPicture = "a picture that OpenImageIO reads";

/// Opens a picture and checks its size before anything is allocated. Alpha is not multiplied in.
/// Throws InputError.
[[nodiscard]] std::unique_ptr<OIIO::ImageInput> open_picture(const std::filesystem::path& path);

/// Throws InputError about a picture; an empty `found` and line ends in it are mended.
[[noreturn]] void fail_picture(const std::filesystem::path& path, const std::string& place,
                               std::string found, const std::string& expected);

}  // namespace ptm::golden
