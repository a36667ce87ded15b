#include "contract/generator/names.h"

#include <array>
#include <cctype>

namespace ptm::contract {
namespace {

char large(char letter) {
  return static_cast<char>(std::toupper(static_cast<unsigned char>(letter)));
}

}  // namespace

std::string camel(std::string_view name) {
  std::string out;
  bool begins = true;
  for (const char letter : name) {
    if (letter != '_') out += begins ? large(letter) : letter;
    begins = letter == '_';
  }
  return out;
}

std::string upper(std::string_view name) {
  std::string out(name);
  for (char& letter : out) letter = large(letter);
  return out;
}

std::string hex(std::uint64_t value, int digits) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string out;
  while (value != 0 || static_cast<int>(out.size()) < digits) {
    out.insert(out.begin(), kDigits[value & 15U]);
    value >>= 4U;
  }
  return "0x" + out;
}

unsigned bits_for(std::uint64_t count) {
  unsigned bits = 1;
  while (std::uint64_t{1} << bits < count) ++bits;
  return bits;
}

std::string bit_range(unsigned low, unsigned width) {
  if (width == 1) return "[" + std::to_string(low) + "]";
  return "[" + std::to_string(low + width - 1) + ":" + std::to_string(low) + "]";
}

}  // namespace ptm::contract
