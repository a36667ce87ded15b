#include "testbench/report/html_text.h"

#include <array>
#include <cmath>
#include <cstdio>

#include "golden/files/figure_text.h"
#include "testbench/run/run_result.h"

namespace ptm::testbench {
namespace {

std::string print(const char* format, int digits, double value) {
  std::array<char, 400> text{};  // the longest double in %f takes 309 digits before the point
  const int length = std::snprintf(text.data(), text.size(), format, digits, value);
  return {text.data(), static_cast<std::size_t>(length)};
}

}  // namespace

std::string html_escape(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      case '\'':
        out += "&#39;";
        break;
      default:
        if ((static_cast<unsigned char>(c) < 0x20 && c != '\t' && c != '\n') || c == 0x7f) {
          out += "\xEF\xBF\xBD";
        } else {
          out += c;
        }
    }
  }
  return out;
}

std::string base64(std::span<const std::uint8_t> bytes) {
  static constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  out.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      group = group << 8 | (i + k < bytes.size() ? bytes[i + k] : 0U);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      const bool padding = i + k > bytes.size();
      out += padding ? '=' : kDigits[group >> (18 - 6 * k) & 63U];
    }
  }
  return out;
}

std::string png_uri(std::span<const std::uint8_t> png) {
  return "data:image/png;base64," + base64(png);
}

std::string fixed(double value, int digits) { return print("%.*f", digits, value); }

std::string grouped(std::uint64_t value) {
  const std::string digits = std::to_string(value);
  std::string out;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i > 0 && (digits.size() - i) % 3 == 0) out += ',';
    out += digits[i];
  }
  return out;
}

std::string significant(double value) {
  if (value == 0) return "0";
  if (value < 1e-4) return golden::four_digits(value);
  if (value >= 999.95) return grouped(static_cast<std::uint64_t>(std::llround(value)));
  int digits = 1;  // behind the point
  for (double size = 99.995; digits < 7 && value < size; size /= 10) ++digits;
  return fixed(value, digits);
}

std::string decibels(double psnr) {
  if (std::isinf(psnr)) return "∞ dB";
  return std::string(psnr < 0 ? "-" : "").append(significant(std::abs(psnr))).append(" dB");
}

std::string levels(double error) {
  if (error == std::floor(error) && std::abs(error) < 1e6) return fixed(error, 0);
  return golden::four_digits(error);
}

std::string share(double part) {
  if (part == 0 || part == 1) return fixed(100 * part, 0) + " %";
  return (part < 0.00005 ? print("%.*g", 2, 100 * part) : fixed(100 * part, 2)) + " %";
}

std::string similarity(double ssim) {
  if (ssim == 1) return "1";
  return ssim > 0.999995 ? "&gt; 0.99999" : fixed(ssim, 5);
}

std::string duration(double seconds) {
  const auto three = [](double value, const char* unit) {
    return fixed(value, value >= 100 ? 0 : value >= 10 ? 1 : 2) + " " + unit;
  };
  if (seconds >= 1) return three(seconds, "s");
  if (seconds >= 1e-3) return three(seconds * 1e3, "ms");
  return seconds >= 1e-6 ? three(seconds * 1e6, "µs") : three(seconds * 1e9, "ns");
}

std::string light_text(const FrameLight& light) {
  const bool local = light.kind == FrameLight::Kind::local;
  std::string text = local                                       ? "(lu, lv) = ("
                     : light.kind == FrameLight::Kind::direction ? "direction ("
                                                                 : "position (";
  text += fixed(light.x, 3) + ",\u00a0" + fixed(light.y, 3);
  if (!local) text += ",\u00a0" + fixed(light.z, 3);
  return text + ")";
}

std::string plural(std::size_t count, const std::string& noun) {
  return golden::count_of(grouped(count), noun);
}

}  // namespace ptm::testbench
