#pragma once
#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace ptm::golden {

/// A line of a list of lights: a picture's name and three numbers.
struct LightLine {
  std::string name;
  std::array<double, 3> numbers{};
  bool decimal_commas = false;
};

/// Blanks, tabs, semicolons or commas part the fields; the name may hold blanks, and quotes round
/// it are taken off. Numbers have a decimal point, or a comma where commas do not part the fields:
///
///     a.png 0.5 0.2 0.84     a.png, 0.5, 0.2, 0.84     a.png,0.5,0.2,0.84
///     a.png 0,5 0,2 0,84     a.png;0,5;0,2;0,84
///
/// None if the line does not end in three finite numbers with a name before them.
[[nodiscard]] std::optional<LightLine> read_light_line(std::string_view line);

/// A name without quotes round it.
[[nodiscard]] std::string_view unquoted(std::string_view name);

/// The last three fields, parted by blanks and semicolons: for messages.
[[nodiscard]] std::array<std::string_view, 3> last_fields(std::string_view line);

/// Whether a field is the name of a column: a letter first, quotes aside, and not "nan" or "inf",
/// which stand where a number is missing.
[[nodiscard]] bool is_column_name(std::string_view field);

/// Without blanks, commas and semicolons at either end; spreadsheets fill short lines with them.
[[nodiscard]] std::string_view without_separators(std::string_view text);

}  // namespace ptm::golden
