#include "testbench/report/html_table.h"

namespace ptm::testbench::html {

void open_section(std::string& page, const std::string& id, const std::string& title) {
  page += "<section aria-labelledby=\"" + id + "\">\n<h2 id=\"" + id + "\">" + title + "</h2>\n";
}

void open_table(std::string& page, const std::string& kind, const std::string& caption,
                const Row& heads) {
  page += "<div class=\"scroll\" role=\"region\" tabindex=\"0\" aria-label=\"" + caption +
          "\">\n<table class=\"" + kind + "\">\n<caption>" + caption + "</caption>\n<thead><tr>";
  for (const std::string& head : heads) page += "<th scope=\"col\">" + head + "</th>";
  page += "</tr></thead>\n<tbody>\n";
}

void add_row(std::string& page, const std::string& kind, const Row& row) {
  page += kind.empty() ? "<tr>" : "<tr class=\"" + kind + "\">";
  page += "<th scope=\"row\">" + row[0] + "</th>";
  for (std::size_t i = 1; i < row.size(); ++i) page += "<td>" + row[i] + "</td>";
  page += "</tr>\n";
}

void close_table(std::string& page) { page += "</tbody>\n</table>\n</div>\n"; }

}  // namespace ptm::testbench::html
