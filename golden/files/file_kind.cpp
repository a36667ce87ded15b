#include "golden/files/file_kind.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <limits>
#include <string_view>
#include <vector>

#include "golden/files/number_text.h"
#include "golden/files/relightable_kind.h"
#include "golden/files/whole_file.h"

namespace ptm::golden {
namespace {

using namespace std::string_view_literals;
namespace fs = std::filesystem;

/// A picture's mark at byte `at`.
struct Mark {
  std::size_t at;
  std::string_view bytes;
  const char* format;  ///< OpenImageIO's name
  const char* name;
};
// Formats without a mark (TGA) and those that other files' marks begin with come later.
constexpr std::array<Mark, 36> marks{{
    {0, "\x89PNG\r\n\x1a\n"sv, "png", "PNG"},
    {0, "\xff\xd8\xff"sv, "jpeg", "JPEG"},
    {0, "II*\0"sv, "tiff", "TIFF"},
    {0, "MM\0*"sv, "tiff", "TIFF"},
    {0, "II+\0"sv, "tiff", "TIFF"},
    {0, "MM\0+"sv, "tiff", "TIFF"},
    {0, "\x76\x2f\x31\x01"sv, "openexr", "OpenEXR"},
    {0, "BM"sv, "bmp", "BMP"},
    {0, "GIF87a"sv, "gif", "GIF"},
    {0, "GIF89a"sv, "gif", "GIF"},
    {0, "\0\0\0\x0cjP  "sv, "jpeg2000", "JPEG 2000"},
    {0, "\xff\x4f\xff\x51"sv, "jpeg2000", "JPEG 2000"},
    {8, "WEBP"sv, "webp", "WebP"},
    {4, "ftypheic"sv, "heif", "HEIF"},
    {4, "ftypheix"sv, "heif", "HEIF"},
    {4, "ftypmif1"sv, "heif", "HEIF"},
    {4, "ftypmsf1"sv, "heif", "HEIF"},
    {4, "ftypavif"sv, "heif", "AVIF"},
    {4, "ftypcrx "sv, "", "camera raw"},
    {0, "FUJIFILMCCD-RAW"sv, "", "camera raw"},
    {0, "IIRO"sv, "", "camera raw"},
    {0, "IIRS"sv, "", "camera raw"},
    {0, "IIU\0"sv, "", "camera raw"},
    {0, "FOVb"sv, "", "camera raw"},
    {0, "\0MRM"sv, "", "camera raw"},
    {0, "#?R"sv, "hdr", "Radiance HDR"},
    {0, "SDPX"sv, "dpx", "DPX"},
    {0, "XPDS"sv, "dpx", "DPX"},
    {0, "8BPS"sv, "psd", "PSD"},
    {0, "\x01\xda"sv, "sgi", "SGI"},
    {0, "\x80\x2a\x5f\xd7"sv, "cineon", "Cineon"},
    {0, "DDS "sv, "dds", "DDS"},
    {0, "SIMPLE  ="sv, "fits", "FITS"},
    {0, "\0\0\x01\0"sv, "ico", "ICO"},
    {0, "FOR4"sv, "iff", "IFF"},
    {0, "\x53\x80\xf6\x34"sv, "softimage", "Softimage PIC"},
}};

std::string lower_extension(const fs::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

/// TIFF's mark is also that of many cameras' raw files, which TIFF readers take for their preview.
bool is_raw_name(const fs::path& path) {
  constexpr std::array<std::string_view, 18> extensions{
      ".dng", ".cr2", ".nef", ".nrw", ".arw", ".srf", ".sr2", ".pef", ".3fr",
      ".erf", ".dcr", ".kdc", ".mos", ".mef", ".iiq", ".srw", ".rwl", ".fff"};
  const std::string own = lower_extension(path);
  return std::find(extensions.begin(), extensions.end(), own) != extensions.end();
}

/// Two letters are no mark: the second header's size must be one that BMP has.
bool is_bmp(std::string_view head) {
  constexpr std::string_view sizes = "\x0c\x10\x28\x34\x38\x40\x6c\x7c";
  return head.size() > 17 && sizes.find(head[14]) != std::string_view::npos &&
         head.substr(15, 3) == "\0\0\0"sv;
}

/// P1 to P6, PF or Pf, and a blank.
bool is_pnm(std::string_view head) {
  return head.size() > 2 && head[0] == 'P' &&
         "123456Ff"sv.find(head[1]) != std::string_view::npos &&
         std::isspace(static_cast<unsigned char>(head[2])) != 0;
}

/// A TGA's header: a colour map or none, a known image type, a size, and a known pixel depth. It
/// has no mark, so its extension must say it too.
bool is_tga(std::string_view head, const fs::path& path) {
  const std::string extension = lower_extension(path);
  if (head.size() < 18 || (extension != ".tga" && extension != ".tpic")) return false;
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(head[i]); };
  const bool type = "\x01\x02\x03\x09\x0a\x0b"sv.find(head[2]) != std::string_view::npos;
  const bool depth = "\x01\x08\x0f\x10\x18\x20"sv.find(head[16]) != std::string_view::npos;
  return byte(1) <= 1 && type && depth && (byte(12) | byte(13)) != 0 && (byte(14) | byte(15)) != 0;
}

std::int64_t number(std::string_view head, std::size_t at, std::size_t bytes, bool big_end) {
  std::int64_t value = 0;
  for (std::size_t i = 0; i < bytes; ++i) {
    const std::size_t place = at + (big_end ? i : bytes - 1 - i);
    value = value * 256 + (place < head.size() ? static_cast<unsigned char>(head[place]) : 0);
  }
  return value;
}

std::optional<std::pair<std::int64_t, std::int64_t>> stated_size(std::string_view head,
                                                                 std::string_view format) {
  if (format == "gif") return {{number(head, 6, 2, false), number(head, 8, 2, false)}};
  if (format == "jpeg2000") {
    // ISO/IEC 15444-1, A.5.1: after SOC and the marker SIZ come its length, capabilities, and
    // the reference grid's size; the image begins at an offset in it.
    const std::size_t at = head.find("\xff\x4f\xff\x51"sv);
    if (at == std::string_view::npos) return std::nullopt;
    return {{number(head, at + 8, 4, true) - number(head, at + 16, 4, true),
             number(head, at + 12, 4, true) - number(head, at + 20, 4, true)}};
  }
  if (format == "webp" && head.substr(12, 4) == "VP8X") {
    return {{number(head, 24, 3, false) + 1, number(head, 27, 3, false) + 1}};
  }
  return std::nullopt;
}

FileKind picture(std::string_view head, const fs::path& path, const std::string& format,
                 const std::string& name) {
  FileKind kind{FileType::picture, "a picture (" + name + ")", format, stated_size(head, format)};
  if (format == "tiff" && is_raw_name(path)) {
    kind.format.clear();
    kind.name = "a picture (camera raw)";
  }
  return kind;
}

std::optional<FileKind> picture_kind(std::string_view head, const fs::path& path) {
  for (const Mark& mark : marks) {
    if (head.size() < mark.at || head.substr(mark.at, mark.bytes.size()) != mark.bytes) continue;
    if (mark.at == 8 && !head.starts_with("RIFF")) continue;
    if (mark.bytes == "BM" && !is_bmp(head)) continue;
    return picture(head, path, mark.format, mark.name);
  }
  if (is_pnm(head)) return picture(head, path, "pnm", "PNM");
  if (is_tga(head, path)) return picture(head, path, "targa", "TGA");
  return std::nullopt;
}

std::vector<std::string_view> words_of(std::string_view line) {
  constexpr std::string_view blanks = " \t\r\f\v";
  std::vector<std::string_view> words;
  for (std::size_t at = line.find_first_not_of(blanks); at != std::string_view::npos;) {
    const std::size_t end = std::min(line.find_first_of(blanks, at), line.size());
    words.push_back(line.substr(at, end - at));
    at = line.find_first_not_of(blanks, end);
  }
  return words;
}

bool is_text(std::string_view head) {
  constexpr std::string_view odd = "\0\x01\x02\x03\x04\x05\x06\x07"sv;
  return !head.empty() && head.find_first_of(odd) == std::string_view::npos;
}

FileKind scene() { return {FileType::scene, "a scene (TOML)", {}, {}}; }
FileKind lights() { return {FileType::light_positions, "a list of light positions (.lp)", {}, {}}; }
FileKind mesh() { return {FileType::mesh, "a mesh (Wavefront OBJ)", {}, {}}; }

/// Text of the project's own kinds, by its name. It comes before the marks: a list of lights may
/// begin with a photograph's name "BM1.jpg".
std::optional<FileKind> named_text(std::string_view head, const fs::path& path) {
  if (!is_text(head)) return std::nullopt;
  const std::string extension = lower_extension(path);
  if (extension == ".toml") return scene();
  if (extension == ".lp") return lights();
  if (extension == ".obj") return mesh();
  return std::nullopt;
}

/// The same by the lines that only they have.
std::optional<FileKind> text_of_lines(std::string_view head) {
  if (!is_text(head)) return std::nullopt;
  for (std::size_t at = 0; at < head.size();) {
    const std::size_t end = std::min(head.find('\n', at), head.size());
    const auto words = words_of(head.substr(at, end - at));
    at = end + 1;
    if (words.empty()) continue;
    constexpr std::array<std::string_view, 7> tables{
        "[map]", "[[light]]", "[[object]]", "[[texture]]", "[camera]", "[image]", "[hardware]"};
    if (std::find(tables.begin(), tables.end(), words[0]) != tables.end()) return scene();
    const auto real = [&](std::size_t i) { return parse_real(words[i]).has_value(); };
    if (words.size() >= 4 && real(1) && real(2) && real(3)) {
      if (words[0] == "v" || words[0] == "vn") return mesh();
      if (words.size() == 4 && !real(0)) return lights();
    }
  }
  return std::nullopt;
}

std::string described_beginning(std::string_view head) {
  if (head.empty()) return "an empty file";
  if (head.find_first_not_of('\0') == std::string_view::npos)
    return "a file that begins with zero bytes";
  return "a file that begins with " + quoted(head.substr(0, 8));
}

}  // namespace

FileKind file_kind(std::span<const std::uint8_t> head, const fs::path& path) {
  const std::string_view bytes(reinterpret_cast<const char*>(head.data()), head.size());
  if (bytes.starts_with("PTM_")) return {FileType::map, "a polynomial texture map (.ptm)", {}, {}};
  if (const auto kind = named_text(bytes, path)) return *kind;
  if (const auto name = relightable_kind(bytes, lower_extension(path))) {
    return {FileType::other, *name, {}, {}};
  }
  if (const auto kind = picture_kind(bytes, path)) return *kind;
  if (const auto kind = text_of_lines(bytes)) return *kind;
  return {FileType::unknown, described_beginning(bytes), {}, {}};
}

FileKind read_file_kind(const fs::path& path, const std::string& what) {
  constexpr std::uintmax_t any_size = std::numeric_limits<std::uintmax_t>::max();
  return file_kind(read_file_head(path, what, {}, kKindBytes, any_size), path);
}

std::string picture_formats() {
  std::string names;
  std::string_view last;
  for (const Mark& mark : marks) {
    if (mark.name == last || mark.format[0] == '\0') continue;
    last = mark.name;
    names += names.empty() ? "" : ", ";
    names += mark.name;
  }
  return names + ", PNM, TGA or camera raw";
}

}  // namespace ptm::golden
