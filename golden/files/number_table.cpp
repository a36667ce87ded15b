#include "golden/files/number_table.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "golden/files/light_line.h"
#include "golden/files/number_text.h"
#include "golden/files/text_lines.h"

namespace ptm::golden {
namespace {

constexpr std::string_view kWide = " \t\f\v;", kAny = " \t\f\v;,";

std::vector<std::string_view> fields_of(std::string_view text, std::string_view separators) {
  std::vector<std::string_view> fields;
  for (;;) {
    const std::size_t first = text.find_first_not_of(separators);
    if (first == std::string_view::npos) return fields;
    text.remove_prefix(first);
    const std::size_t end = std::min(text.find_first_of(separators), text.size());
    fields.push_back(unquoted(text.substr(0, end)));
    text.remove_prefix(end);
  }
}

struct TableLine {
  int number = 0;
  std::string_view text;
};

bool is_remark(std::string_view text) {
  return text.starts_with('#') || text.starts_with('%') || text.starts_with("//");
}

/// Lines that hold anything, without the separators at their ends.
std::vector<TableLine> lines_with_text(const std::vector<std::string>& all) {
  std::vector<TableLine> lines;
  int number = 0;
  for (const std::string& line : all) {
    const std::string_view text = without_separators(line);
    ++number;
    if (!text.empty() && !is_remark(text)) lines.push_back({number, text});
  }
  return lines;
}

/// Whether a field can be a number with a decimal comma; true in `comma` if it has one.
bool fits_decimal_comma(std::string_view field, bool& comma) {
  if (parse_decimal_comma(field)) return comma = true;
  return field.find('.') == std::string_view::npos && parse_real(field).has_value();
}

bool has_decimal_commas(const std::vector<TableLine>& lines, bool one_column) {
  bool comma = false;
  std::size_t width = 0, rows = 0;
  for (const TableLine& line : lines) {
    const auto fields = fields_of(line.text, kWide);
    if (rows == 0 && fields.size() == 1 && parse_integer(fields[0], 0, INT64_MAX)) continue;
    if (rows > 0 && fields.size() != width) return false;
    width = fields.size();
    ++rows;
    for (std::string_view field : fields) {
      if (field.ends_with(',')) field.remove_suffix(1);
      if (!fits_decimal_comma(field, comma)) return false;
    }
  }
  return comma && (width >= 3 || (one_column && (width == 2 || rows > 1)));
}

}  // namespace

NumberTable read_number_table(const std::filesystem::path& path, bool one_column) {
  const std::vector<std::string> text = read_text_lines(path, "a table of lights");
  std::vector<TableLine> lines = lines_with_text(text);
  NumberTable table;
  const auto first = std::find_if(lines.begin(), lines.end(), [&](const TableLine& line) {
    const auto fields = fields_of(line.text, kAny);
    if (!is_column_name(fields[0])) return true;
    table.columns.assign(fields.begin(), fields.end());
    table.notes.push_back("line " + std::to_string(line.number) +
                          " holds the names of columns, passed over");
    return false;
  });
  lines.erase(lines.begin(), first);
  const bool commas = has_decimal_commas(lines, one_column);
  if (commas) table.notes.emplace_back("commas are taken as decimal commas");
  for (const TableLine& line : lines) {
    NumberRow row{line.number, {}};
    for (std::string_view field : fields_of(line.text, commas ? kWide : kAny)) {
      if (field.ends_with(',')) field.remove_suffix(1);
      auto value = parse_real(field);
      if (!value && commas) value = parse_decimal_comma(field);
      if (!value) {
        throw InputError(path.string(), "line " + std::to_string(line.number), quoted(field),
                         "a finite number");
      }
      row.numbers.push_back(*value);
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

std::optional<std::size_t> take_count(NumberTable& table) {
  if (table.rows.size() < 2 || table.rows[0].numbers.size() != 1) return std::nullopt;
  const double count = table.rows[0].numbers[0];
  if (!(count >= 0 && count <= 1e9) || count != std::floor(count)) return std::nullopt;
  table.rows.erase(table.rows.begin());
  return static_cast<std::size_t>(count);
}

}  // namespace ptm::golden
