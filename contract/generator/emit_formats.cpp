#include "contract/generator/emit_registers.h"
#include "contract/generator/names.h"
#include "contract/generator/text.h"

namespace ptm::contract {
namespace {

std::string row(const Format& format) {
  return "    FormatRow{\"" + format.name + "\", " + std::to_string(format.polynomials) + ", " +
         std::to_string(format.passes) + ", " + std::to_string(format.multiplies) +
         ", PaletteKind::" + (format.palette.empty() ? "none" : format.palette) + ", " +
         (format.alpha ? "true" : "false") + "},";
}

/// "FormatWords{3, {...}},"
void words_row(const Format& format, unsigned a_word, Text& out) {
  std::vector<std::string> words;
  for (const Word& word : format.words_of(a_word)) {
    words.push_back("FormatWord{WordKind::" + word.kind + ", " + std::to_string(word.field) + ", " +
                    std::to_string(word.fields) + "}");
  }
  out.line("        FormatWords{" + std::to_string(words.size()) + ", {  // " + format.name);
  if (!words.empty()) out.list("            ", words, "");
  out.line("        }},");
}

constexpr const char* kWordTypes = R"(struct FormatWord {
  WordKind kind = WordKind::coefficients;
  unsigned field = 0;   ///< the first that comes of it
  unsigned fields = 0;  ///< how many come of it
};

/// The map's own words of a texel.
struct FormatWords {
  int planes = 0;
  std::array<FormatWord, kFormatWordsMax> word{};  ///< a plane each
};

struct FormatRow {
  std::string_view name;
  int polynomials = 0;                      ///< of a texel
  int passes = 1;                           ///< of the evaluator
  unsigned multiplies = 0;                  ///< of the evaluator
  PaletteKind palette = PaletteKind::none;  ///< whose index word 0 holds
  bool alpha = false;                       ///< a word holds the map's alpha
};

/// Coefficients that a word of 32 bits holds, F = max(8, coef_bits) bits each: three up to 10 bits,
/// two above.
[[nodiscard]] constexpr int coefficients_a_word(int coef_bits) { return coef_bits > 10 ? 2 : 3; }
)";

void header(const Formats& formats, Outputs& outputs) {
  std::vector<std::string> kinds, fields;
  for (const WordKind& kind : formats.kinds) {
    kinds.push_back(kind.name);
    fields.push_back(std::to_string(kind.fields));
  }
  Text out;
  out.line("// Written by contract/generator from contract/formats.toml.").line("#pragma once");
  out.line("#include <array>").line("#include <cstddef>").line("#include <cstdint>");
  out.line("#include <string_view>").line();
  out.line("/// Texel formats of a map: docs/spec/unit.md, Draw descriptor.");
  out.line("namespace ptm::contract {").line();
  out.line("/// What a word of 32 bits holds, and how many fields come of it at most.");
  out.line("enum class WordKind : std::uint8_t {").list("  ", kinds, "").line("};");
  out.line("inline constexpr std::array<unsigned, " + std::to_string(kinds.size()) +
           "> kWordFields{" + joined(fields) + "};");
  out.line("enum class PaletteKind : std::uint8_t { none, lrgb, rgb };").line();
  out.line("inline constexpr std::size_t kFormatWordsMax = " +
           std::to_string(formats.words_max(kFewestAWord)) + ";");
  out.line(kWordTypes);
  out.line(
      "/// By code; codes of no meaning, which the register's three bits may hold, have no "
      "planes.");
  out.line("inline constexpr std::array<FormatRow, 8> kFormats{{");
  for (const Format& format : formats.formats) out.line(row(format));
  out.line("}};").line();
  out.line("/// By coefficients a word, from two on, and by code.");
  out.line("inline constexpr std::array<std::array<FormatWords, 8>, " +
           std::to_string(kMostAWord - kFewestAWord + 1) + "> kFormatWords{{");
  for (unsigned a_word = kFewestAWord; a_word <= kMostAWord; ++a_word) {
    out.line("    {{");
    for (const Format& format : formats.formats) words_row(format, a_word, out);
    out.line("    }},");
  }
  out.line("}};").line().line("}  // namespace ptm::contract");
  outputs.push_back({Output::Kind::build, "formats.h", out.str(), {}});
}

using Says = std::string (*)(const Formats&, const Format&);

