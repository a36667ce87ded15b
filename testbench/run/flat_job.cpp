#include "testbench/run/flat_job.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "golden/scene/flat_samples.h"
#include "golden/scene/textures.h"
#include "model/reference/light_code.h"
#include "testbench/run/light_advice.h"

namespace ptm::testbench {
namespace {

std::string decimal(double x) {
  std::ostringstream text;
  text << x;
  return text.str();
}

std::string advice(const golden::Light& light) {
  if (!std::isfinite(light.u) || !std::isfinite(light.v)) return {};
  const std::string text = light_advice(light.u, light.v);
  return text.empty() ? text : ". " + text;
}

void check_light(const FlatJob& job, const reference::EvalConfig& config,
                 const golden::Light& light) {
  for (const auto& [name, value] : {std::pair{"lu", light.u}, std::pair{"lv", light.v}}) {
    if (reference::light_code(config, value)) continue;
    throw golden::InputError(job.name, light.place, std::string(name) + " = " + decimal(value),
                             std::string("|") + name + "| at most " +
                                 decimal(reference::light_limit(config)) +
                                 ", which is what light_int = " + std::to_string(config.light_int) +
                                 " can express" + advice(light));
  }
}

}  // namespace

void check_hardware_size(const std::filesystem::path& map_file, int width, int height) {
  constexpr int most = reference::kLargestSide;
  if (std::max(width, height) <= most) return;
  throw golden::InputError(map_file.string(), "header (width and height)",
                           std::to_string(width) + " x " + std::to_string(height) + " texels",
                           "at most " + std::to_string(most) + " a side in the hardware; " +
                               golden::crop_advice(map_file, width, height));
}

void check_hardware_limits(const FlatJob& job, const reference::EvalConfig& config) {
  check_hardware_size(job.map_file, job.map.width, job.map.height);
  for (const golden::Light& light : job.lights) check_light(job, config, light);
}

void choose_config(FlatJob& job, const reference::EvalConfig& config) {
  job.config = config;
  check_hardware_limits(job, job.config);
  job.hardware =
      store_map(job.map, job.config, quantize::Method::nearest_plane, job.map_file.string());
}

reference::Fragment make_fragment(const FlatJob& job, const reference::EvalConfig& config,
                                  const golden::Light& light, int x, int y) {
  const golden::Sample s = golden::flat_sample(x, y, job.width, job.height, light);
  // check_hardware_limits() has seen every light, and u, v lie in [0, 1).
  return reference::quantize_fragment(config, x, y, {s.u, s.v, s.lu, s.lv}).value();
}

std::vector<reference::Fragment> make_fragments(const FlatJob& job,
                                                const reference::EvalConfig& config,
                                                const golden::Light& light) {
  std::vector<reference::Fragment> fragments;
  fragments.reserve(static_cast<std::size_t>(job.width) * static_cast<std::size_t>(job.height));
  for (int y = 0; y < job.height; ++y) {
    for (int x = 0; x < job.width; ++x) {
      fragments.push_back(make_fragment(job, config, light, x, y));
    }
  }
  return fragments;
}

}  // namespace ptm::testbench
