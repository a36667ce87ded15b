#include "testbench/rtl/sealed_file.h"

#include <cerrno>
#include <fstream>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "testbench/rtl/digest.h"

namespace ptm::testbench {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kMark = "\nptmsim digest ";

/// Digest of the first `size` bytes, empty if there are not so many.
std::string digest_of(std::ifstream& file, std::uintmax_t size) {
  Digest digest;
  std::vector<char> chunk(1 << 16);
  while (size > 0) {
    const auto wanted = static_cast<std::streamsize>(std::min<std::uintmax_t>(size, chunk.size()));
    if (!file.read(chunk.data(), wanted)) return {};
    digest.add_part({chunk.data(), static_cast<std::size_t>(wanted)});
    size -= static_cast<std::uintmax_t>(wanted);
  }
  return std::string(kMark) + digest.text();
}

}  // namespace

void seal_file(const fs::path& path) {
  const auto require = [&](bool fine) {
    if (!fine) throw std::system_error(errno, std::generic_category(), path.string());
  };
  std::ifstream file(path, std::ios::binary);
  require(file.is_open());
  const std::string seal = digest_of(file, fs::file_size(path));
  require(!seal.empty());
  std::ofstream out(path, std::ios::binary | std::ios::app);
  out << seal;
  out.close();
  require(!out.fail());
}

bool is_sealed(const fs::path& path) {
  std::error_code error;
  if (!fs::is_regular_file(path, error)) return false;
  const std::uintmax_t size = fs::file_size(path, error);
  const std::size_t seal = kMark.size() + Digest().text().size();
  if (error || size < seal) return false;
  std::ifstream file(path, std::ios::binary);
  const std::string wanted = digest_of(file, size - seal);
  std::string found(seal, '\0');
  file.read(found.data(), static_cast<std::streamsize>(seal));
  return file && found == wanted;
}

}  // namespace ptm::testbench
