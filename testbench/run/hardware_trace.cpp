#include "testbench/run/hardware_trace.h"

#include <cctype>
#include <cmath>
#include <optional>
#include <sstream>

namespace ptm::testbench {
namespace {

using reference::Six;
using reference::Value;

constexpr std::array<const char*, 3> kChannels{"r", "g", "b"};

class Values {
 public:
  void add(const std::string& name, Value code) { list_.push_back({prefix_ + name, code}); }
  void add_six(const std::string& name, const Six<Value>& codes) {
    for (std::size_t i = 0; i < 6; ++i) add(name + std::to_string(i), codes[i]);
  }
  void add_channels(const std::string& name, const reference::Three<Value>& codes) {
    for (std::size_t c = 0; c < 3; ++c) add(name + kChannels[c], codes[c]);
  }
  void add_luminance(const reference::LuminanceTrace<Value>& trace) {
    add_six("d", trace.d);
    add("uu", trace.b.uu);
    add("vv", trace.b.vv);
    add("uv", trace.b.uv);
    add_six("p", trace.p);
    add_six("t", trace.t);
    add("acc", trace.acc);
    add("lum", trace.lum.lum);
    add("lum_saturated", trace.lum.saturated);
  }
  void set_channel(std::size_t c) { prefix_ = std::string(kChannels[c]) + "."; }
  void clear_channel() { prefix_.clear(); }
  std::vector<IntegerValue> take() { return std::move(list_); }

 private:
  std::vector<IntegerValue> list_;
  std::string prefix_;
};

/// Fraction bits of a value, nothing if its unit is 1.
std::optional<int> fraction_bits(const std::string& name, const reference::EvalConfig& config,
                                 const Six<Value>& shift) {
  const std::string bare = name.find('.') == 1 ? name.substr(2) : name;
  if (bare == "lu" || bare == "lv") return config.light_frac;
  if (bare == "uu" || bare == "vv" || bare == "uv") return config.basis_frac;
  if (bare == "acc") return config.guard;
  if (bare == "lum" || bare.starts_with("product_")) return config.lum_frac;
  if (bare.size() != 2 || std::isdigit(static_cast<unsigned char>(bare[1])) == 0) return {};
  const auto i = static_cast<std::size_t>(bare[1] - '0');
  const int own = static_cast<int>(shift[i]) + config.filter_frac;
  if (bare[0] == 'd') return own;
  if (bare[0] == 'p') return reference::widths(config).frac[i] + static_cast<int>(shift[i]);
  if (bare[0] == 't') return config.guard;
  return {};
}

}  // namespace

std::vector<IntegerValue> operand_values(const reference::LrgbOperands<>& in) {
  Values values;
  values.add_six("coef", in.coef);
  values.add_six("bias", in.bias);
  values.add_six("shift", in.shift);
  values.add_channels("color_", in.rgb);
  values.add("lu", in.lu);
  values.add("lv", in.lv);
  return values.take();
}

std::vector<IntegerValue> operand_values(const reference::RgbOperands<>& in) {
  Values values;
  for (std::size_t c = 0; c < 3; ++c) {
    values.set_channel(c);
    values.add_six("coef", in.coef[c]);
  }
  values.clear_channel();
  values.add_six("bias", in.bias);
  values.add_six("shift", in.shift);
  values.add("lu", in.lu);
  values.add("lv", in.lv);
  return values.take();
}

std::vector<IntegerValue> trace_values(const reference::LrgbTrace<Value>& trace) {
  Values values;
  values.add_luminance(trace.luminance);
  values.add_channels("product_", trace.product);
  values.add_channels("out_", trace.color.out);
  values.add("color_saturated", trace.color.saturated);
  return values.take();
}

std::vector<IntegerValue> trace_values(const reference::RgbTrace<Value>& trace) {
  Values values;
  for (std::size_t c = 0; c < 3; ++c) {
    values.set_channel(c);
    values.add_luminance(trace.channel[c]);
  }
  values.clear_channel();
  values.add_channels("out_", trace.color.out);
  values.add("color_saturated", trace.color.saturated);
  return values.take();
}

NamedValue print_value(const IntegerValue& value, const reference::EvalConfig& config,
                       const Six<Value>& shift) {
  std::ostringstream text;
  text << value.code;
  const auto bits = fraction_bits(value.name, config, shift);
  if (bits.value_or(0) != 0) {
    text.precision(7);
    text << " (" << std::ldexp(static_cast<double>(value.code), -*bits) << ")";
  }
  return {value.name, text.str()};
}

}  // namespace ptm::testbench
