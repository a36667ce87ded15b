#include "testbench/report/svg.h"

#include <algorithm>
#include <cmath>

#include "testbench/report/html_text.h"

namespace ptm::testbench::svg {

std::string number(double value) { return fixed(value, 2); }

std::string text_at(double x, double y, const char* anchor, const std::string& text) {
  return "<text x=\"" + number(x) + "\" y=\"" + number(y) + "\" text-anchor=\"" + anchor + "\">" +
         text + "</text>\n";
}

std::string line(const char* kind, double x1, double y1, double x2, double y2) {
  return "<line class=\"" + std::string(kind) + "\" x1=\"" + number(x1) + "\" y1=\"" + number(y1) +
         "\" x2=\"" + number(x2) + "\" y2=\"" + number(y2) + "\"/>\n";
}

double tick_step(double reach, int most) {
  double step = std::pow(10, std::floor(std::log10(reach)) - 1);
  for (int i = 0; reach / step > most; ++i) step *= i % 3 == 1 ? 2.5 : 2;
  return step;
}

int tick_digits(double step) {
  return std::max(0, static_cast<int>(std::ceil(-std::log10(step) - 1e-9)));
}

}  // namespace ptm::testbench::svg
