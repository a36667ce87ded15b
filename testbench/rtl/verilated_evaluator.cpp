#include "testbench/rtl/verilated_evaluator.h"

#include "testbench/rtl/probe.h"

namespace ptm::testbench {

using reference::LrgbOperands;
using reference::RgbOperands;
using reference::Value;

std::vector<std::pair<std::string, Value>> named_values(const RtlTrace& trace) {
  std::vector<std::pair<std::string, Value>> values;
  const auto six = [&](const char* name, const reference::Six<Value>& row) {
    for (unsigned i = 0; i < 6; ++i) values.emplace_back(name + std::to_string(i), row[i]);
  };
  const auto three = [&](const std::string& name, const reference::Three<Value>& row) {
    for (unsigned c = 0; c < 3; ++c) values.emplace_back(name + "_" + "rgb"[c], row[c]);
  };
  six("d", trace.luminance.d);
  values.emplace_back("uu", trace.luminance.b.uu);
  values.emplace_back("vv", trace.luminance.b.vv);
  values.emplace_back("uv", trace.luminance.b.uv);
  six("p", trace.luminance.p);
  six("t", trace.luminance.t);
  values.emplace_back("acc", trace.luminance.acc);
  values.emplace_back("lum", trace.luminance.lum.lum);
  values.emplace_back("lum_saturated", trace.luminance.lum.saturated);
  three("product", trace.product);
  three("out", trace.color.out);
  values.emplace_back("color_saturated", trace.color.saturated);
  return values;
}

namespace {

RtlRun prepared(std::size_t pixels) {
  RtlRun run;
  run.pixels.reserve(pixels);
  run.taken.reserve(pixels);
  return run;
}

auto keep_in(RtlRun& run) {
  return [&run](std::uint64_t, const RtlPixel& pixel, std::uint64_t cycle) {
    run.pixels.push_back(pixel);
    run.taken.push_back(cycle);
  };
}

}  // namespace

RtlRun RtlEvaluator::run(std::span<const LrgbOperands<>> operands,
                         const pipeline::StreamTiming& timing) {
  RtlRun run = prepared(operands.size());
  run.counters = stream_lrgb(
      operands.size(), timing,
      [&](std::uint64_t n) -> const LrgbOperands<>& { return operands[n]; }, keep_in(run));
  return run;
}

RtlRun RtlEvaluator::run(std::span<const RgbOperands<>> operands,
                         const pipeline::StreamTiming& timing) {
  RtlRun run = prepared(operands.size());
  run.counters = stream_rgb(
      operands.size(), timing, [&](std::uint64_t n) -> const RgbOperands<>& { return operands[n]; },
      keep_in(run));
  return run;
}

RtlTrace RtlEvaluator::trace_pass(const RtlPins& pins) {
  RtlTrace trace;
  const auto read = [this](std::uint8_t first, auto& row) {
    for (std::uint8_t i = 0; i < row.size(); ++i) {
      row[i] = probe(static_cast<std::uint8_t>(first + i));
    }
  };
  const RtlPins idle;
  cycle(pins);  // after it R1 holds the beat, and each further cycle moves it on
  read(probe::kD, trace.luminance.d);
  trace.luminance.b = {probe(probe::kUu), probe(probe::kVv), probe(probe::kUv)};
  cycle(idle);
  read(probe::kP, trace.luminance.p);
  cycle(idle);
  read(probe::kT, trace.luminance.t);
  cycle(idle);
  trace.luminance.acc = probe(probe::kAcc);
  cycle(idle);
  trace.luminance.lum = {probe(probe::kLum), probe(probe::kLumSaturated)};
  cycle(idle);
  read(probe::kProduct, trace.product);
  cycle(idle);
  read(probe::kOut, trace.color.out);
  trace.color.saturated = probe(probe::kColorSaturated);
  cycle(idle);
  cycle(idle);
  return trace;
}

RtlTrace RtlEvaluator::trace(const LrgbOperands<>& operands) {
  reset();
  RtlPins pins;
  pins.valid = true;
  pins.operands = operands;
  return trace_pass(pins);
}

std::array<RtlTrace, 3> RtlEvaluator::trace(const RgbOperands<>& operands) {
  reset();
  std::array<RtlTrace, 3> traces;
  for (unsigned c = 0; c < 3; ++c) {
    RtlPins pins;
    pins.valid = true;
    pins.rgb_map = true;
    pins.channel = c;
    pins.operands = {operands.coef[c], operands.bias, operands.shift, {}, operands.lu, operands.lv};
    traces[c] = trace_pass(pins);
  }
  return traces;
}

}  // namespace ptm::testbench
