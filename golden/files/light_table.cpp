#include "golden/files/light_table.h"

#include <algorithm>

#include "golden/files/figure_text.h"
#include "golden/files/light_directions.h"
#include "golden/files/number_table.h"
#include "golden/files/number_text.h"
#include "golden/files/picture_folder.h"

namespace ptm::golden {
namespace {

namespace fs = std::filesystem;

/// Which of x, y and z a column's name means; -1 for none of them.
int axis_of(std::string name) {
  for (char& c : name) c = static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  for (const char* before : {"", "l", "d", "light_", "dir_", "pos_"}) {
    for (int axis = 0; axis < 3; ++axis) {
      if (name == std::string(before) + "xyz"[axis]) return axis;
    }
  }
  return -1;
}

/// Puts the columns that are named x, y and z in this order and drops all others, if all three are
/// there once and the rows are as long as the row of names.
void order_columns(NumberTable& table) {
  std::array<int, 3> column{-1, -1, -1};
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    const int axis = axis_of(table.columns[i]);
    if (axis < 0) continue;
    int& place = column[static_cast<std::size_t>(axis)];
    if (place >= 0) return;
    place = static_cast<int>(i);
  }
  if (*std::min_element(column.begin(), column.end()) < 0) return;
  for (NumberRow& row : table.rows) {
    if (row.numbers.size() != table.columns.size()) continue;
    std::vector<double> ordered;
    for (const int from : column) ordered.push_back(row.numbers[static_cast<std::size_t>(from)]);
    row.numbers = std::move(ordered);
  }
}

/// One light a row, whichever way the table lies.
std::vector<NumberRow> lights_of(std::vector<NumberRow> rows, const std::string& table,
                                 std::vector<std::string>& notes) {
  const bool across = rows.size() == 3 && rows[0].numbers.size() != 3;
  const std::size_t columns = across ? rows[0].numbers.size() : 3;
  for (const NumberRow& row : rows) {
    if (row.numbers.size() == columns) continue;
    throw InputError(table, "line " + std::to_string(row.line),
                     count_of(row.numbers.size(), "number"), std::to_string(columns));
  }
  if (rows.size() == 3 && columns == 3) {
    notes.emplace_back("a table of 3 x 3 numbers is taken as one light a line");
  }
  if (!across) return rows;
  std::vector<NumberRow> lights(columns);
  for (std::size_t i = 0; i < columns; ++i) {
    lights[i].line = rows[0].line;
    for (const NumberRow& row : rows) lights[i].numbers.push_back(row.numbers[i]);
  }
  return lights;
}

/// The count rules, as in a .lp file.
template <class Light>
void keep_counted(std::optional<std::size_t> count, std::vector<Light>& lights,
                  std::vector<std::string>& notes) {
  if (!count || *count == lights.size()) return;
  std::string note = "the first line says " + count_of(*count, "light") + ", the file has " +
                     std::to_string(lights.size());
  if (*count < lights.size()) {
    note += "; what is beyond the count is not read";
    lights.resize(*count);
  }
  notes.push_back(note);
}

std::vector<NumberRow> read_rows(const fs::path& table, std::vector<std::string>& notes) {
  NumberTable read = read_number_table(table, false);
  const auto count = take_count(read);
  order_columns(read);
  notes = std::move(read.notes);
  auto rows = lights_of(std::move(read.rows), table.string(), notes);
  keep_counted(count, rows, notes);
  return rows;
}

}  // namespace

LightPositions read_light_table(const fs::path& table, const fs::path& folder, bool positions) {
  LightPositions result;
  const std::vector<NumberRow> rows = read_rows(table, result.notes);
  const std::vector<fs::path> pictures = pictures_of(folder, rows.size(), "the table");
  LightDirections directions;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    LitPicture lit;
    lit.picture = pictures[i];
    std::copy_n(rows[i].numbers.begin(), 3, lit.direction.begin());
    lit.position = lit.direction;
    lit.line = rows[i].line;
    const std::string place =
        "light " + std::to_string(i + 1) + " (line " + std::to_string(rows[i].line) + ")";
    if (directions.take(lit.direction, table.string(), place, result.notes)) {
      result.pictures.push_back(std::move(lit));
    }
  }
  if (!positions) directions.finish(result.notes);
  if (result.pictures.empty()) {
    throw InputError(table.string(), "file", "no light above the horizon",
                     "3 lines of numbers, or lines of 3");
  }
  return result;
}

LightPositions read_parameter_table(const fs::path& table, const fs::path& folder) {
  LightPositions result;
  NumberTable read = read_number_table(table, true);
  result.notes = std::move(read.notes);
  // A first number that counts all others is none of them, unless there is a picture for it.
  std::size_t all = 0;
  for (const NumberRow& row : read.rows) all += row.numbers.size();
  if (all > 1 && read.rows[0].numbers[0] == static_cast<double>(all - 1) &&
      count_pictures(folder) + 1 == all) {
    (void)take_count(read);
  }
  for (const NumberRow& row : read.rows) {
    if (read.rows.size() > 1 && row.numbers.size() != 1) {
      throw InputError(table.string(), "line " + std::to_string(row.line),
                       count_of(row.numbers.size(), "number"), "one number a line");
    }
    for (const double u : row.numbers) result.pictures.push_back({{}, {u, 0, 0}, row.line, {}});
  }
  if (result.pictures.empty()) {
    throw InputError(table.string(), "file", "no number", "one number for each picture");
  }
  const std::vector<fs::path> pictures = pictures_of(folder, result.pictures.size(), "the table");
  const auto by_u = [](const LitPicture& a, const LitPicture& b) {
    return a.direction[0] < b.direction[0];
  };
  const auto ends = std::minmax_element(result.pictures.begin(), result.pictures.end(), by_u);
  const double low = ends.first->direction[0], high = ends.second->direction[0];
  const bool stretch = low < -1 || high > 1;
  if (stretch) {
    result.notes.push_back("numbers from " + format_real(low) + " to " + format_real(high) +
                           " moved to -1..1");
  }
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    LitPicture& lit = result.pictures[i];
    lit.picture = pictures[i];
    double& u = lit.direction[0];
    if (stretch) u = high > low ? (u / 2 - low / 2) / (high / 2 - low / 2) * 2 - 1 : 0;
  }
  return result;
}

}  // namespace ptm::golden
