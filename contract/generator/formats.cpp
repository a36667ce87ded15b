#include "contract/generator/formats.h"

#include <algorithm>
#include <stdexcept>

#include "contract/generator/table.h"

namespace ptm::contract {
namespace {

constexpr std::size_t kCodes = 8;    ///< the register has three bits
constexpr unsigned kMapFields = 22;  ///< of a filtered fragment: coefficients, colour and alpha
constexpr std::size_t kWords = 6;    ///< a map's planes, nine at most of two coefficients each:
                                     ///< four bits of the RTL count them

WordKind read_kind(const Row& row) {
  row.only({"name", "fields", "palette", "meaning"});
  WordKind kind{row.text("name"), row.text("meaning"), row.text_or("palette", "")};
  const std::int64_t fields = row.integer("fields");
  if (fields < 1 || fields > 18) {
    row.fail("fields", "found " + std::to_string(fields) + ", expected 1 to 18");
  }
  if (kind.name == kCoefficients && fields != kMostAWord) {
    row.fail("fields", "found " + std::to_string(fields) + ", expected 3 coefficients");
  }
  if (!kind.palette.empty() && kind.palette != "lrgb" && kind.palette != "rgb") {
    row.fail("palette", "found '" + kind.palette + "', expected lrgb or rgb");
  }
  kind.fields = static_cast<unsigned>(fields);
  return kind;
}

unsigned number(const Row& row, std::string_view key, std::int64_t most) {
  const std::int64_t value = row.integer(key);
  if (value < 0 || value > most) {
    row.fail(key, "found " + std::to_string(value) + ", expected 0 to " + std::to_string(most));
  }
  return static_cast<unsigned>(value);
}

Word read_word(const Row& row, const Formats& formats) {
  row.only({"kind", "field"});
  Word word{row.text("kind"), number(row, "field", kMapFields - 1)};
  const auto is = [&word](const WordKind& kind) { return kind.name == word.kind; };
  const auto kind = std::find_if(formats.kinds.begin(), formats.kinds.end(), is);
  if (kind == formats.kinds.end()) row.fail("kind", "found '" + word.kind + "', no [[kind]]");
  if (kind->palette.empty() && word.field + kind->fields > kMapFields) {
    row.fail("field", "the word's fields end beyond " + std::to_string(kMapFields - 1));
  }
  word.fields = kind->fields;
  return word;
}

Format read_format(const Row& row, const Formats& formats) {
  row.only({"name", "title", "meaning", "layout", "layout_of_two", "words", "polynomials", "passes",
            "multiplies", "alpha"});
  Format format{row.text("name"), row.text("title"), row.text("meaning"), row.text_or("layout", ""),
                row.text_or("layout_of_two", "")};
  for (const Format& other : formats.formats) {
    if (other.name == format.name) row.fail("name", "found '" + format.name + "' a second time");
  }
  for (const Row& word : row.rows("words")) format.words.push_back(read_word(word, formats));
  if (format.words.size() > kWords) {
    row.fail("words", "found " + std::to_string(format.words.size()) + ", expected at most 6");
  }
  for (std::size_t w = 0; w < format.words.size(); ++w) {
    const std::string& palette = formats.kind(format.words[w].kind).palette;
    if (w == 0) format.palette = palette;
    if (w != 0 && !palette.empty()) row.fail("words", "an index lies in the first word alone");
  }
  format.polynomials = number(row, "polynomials", 3);
  format.passes = number(row, "passes", 3);
  if (format.passes != 1 && format.passes != 3) {
    row.fail("passes", "found " + std::to_string(format.passes) + ", expected 1 or 3");
  }
  format.multiplies = number(row, "multiplies", 31);
  format.alpha = row.flag_or("alpha", false);
  return format;
}

}  // namespace

const WordKind& Formats::kind(std::string_view name) const {
  for (const WordKind& one : kinds) {
    if (one.name == name) return one;
  }
  throw std::out_of_range("no kind of word " + std::string(name));
}

Codes Formats::codes() const {
  Codes codes{"format", "format of a map's texels", {}};
  for (const Format& format : formats) codes.names.push_back(format.name);
  return codes;
}

std::vector<Word> Format::words_of(unsigned coefficients_a_word) const {
  std::vector<Word> out;
  for (std::size_t w = 0; w < words.size();) {
    if (words[w].kind != kCoefficients) {
      out.push_back(words[w++]);
      continue;
    }
    unsigned field = words[w].field, past = field;
    while (w < words.size() && words[w].kind == kCoefficients && words[w].field == past) {
      past += words[w++].fields;
    }
    for (; field < past; field += coefficients_a_word) {
      out.push_back(
          {std::string(kCoefficients), field, std::min(coefficients_a_word, past - field)});
    }
  }
  return out;
}

std::size_t Formats::words_max(unsigned coefficients_a_word) const {
  std::size_t most = 1;
  for (const Format& format : formats) {
    most = std::max(most, format.words_of(coefficients_a_word).size());
  }
  return most;
}

Formats read_formats(const std::filesystem::path& path) {
  const TableFile file(path);
  file.only({"kind", "format"});
  Formats all;
  for (const Row& row : file.rows("kind")) all.kinds.push_back(read_kind(row));
  for (const Row& row : file.rows("format")) {
    if (all.formats.size() == kCodes)
      row.fail("name", "a ninth format: the register has three bits");
    all.formats.push_back(read_format(row, all));
  }
  if (all.formats.empty() || !all.formats[0].words.empty()) {
    throw TableError(path.filename().string() + ": the first format has words, expected none");
  }
  return all;
}

}  // namespace ptm::contract
