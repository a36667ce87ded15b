#pragma once
#include <array>
#include <cstdint>
#include <iomanip>
#include <sstream>
#include <string>
#include <string_view>

namespace ptm::testbench {

/// FNV-1a of 64 bits, twice from different beginnings: for names and against damage, not a defence.
/// Each step is a bijection of the state, so that one changed byte always changes the digest.
class Digest {
 public:
  /// A part of a string of bytes; the digest does not depend on how it is cut.
  void add_part(std::string_view bytes) {
    for (const char byte : bytes) step(static_cast<unsigned char>(byte));
  }
  /// A whole one, told from the next.
  void add(std::string_view bytes) {
    add_part(bytes);
    step(0x100U);
  }
  [[nodiscard]] std::string text() const {
    std::ostringstream out;
    out << std::hex << std::setfill('0');
    for (const std::uint64_t half : half_) out << std::setw(16) << half;
    return out.str();
  }

 private:
  void step(std::uint64_t symbol) {
    for (std::uint64_t& half : half_) half = (half ^ symbol) * 0x100000001b3U;
  }

  std::array<std::uint64_t, 2> half_{0xcbf29ce484222325U, 0x84222325cbf29ce4U};
};

}  // namespace ptm::testbench
