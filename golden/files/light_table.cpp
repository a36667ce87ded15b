#include "golden/files/light_table.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cctype>
#include <sstream>
#include <string_view>

#include "golden/files/light_directions.h"
#include "golden/files/number_text.h"
#include "golden/files/whole_file.h"

namespace ptm::golden {
namespace {

namespace fs = std::filesystem;

struct Row {
  int line = 0;
  std::vector<double> numbers;
};

bool is_digit(char c) { return c >= '0' && c <= '9'; }

std::vector<Row> read_rows(const fs::path& table) {
  std::istringstream in(read_text_file(table, "a table of lights"));
  std::vector<Row> rows;
  int number = 0;
  for (std::string line; std::getline(in, line);) {
    Row row{++number, {}};
    constexpr std::string_view parting = " \t\r\f\v,;";
    std::size_t at = line.find_first_not_of(parting);
    if (at == std::string::npos || line[at] == '#') continue;
    while (at != std::string::npos) {
      const std::size_t end = std::min(line.find_first_of(parting, at), line.size());
      const std::string_view field = std::string_view(line).substr(at, end - at);
      const auto value = parse_real(field);
      if (!value) {
        throw InputError(table.string(), "line " + std::to_string(number), quoted(field),
                         "a finite number");
      }
      row.numbers.push_back(*value);
      at = line.find_first_not_of(parting, end);
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

/// Whether OpenImageIO reads files of this extension; its list is "tiff:tif,tiff;jpeg:jpg,...".
bool is_picture_name(const fs::path& path) {
  std::string extension = path.extension().string();
  if (extension.size() < 2 || path.filename().string().front() == '.') return false;
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  extension.front() = ',';
  std::string known = OIIO::get_string_attribute("extension_list");
  std::replace_if(
      known.begin(), known.end(), [](char c) { return c == ':' || c == ';'; }, ',');
  return ("," + known + ",").find(extension + ",") != std::string::npos;
}

std::vector<fs::path> pictures_of(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::path> pictures;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    if (entry.is_regular_file() && is_picture_name(entry.path())) pictures.push_back(entry.path());
  }
  if (error) {
    throw InputError(folder.string(), "folder", error.message(), "a folder of pictures");
  }
  std::sort(pictures.begin(), pictures.end(), [](const fs::path& a, const fs::path& b) {
    return natural_less(a.filename().string(), b.filename().string());
  });
  return pictures;
}

std::vector<fs::path> pictures_of(const fs::path& folder, std::size_t lights) {
  std::vector<fs::path> pictures = pictures_of(folder);
  if (pictures.size() != lights) {
    throw InputError(folder.string(), "folder", std::to_string(pictures.size()) + " pictures",
                     std::to_string(lights) + ", one for each light of the table");
  }
  return pictures;
}

/// One light a row, whichever way the table lies.
std::vector<Row> lights_of(std::vector<Row> rows, const std::string& table,
                           std::vector<std::string>& notes) {
  const bool across = rows.size() == 3 && rows[0].numbers.size() != 3;
  const std::size_t columns = across ? rows[0].numbers.size() : 3;
  for (const Row& row : rows) {
    if (row.numbers.size() == columns) continue;
    throw InputError(table, "line " + std::to_string(row.line),
                     std::to_string(row.numbers.size()) + " numbers", std::to_string(columns));
  }
  if (rows.size() == 3 && columns == 3) {
    notes.emplace_back("a table of 3 x 3 numbers is taken as one light a line");
  }
  if (!across) return rows;
  std::vector<Row> lights(columns);
  for (std::size_t i = 0; i < columns; ++i) {
    lights[i].line = rows[0].line;
    for (const Row& row : rows) lights[i].numbers.push_back(row.numbers[i]);
  }
  return lights;
}

}  // namespace

bool natural_less(const std::string& a, const std::string& b) {
  std::size_t i = 0, k = 0;
  while (i < a.size() && k < b.size()) {
    if (!is_digit(a[i]) || !is_digit(b[k])) {
      if (a[i] != b[k]) return a[i] < b[k];
      ++i, ++k;
      continue;
    }
    while (i < a.size() && a[i] == '0') ++i;
    while (k < b.size() && b[k] == '0') ++k;
    std::size_t m = i, n = k;
    while (m < a.size() && is_digit(a[m])) ++m;
    while (n < b.size() && is_digit(b[n])) ++n;
    if (m - i != n - k) return m - i < n - k;
    const int order = a.compare(i, m - i, b, k, n - k);
    if (order != 0) return order < 0;
    i = m, k = n;
  }
  if ((i < a.size()) != (k < b.size())) return k < b.size();
  return a < b;
}

LightPositions read_light_table(const fs::path& table, const fs::path& folder) {
  LightPositions result;
  const std::vector<Row> rows = lights_of(read_rows(table), table.string(), result.notes);
  const std::vector<fs::path> pictures = pictures_of(folder, rows.size());
  LightDirections directions;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    LitPicture lit{
        pictures[i], {rows[i].numbers[0], rows[i].numbers[1], rows[i].numbers[2]}, rows[i].line};
    const std::string place =
        "light " + std::to_string(i + 1) + " (line " + std::to_string(rows[i].line) + ")";
    if (directions.take(lit.direction, table.string(), place, result.notes)) {
      result.pictures.push_back(std::move(lit));
    }
  }
  directions.finish(result.notes);
  if (result.pictures.empty()) {
    throw InputError(table.string(), "file", "no light above the horizon",
                     "3 lines of numbers, or lines of 3");
  }
  return result;
}

LightPositions read_parameter_table(const fs::path& table, const fs::path& folder) {
  LightPositions result;
  const std::vector<Row> rows = read_rows(table);
  for (const Row& row : rows) {
    if (rows.size() > 1 && row.numbers.size() != 1) {
      throw InputError(table.string(), "line " + std::to_string(row.line),
                       std::to_string(row.numbers.size()) + " numbers", "one number a line");
    }
    for (const double u : row.numbers) result.pictures.push_back({{}, {u, 0, 0}, row.line});
  }
  if (result.pictures.empty()) {
    throw InputError(table.string(), "file", "no number", "one number for each picture");
  }
  const std::vector<fs::path> pictures = pictures_of(folder, result.pictures.size());
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
