#include "testbench/vectors/vector_csv.h"

#include <array>
#include <charconv>
#include <ostream>

#include "model/pipeline/simulate.h"
#include "model/reference/constant_config.h"
#include "model/reference/lerp.h"
#include "testbench/rtl/verilated_evaluator.h"
#include "testbench/vectors/vector_generator.h"

namespace ptm::testbench {
namespace {

using reference::LrgbOperands;
using reference::RgbOperands;
using reference::Value;

/// A line of integers.
class Row {
 public:
  explicit Row(std::ostream& out) : out_(out) {}

  void add(Value value) {
    std::array<char, 24> digits;
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
    text_.append(digits.data(), end);
    text_ += ',';
  }
  template <class Values>
  void add_all(const Values& values) {
    for (const auto value : values) add(static_cast<Value>(value));
  }
  void end() {
    text_.back() = '\n';
    out_ << text_;
    text_.clear();
  }

 private:
  std::ostream& out_;
  std::string text_;
};

std::string six(const std::string& name) {
  std::string columns;
  for (int i = 0; i < 6; ++i) columns += name + std::to_string(i) + ",";
  return columns;
}

void write_row(Row& row, const LrgbOperands<>& in, const RtlPixel& pixel) {
  row.add_all(in.coef);
  row.add_all(in.bias);
  row.add_all(in.shift);
  row.add_all(in.rgb);
  row.add(in.lu);
  row.add(in.lv);
  row.add(pixel.lum[0]);
  row.add(pixel.lum_saturated ? 1 : 0);
  row.add_all(pixel.out);
  row.add(pixel.color_saturated ? 1 : 0);
  row.end();
}

void write_row(Row& row, const RgbOperands<>& in, const RtlPixel& pixel) {
  for (const auto& coef : in.coef) row.add_all(coef);
  row.add_all(in.bias);
  row.add_all(in.shift);
  row.add(in.lu);
  row.add(in.lv);
  row.add_all(pixel.lum);
  row.add(pixel.lum_saturated ? 1 : 0);
  row.add_all(pixel.out);
  row.add(pixel.color_saturated ? 1 : 0);
  row.end();
}

void stream_rtl(RtlEvaluator& rtl, std::uint64_t count,
                const std::function<const LrgbOperands<>&(std::uint64_t)>& source,
                const RtlEvaluator::Sink& sink) {
  rtl.stream_lrgb(count, {}, source, sink);
}
void stream_rtl(RtlEvaluator& rtl, std::uint64_t count,
                const std::function<const RgbOperands<>&(std::uint64_t)>& source,
                const RtlEvaluator::Sink& sink) {
  rtl.stream_rgb(count, {}, source, sink);
}

LrgbOperands<> make_vector(const reference::EvalConfig& config, std::uint64_t seed,
                           std::uint64_t index, const LrgbOperands<>*) {
  return lrgb_vector(config, seed, index);
}
RgbOperands<> make_vector(const reference::EvalConfig& config, std::uint64_t seed,
                          std::uint64_t index, const RgbOperands<>*) {
  return rgb_vector(config, seed, index);
}

RtlPixel reference_pixel(const reference::EvalConfig& config, const LrgbOperands<>& in) {
  return to_pixel(reference::evaluate_lrgb(config, in));
}
RtlPixel reference_pixel(const reference::EvalConfig& config, const RgbOperands<>& in) {
  return to_pixel(reference::evaluate_rgb(config, in));
}

/// Rows of whole pixels. Pixels lag behind operands in the timed models; as vectors are pure
/// functions of their number, a row's operands are made again when its pixel comes.
template <class Operands>
void write_pixels(const VectorRequest& request, const reference::EvalConfig& config,
                  std::ostream& out) {
  Row row(out);
  const auto vector = [&](std::uint64_t n) {
    return make_vector(config, request.seed, n, static_cast<const Operands*>(nullptr));
  };
  if (request.model == "reference") {
    for (std::uint64_t n = 0; n < request.count; ++n) {
      const Operands in = vector(n);
      write_row(row, in, reference_pixel(config, in));
    }
    return;
  }
  Operands operands;
  const std::function<const Operands&(std::uint64_t)> source =
      [&](std::uint64_t n) -> const Operands& { return operands = vector(n); };
  if (request.model == "rtl") {
    stream_rtl(*make_rtl_evaluator(config), request.count, source,
               [&](std::uint64_t n, const RtlPixel& pixel, std::uint64_t) {
                 write_row(row, vector(n), pixel);
               });
    return;
  }
  pipeline::stream_evaluator(
      config, request.count, source,
      [&](std::uint64_t n, const pipeline::Pixel& pixel, pipeline::Cycle) {
        write_row(row, vector(n),
                  {pixel.lum, pixel.out, pixel.lum_saturated, pixel.color_saturated});
      });
}

/// The pipeline has no lerp of its own yet: its rows are the reference's.
void write_lerps(const VectorRequest& request, const reference::EvalConfig& config,
                 std::ostream& out) {
  Row row(out);
  const auto rtl = request.model == "rtl" ? make_rtl_lerp() : nullptr;
  for (std::uint64_t n = 0; n < request.count; ++n) {
    const LerpOperands in = lerp_vector(config, request.seed, n);
    row.add(in.a);
    row.add(in.b);
    row.add(in.f);
    // The RTL is built for 8 and for 16 bits, and the wider one computes the same of fewer.
    row.add(rtl ? (*rtl)(config.rounding, config.coef_bits + config.filter_frac <= 8 ? 8 : 16,
                         static_cast<unsigned>(in.a), static_cast<unsigned>(in.b),
                         static_cast<unsigned>(in.f))
                : reference::lerp(config.rounding, in.a, in.b, in.f));
    row.end();
  }
}

}  // namespace

std::string vector_header(VectorKind kind) {
  switch (kind) {
    case VectorKind::lrgb:
      return six("coef") + six("bias") + six("shift") +
             "r,g,b,lu,lv,lum,lum_saturated,out_r,out_g,out_b,color_saturated";
    case VectorKind::rgb:
      return six("coef_r") + six("coef_g") + six("coef_b") + six("bias") + six("shift") +
             "lu,lv,lum_r,lum_g,lum_b,lum_saturated,out_r,out_g,out_b,color_saturated";
    case VectorKind::lerp:
      break;
  }
  return "a,b,f,out";
}

void write_vectors(const VectorRequest& request, std::ostream& out) {
  const reference::EvalConfig& config = request.config;
  out << vector_header(request.kind) << '\n';
  switch (request.kind) {
    case VectorKind::lrgb:
      return write_pixels<LrgbOperands<>>(request, config, out);
    case VectorKind::rgb:
      return write_pixels<RgbOperands<>>(request, config, out);
    case VectorKind::lerp:
      return write_lerps(request, config, out);
  }
}

}  // namespace ptm::testbench
