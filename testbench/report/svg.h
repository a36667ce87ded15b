#pragma once
#include <string>

/// Parts of the report's drawings, in the drawing's own units; the page scales it.
namespace ptm::testbench::svg {

[[nodiscard]] std::string number(double value);
/// `text` is SVG; `anchor` is "start", "middle" or "end".
[[nodiscard]] std::string text_at(double x, double y, const char* anchor, const std::string& text);
[[nodiscard]] std::string line(const char* kind, double x1, double y1, double x2, double y2);
/// The least of 1, 2 or 5 times a power of ten that goes into `reach` (above 0) at most `most`
/// times, `most` from 4 to 10.
[[nodiscard]] double tick_step(double reach, int most = 4);
/// Digits after the point that a multiple of `step` needs.
[[nodiscard]] int tick_digits(double step);

}  // namespace ptm::testbench::svg
