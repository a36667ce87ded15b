#pragma once
#include <string>
#include <vector>

/// Sections and tables of the report's page, each appended to `page`.
namespace ptm::testbench::html {

using Row = std::vector<std::string>;  ///< head of the row, then its cells, all HTML

void open_section(std::string& page, const std::string& id, const std::string& title);
/// Wide tables scroll in a box of their own, which the keyboard reaches; the page never does.
/// The caption is also the box's name, so it holds no tags.
void open_table(std::string& page, const std::string& kind, const std::string& caption,
                const Row& heads);
/// `kind`, the row's class, may be empty.
void add_row(std::string& page, const std::string& kind, const Row& row);
void close_table(std::string& page);

}  // namespace ptm::testbench::html