/// A function of the format: a case for each that is not as the last line says.
void function(Text& out, const std::string& type, const std::string& name,
              const std::string& meaning, const Formats& formats, Says says,
              const std::string& otherwise) {
  out.comment("  // ", meaning);
  out.line("  function automatic " + type + " " + name + "(input logic [2:0] format);");
  out.line("    case (format)");
  for (const Format& format : formats.formats) {
    const std::string value = says(formats, format);
    if (value == otherwise) continue;
    out.line("      ptm_register_pkg::Format" + camel(format.name) + ": " + name + " = " + value +
             ";");
  }
  out.line("      default: " + name + " = " + otherwise + ";");
  out.line("    endcase").line("  endfunction").line();
}

std::string bit(bool value) { return value ? "1'b1" : "1'b0"; }

/// A number of words where a word holds two coefficients, and where it holds three.
struct Pair {
  std::size_t two = 0, three = 0;
};

Pair words_of(const Format& format) {
  return {format.words_of(2).size(), format.words_of(3).size()};
}

/// What of it holds where `a_word` coefficients lie in a word.
std::string by_word(const Pair& pair, const std::string& a_word, const std::string& before) {
  const std::string two = before + std::to_string(pair.two);
  const std::string three = before + std::to_string(pair.three);
  return pair.two == pair.three ? three : a_word + " == 3 ? " + three + " : " + two;
}

/// The fields of each word, five bits a word, as a function for each number of coefficients a word.
void word_fields(const Formats& formats, unsigned a_word, Text& out) {
  const std::size_t most = formats.words_max(a_word);
  const std::string name = "word_fields_" + std::to_string(a_word);
  out.comment("  // ",
              "Fields of a filtered fragment that come of each word, five bits a word, word "
              "0 lowest, where a word holds " +
                  std::to_string(a_word) + " coefficients");
  out.line("  function automatic logic [" + std::to_string(5 * most - 1) + ":0] " + name +
           "(input logic [2:0] format);");
  out.line("    case (format)");
  for (const Format& format : formats.formats) {
    std::vector<std::string> parts;
    const std::vector<Word> words = format.words_of(a_word);
    for (std::size_t w = most; w-- > 0;) {
      parts.push_back("5'd" + std::to_string(w < words.size() ? words[w].fields : 0));
    }
    out.line("      ptm_register_pkg::Format" + camel(format.name) + ": " + name + " = {");
    out.list("          ", parts, "};");
  }
  out.line("      default: " + name + " = '0;").line("    endcase").line("  endfunction").line();
}

/// What depends on how many coefficients a word holds: docs/spec/unit.md, Words.
void words(const Formats& formats, Text& out) {
  const Pair most{formats.words_max(2), formats.words_max(3)};
  out.line("  localparam int PlanesBits = 4;  // of a number of planes").line();
  out.line("  // Words of the format that has most, where a word holds AWord coefficients");
  out.line("  function automatic int words_max(input int AWord);");
  out.line("    words_max = " + by_word(most, "AWord", "") + ";").line("  endfunction").line();
  out.line("  // Planes of the map's own words");
  out.line("  function automatic logic [PlanesBits-1:0] planes(input int AWord,");
  out.line("                                                   input logic [2:0] format);");
  out.line("    case (format)");
  for (const Format& format : formats.formats) {
    const Pair number = words_of(format);
    if (number.three == 0) continue;
    out.line("      ptm_register_pkg::Format" + camel(format.name) +
             ": planes = " + by_word(number, "AWord", "4'd") + ";");
  }
  out.line("      default: planes = 4'd0;").line("    endcase").line("  endfunction").line();
  for (unsigned a_word = kMostAWord; a_word >= kFewestAWord; --a_word) {
    word_fields(formats, a_word, out);
  }
}

