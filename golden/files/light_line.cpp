#include "golden/files/light_line.h"

#include "golden/files/number_text.h"

namespace ptm::golden {
namespace {

constexpr std::string_view kWide = " \t\f\v;", kAnySeparator = " \t\f\v;,", kCommas = " \t\f\v,";

std::string_view trimmed(std::string_view text, std::string_view off) {
  const std::size_t first = text.find_first_not_of(off);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(off) - first + 1);
}

/// Takes the last field off `text`.
std::string_view pop_field(std::string_view& text, std::string_view separators) {
  const std::size_t at = text.find_last_of(separators);
  const std::string_view field = at == std::string_view::npos ? text : text.substr(at + 1);
  text =
      at == std::string_view::npos ? std::string_view{} : trimmed(text.substr(0, at), separators);
  return field;
}

std::optional<LightLine> split(std::string_view text, std::string_view separators, bool commas) {
  LightLine line;
  for (std::size_t i = 3; i-- > 0;) {
    std::string_view field = pop_field(text, separators);
    if (commas && field.ends_with(',')) field.remove_suffix(1);
    auto value = parse_real(field);
    if (!value && commas) {
      value = parse_decimal_comma(field);
      line.decimal_commas = line.decimal_commas || value.has_value();
    }
    if (!value) return std::nullopt;
    line.numbers[i] = *value;
  }
  line.name = unquoted(without_separators(text));
  if (line.name.empty()) return std::nullopt;
  return line;
}

}  // namespace

std::string_view unquoted(std::string_view name) {
  const bool quotes = name.size() > 2 && name.front() == name.back() &&
                      (name.front() == '"' || name.front() == '\'');
  return quotes ? name.substr(1, name.size() - 2) : name;
}

bool is_column_name(std::string_view field) {
  field = unquoted(field);
  const auto letter = [&](std::size_t at) {
    const char c = at < field.size() ? field[at] : ' ';
    return static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  };
  if (letter(0) < 'a' || letter(0) > 'z') return false;
  const std::string start{letter(0), letter(1), letter(2)};
  return start != "nan" && start != "inf";
}

std::string_view without_separators(std::string_view text) { return trimmed(text, kAnySeparator); }

std::optional<LightLine> read_light_line(std::string_view line) {
  line = without_separators(line);
  auto read = split(line, kWide, true);
  return read ? read : split(line, kCommas, false);
}

std::array<std::string_view, 3> last_fields(std::string_view line) {
  line = without_separators(line);
  std::array<std::string_view, 3> fields;
  for (std::size_t i = 3; i-- > 0;) fields[i] = pop_field(line, kWide);
  return fields;
}

}  // namespace ptm::golden
