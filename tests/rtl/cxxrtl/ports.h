#pragma once
#include <backends/cxxrtl/cxxrtl.h>

#include <cstdint>

/// Fields of CXXRTL's ports, which are kept in pieces of 32 bits.
namespace ptm::tests {

/// Bits [at + width - 1 : at] of a port become the lowest bits of `bits`; width is at most 32.
template <std::size_t Bits>
void set_field(cxxrtl::value<Bits>& port, std::size_t at, std::size_t width, std::uint32_t bits) {
  for (std::size_t n = 0; n < width; ++n) {
    std::uint32_t& piece = port.data[(at + n) / 32];
    const std::uint32_t mask = 1U << ((at + n) % 32);
    piece = ((bits >> n) & 1U) != 0 ? piece | mask : piece & ~mask;
  }
}

template <std::size_t Bits>
[[nodiscard]] std::uint32_t field(const cxxrtl::value<Bits>& port, std::size_t at,
                                  std::size_t width) {
  std::uint32_t bits = 0;
  for (std::size_t n = 0; n < width; ++n) {
    bits |= ((port.data[(at + n) / 32] >> ((at + n) % 32)) & 1U) << n;
  }
  return bits;
}

/// The whole port, whatever its width up to 32 bits.
template <std::size_t Bits>
void set_port(cxxrtl::value<Bits>& port, std::uint32_t bits) {
  set_field(port, 0, Bits, bits);
}
template <std::size_t Bits>
[[nodiscard]] std::uint32_t port_bits(const cxxrtl::value<Bits>& port) {
  return field(port, 0, Bits);
}

}  // namespace ptm::tests