void package(const Formats& formats, Outputs& outputs) {
  Text out;
  out.line("// Written by scripts/contract from contract/formats.toml.").line("//");
  out.line(
      "// What a texel format has: docs/spec/unit.md, Draw descriptor. Combinational functions.");
  out.line("package ptm_format_pkg;");
  words(formats, out);
  function(
      out, "logic", "three_passes", "The evaluator runs three passes, one a channel, not one",
      formats, [](const Formats&, const Format& f) { return bit(f.passes == 3); }, "1'b0");
  function(
      out, "logic", "one_polynomial", "A texel has one polynomial, of luminance", formats,
      [](const Formats&, const Format& f) { return bit(f.polynomials == 1); }, "1'b0");
  function(
      out, "logic", "indexes_lrgb", "Word 0 holds an index of a palette of LRGB", formats,
      [](const Formats&, const Format& f) { return bit(f.palette == "lrgb"); }, "1'b0");
  function(
      out, "logic", "indexes_rgb", "Word 0 holds an index of the palette of RGB", formats,
      [](const Formats&, const Format& f) { return bit(f.palette == "rgb"); }, "1'b0");
  function(
      out, "logic [4:0]", "eval_multiplies", "Multiplies of the evaluator, a fragment", formats,
      [](const Formats&, const Format& f) { return "5'd" + std::to_string(f.multiplies); }, "5'd0");
  out.line("endpackage");
  outputs.push_back({Output::Kind::committed, "rtl/contract/ptm_format_pkg.sv", out.str(), {}});
}

/// Functions of the filter's modules: a case for each number of planes but the last format's, which
/// stands for codes of no meaning too.
void word_functions(const Formats& formats, Outputs& outputs) {
  Text out;
  out.line("// Written by scripts/contract from contract/formats.toml.");
  out.comment("// ",
              "Words of a draw behind the map's planes, for where ptm_filter_words.svh stands.");
  const auto cases = [&](const std::string& name, const auto& value) {
    const Pair last = words_of(formats.formats.back());
    out.line("  case (format)");
    for (const Format& format : formats.formats) {
      const Pair planes = words_of(format);
      if (planes.three == last.three && planes.two == last.two) continue;
      out.line("    ptm_unit_pkg::Format" + camel(format.name) + ": " + name + " = " +
               value(planes) + ";");
    }
    out.line("    default: " + name + " = " + value(last) + ";");
    out.line("  endcase").line("endfunction");
  };
  out.line("// The beat brings the colour texture on TMU t: the word behind the map's planes");
  out.line("function automatic logic brings_color(input logic [2:0] format,");
  out.line(
      "                                      input logic [GroupBits-1:0] group, input int t);");
  cases("brings_color", [](const Pair& planes) {
    return "brings(group, " + by_word(planes, "AWord", "") + ", t)";
  });
  out.line("// The beat brings word j of the sets' on TMU t: they lie behind the colour texture");
  out.line("function automatic logic brings_set(input logic [2:0] format, input logic color,");
  out.line("                                    input logic [GroupBits-1:0] group, input int j,");
  out.line("                                    input int t);");
  cases("brings_set", [](const Pair& planes) {
    const Pair behind{planes.two + 1, planes.three + 1};
    return "color ? brings(group, j + (" + by_word(behind, "AWord", "") +
           "), t)\n        : brings(group, j + (" + by_word(planes, "AWord", "") + "), t)";
  });
  outputs.push_back({Output::Kind::committed, "rtl/contract/ptm_format_words.svh", out.str(), {}});
}

/// "3 (4)": planes, and in brackets those of two coefficients a word if they are more.
std::string planes_cell(const Format& format) {
  const Pair planes = words_of(format);
  return std::to_string(planes.three) +
         (planes.two == planes.three ? "" : " (" + std::to_string(planes.two) + ")");
}

void page(const Formats& formats, Outputs& outputs) {
  Text out;
  out.line("| code | format | planes | words | passes | multiplies |")
      .line("|---|---|---|---|---|---|");
  for (std::size_t n = 0; n < formats.formats.size(); ++n) {
    const Format& f = formats.formats[n];
    std::string layout = f.layout.empty() ? f.meaning : f.layout;
    if (!f.layout_of_two.empty()) layout += "; above 10 bits " + f.layout_of_two;
    out.line("| " + std::to_string(n) + " | " + f.title + " | " + planes_cell(f) + " | " + layout +
             " | " + std::to_string(f.passes) + " | " + std::to_string(f.multiplies) + " |");
  }
  outputs.push_back({Output::Kind::block, "docs/spec/unit.md", out.str(), "formats"});
}

}  // namespace

void emit_formats(const PortTables& tables, Outputs& outputs) {
  header(tables.formats, outputs);
  package(tables.formats, outputs);
  word_functions(tables.formats, outputs);
  page(tables.formats, outputs);
}

}  // namespace ptm::contract
