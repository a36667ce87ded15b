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
  unsigned field = 0;   ///< the first that comes of it
  unsigned fields = 0;  ///< how many come of it
};

/// The kind of word of coefficients, and how many of them a word holds: three, or two where they
/// are wider than 10 bits. The table has the words of three.
inline constexpr std::string_view kCoefficients = "coefficients";
inline constexpr unsigned kFewestAWord = 2, kMostAWord = 3;

struct Format {
  std::string name, title, meaning, layout;
  std::string layout_of_two{};  ///< where a word holds two coefficients, if that differs
  std::vector<Word> words{};    ///< a plane each, of three coefficients a word
  unsigned polynomials = 0, passes = 1, multiplies = 0;
  bool alpha = false;
  std::string palette{};  ///< of word 0's kind

  /// A plane each, where a word holds so many coefficients: those of words one behind the other are
  /// dealt out anew, in order; other words stay as they are.
  [[nodiscard]] std::vector<Word> words_of(unsigned coefficients_a_word) const;
};

struct Formats {
  std::vector<WordKind> kinds;
  std::vector<Format> formats;  ///< code 0 first
  [[nodiscard]] const WordKind& kind(std::string_view name) const;
  [[nodiscard]] Codes codes() const;
  /// Words of the format that has most.
  [[nodiscard]] std::size_t words_max(unsigned coefficients_a_word) const;
};

/// Throws TableError.
[[nodiscard]] Formats read_formats(const std::filesystem::path& file);

}  // namespace ptm::contract
