#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "contract/generator/registers.h"

/// The table of texel formats, read and checked: contract/formats.toml says what its keys mean.
namespace ptm::contract {

struct WordKind {
  std::string name, meaning, palette;
  unsigned fields = 0;  ///< of a filtered fragment that come of a word
};

/// What a plane's word of a texel holds.
struct Word {
  std::string kind;
  unsigned field = 0;  ///< the first that comes of it
};

struct Format {
  std::string name, title, meaning, layout;
  std::vector<Word> words{};  ///< a plane each
  unsigned polynomials = 0, passes = 1, multiplies = 0;
  bool alpha = false;
  std::string palette{};  ///< of word 0's kind
};

struct Formats {
  std::vector<WordKind> kinds;
  std::vector<Format> formats;  ///< code 0 first
  [[nodiscard]] const WordKind& kind(std::string_view name) const;
  [[nodiscard]] Codes codes() const;
  [[nodiscard]] std::size_t words_max() const;
};

/// Throws TableError.
[[nodiscard]] Formats read_formats(const std::filesystem::path& file);

}  // namespace ptm::contract
