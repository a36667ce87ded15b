#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "golden/files/input_error.h"

namespace ptm::golden {

struct NumberRow {
  int line = 0;  ///< in the file, from 1
  std::vector<double> numbers;
};

/// A text file of rows of numbers, as programs and spreadsheets write them.
struct NumberTable {
  std::vector<NumberRow> rows;
  std::vector<std::string> columns;  ///< names of the last row of names before the numbers, if any
  std::vector<std::string> notes;    ///< what was passed over or might have been meant otherwise
};

/// Blanks, tabs, semicolons and commas part numbers; quotes round a field are taken off. Blank
/// lines and lines that begin with #, % or // are passed over, and with a note, rows of names
/// before the first number.
///
/// A comma is a decimal one, and parts nothing, where the table holds no decimal point, every comma
/// stands alone between two digits, and blanks or semicolons alone part the rows into as many
/// fields each, three or more; or, with `one_column`, one field each in two rows or more. A note
/// says so. A first row of one whole number, a count, is not looked at for that.
/// Throws InputError as read_text_lines() does, and with the line for a field that is no number.
[[nodiscard]] NumberTable read_number_table(const std::filesystem::path& path, bool one_column);

/// Takes a first row that holds nothing but a whole number off the table, if other rows follow: it
/// counts them.
[[nodiscard]] std::optional<std::size_t> take_count(NumberTable& table);

}  // namespace ptm::golden
