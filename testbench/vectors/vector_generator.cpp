#include "testbench/vectors/vector_generator.h"

#include <algorithm>
#include <bit>

#include "model/pipeline/stream_timing.h"

namespace ptm::testbench {
namespace {

using reference::EvalConfig;
using reference::Six;
using reference::Value;

/// The fields of one vector, drawn in a fixed order.
class Draw {
 public:
  Draw(std::uint64_t seed, std::uint64_t index) : key_(pipeline::hash(seed, index)) {
    const std::uint64_t kind = next() % 8;
    corners_only_ = kind == 0;
    moderate_ = kind == 1 || kind == 2;
  }

  [[nodiscard]] bool moderate() const { return moderate_; }

  /// A value in low..high.
  Value in(Value low, Value high) {
    const std::uint64_t h = next();
    if (corners_only_ || h % 4 == 0) return corner(low, high, h >> 8);
    return low + static_cast<Value>((h >> 8) % static_cast<std::uint64_t>(high - low + 1));
  }

 private:
  std::uint64_t next() { return pipeline::hash(key_, field_++); }

  static Value corner(Value low, Value high, std::uint64_t h) {
    switch (h % 8) {
      case 0:
        return low;
      case 1:
        return high;
      case 2:
        return std::clamp<Value>(0, low, high);
      default:
        break;
    }
    const auto bits =
        static_cast<unsigned>(std::bit_width(static_cast<std::uint64_t>(std::max(high, -low))));
    const Value power = Value{1} << ((h >> 8) % (bits + 1));
    const Value near = power + static_cast<Value>((h >> 16) % 3) - 1;
    return std::clamp((h >> 24) % 2 != 0 ? near : -near, low, high);
  }

  std::uint64_t key_, field_ = 0;
  bool corners_only_ = false, moderate_ = false;
};

Six<Value> draw_coef(Draw& draw, const EvalConfig& c) {
  Six<Value> coef{};
  for (Value& a : coef) a = draw.in(0, (Value{1} << (c.coef_bits + c.filter_frac)) - 1);
  return coef;
}

Six<Value> draw_bias(Draw& draw, const EvalConfig& c) {
  Six<Value> bias{};
  for (Value& b : bias) b = draw.in(0, (Value{1} << c.coef_bits) - 1);
  return bias;
}

Six<Value> draw_shift(Draw& draw, const EvalConfig& c) {
  // With delta_bits bits shifted right by delta_bits - lum_bits or more, a term is below lum's top.
  const int low = draw.moderate() ? std::max(c.shift_min, c.delta_bits - c.lum_bits) : c.shift_min;
  const int high = draw.moderate() ? std::min(reference::kShiftMax, low + 4) : reference::kShiftMax;
  Six<Value> shift{};
  for (Value& s : shift) s = draw.in(low, high);
  if (c.shift_groups == 3) {
    shift[1] = shift[2] = shift[0];
    shift[4] = shift[3];
  }
  return shift;
}

Value draw_light(Draw& draw, const EvalConfig& c) {
  const Value limit = Value{1} << (c.light_int + c.light_frac - 1);
  return draw.in(-limit, limit - 1);
}

}  // namespace

reference::LrgbOperands<> lrgb_vector(const EvalConfig& config, std::uint64_t seed,
                                      std::uint64_t index) {
  Draw draw(seed, index);
  reference::LrgbOperands<> operands;
  operands.coef = draw_coef(draw, config);
  operands.bias = draw_bias(draw, config);
  operands.shift = draw_shift(draw, config);
  for (Value& channel : operands.rgb) channel = draw.in(0, Value{255} << config.filter_frac);
  operands.lu = draw_light(draw, config);
  operands.lv = draw_light(draw, config);
  return operands;
}

reference::RgbOperands<> rgb_vector(const EvalConfig& config, std::uint64_t seed,
                                    std::uint64_t index) {
  Draw draw(seed, index);
  reference::RgbOperands<> operands;
  for (Six<Value>& coef : operands.coef) coef = draw_coef(draw, config);
  operands.bias = draw_bias(draw, config);
  operands.shift = draw_shift(draw, config);
  operands.lu = draw_light(draw, config);
  operands.lv = draw_light(draw, config);
  return operands;
}

LerpOperands lerp_vector(const EvalConfig& config, std::uint64_t seed, std::uint64_t index) {
  Draw draw(seed, index);
  const Value top = (Value{1} << (config.coef_bits + config.filter_frac)) - 1;
  const Value a = draw.in(0, top);
  const Value b = draw.in(0, top);
  return {a, b, draw.in(0, 255)};
}

}  // namespace ptm::testbench
