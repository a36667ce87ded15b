#include "contract/generator/emit_registers.h"
#include "contract/generator/names.h"
#include "contract/generator/text.h"

namespace ptm::contract {
namespace {

std::string row(const Formats& formats, const Format& format) {
  std::vector<std::string> words;
  for (const Word& word : format.words) {
    words.push_back("FormatWord{WordKind::" + word.kind + ", " + std::to_string(word.field) + "}");
  }
  (void)formats;
  return "    FormatRow{\"" + format.name + "\", " + std::to_string(format.words.size()) + ", {" +
         joined(words) + "}, " + std::to_string(format.polynomials) + ", " +
         std::to_string(format.passes) + ", " + std::to_string(format.multiplies) +
         ", PaletteKind::" + (format.palette.empty() ? "none" : format.palette) + ", " +
         (format.alpha ? "true" : "false") + "},";
}

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
  out.line("/// What a word of 32 bits holds, and how many fields come of it.");
  out.line("enum class WordKind : std::uint8_t {").list("  ", kinds, "").line("};");
  out.line("inline constexpr std::array<unsigned, " + std::to_string(kinds.size()) +
           "> kWordFields{" + joined(fields) + "};");
  out.line("enum class PaletteKind : std::uint8_t { none, lrgb, rgb };").line();
  out.line("struct FormatWord {\n  WordKind kind = WordKind::coefficients;");
  out.line("  unsigned field = 0;  ///< the first that comes of it\n};").line();
  out.line("inline constexpr std::size_t kFormatWordsMax = " + std::to_string(formats.words_max()) +
           ";");
  out.line("struct FormatRow {\n  std::string_view name;");
  out.line("  int planes = 0;");
  out.line("  std::array<FormatWord, kFormatWordsMax> word{};  ///< a plane each");
  out.line("  int polynomials = 0;                             ///< of a texel");
  out.line("  int passes = 1;                                  ///< of the evaluator");
  out.line("  unsigned multiplies = 0;                         ///< of the evaluator");
  out.line("  PaletteKind palette = PaletteKind::none;         ///< whose index word 0 holds");
  out.line("  bool alpha = false;                              ///< a word holds the map's alpha");
  out.line("};").line();
  out.line(
      "/// By code; codes of no meaning, which the register's three bits may hold, have no "
      "planes.");
  out.line("inline constexpr std::array<FormatRow, 8> kFormats{{");
  for (const Format& format : formats.formats) out.line(row(formats, format));
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

void package(const Formats& formats, Outputs& outputs) {
  Text out;
  out.line("// Written by scripts/contract from contract/formats.toml.").line("//");
  out.line(
      "// What a texel format has: docs/spec/unit.md, Draw descriptor. Combinational functions.");
  out.line("package ptm_format_pkg;");
  out.line("  localparam int WordsMax = " + std::to_string(formats.words_max()) +
           ";  // of a format")
      .line();
  function(
      out, "logic [2:0]", "planes", "Planes of the map's own words", formats,
      [](const Formats&, const Format& f) { return "3'd" + std::to_string(f.words.size()); },
      "3'd0");
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
  function(
      out, "logic [5*WordsMax-1:0]", "word_fields",
      "Fields of a filtered fragment that come of each word, five bits a word, word 0 lowest",
      formats,
      [](const Formats& all, const Format& f) {
        std::vector<std::string> parts;
        for (std::size_t w = all.words_max(); w-- > 0;) {
          parts.push_back(
              "5'd" + std::to_string(w < f.words.size() ? all.kind(f.words[w].kind).fields : 0));
        }
        return "{" + joined(parts) + "}";
      },
      "'0");
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
    const std::size_t last = formats.formats.back().words.size();
    out.line("  case (format)");
    for (const Format& format : formats.formats) {
      if (format.words.size() == last) continue;
      out.line("    ptm_unit_pkg::Format" + camel(format.name) + ": " + name + " = " +
               value(format.words.size()) + ";");
    }
    out.line("    default: " + name + " = " + value(last) + ";");
    out.line("  endcase").line("endfunction");
  };
  out.line("// The beat brings the colour texture on TMU t: the word behind the map's planes");
  out.line("function automatic logic brings_color(input logic [2:0] format,");
  out.line(
      "                                      input logic [GroupBits-1:0] group, input int t);");
  cases("brings_color",
        [](std::size_t planes) { return "brings(group, " + std::to_string(planes) + ", t)"; });
  out.line("// The beat brings word j of the sets' on TMU t: they lie behind the colour texture");
  out.line("function automatic logic brings_set(input logic [2:0] format, input logic color,");
  out.line("                                    input logic [GroupBits-1:0] group, input int j,");
  out.line("                                    input int t);");
  cases("brings_set", [](std::size_t planes) {
    return "color ? brings(group, " + std::to_string(planes + 1) +
           " + j, t)\n        : brings(group, " + std::to_string(planes) + " + j, t)";
  });
  outputs.push_back({Output::Kind::committed, "rtl/contract/ptm_format_words.svh", out.str(), {}});
}

void page(const Formats& formats, Outputs& outputs) {
  Text out;
  out.line("| code | format | planes | words | passes | multiplies |")
      .line("|---|---|---|---|---|---|");
  for (std::size_t n = 0; n < formats.formats.size(); ++n) {
    const Format& f = formats.formats[n];
    out.line("| " + std::to_string(n) + " | " + f.title + " | " + std::to_string(f.words.size()) +
             " | " + (f.layout.empty() ? f.meaning : f.layout) + " | " + std::to_string(f.passes) +
             " | " + std::to_string(f.multiplies) + " |");
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
