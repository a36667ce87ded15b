#include "testbench/run/picture_models.h"

#include <algorithm>

#include "golden/scene/flat_samples.h"
#include "model/reference/constant_config.h"
#include "testbench/run/stopwatch.h"

namespace ptm::testbench {
namespace {

using reference::Fragment;
using reference::StoredTexture;

template <class Config>
reference::Color<reference::Value> shade(const Config& config, const StoredTexture& texture,
                                         const Fragment& f) {
  const std::size_t texel = texel_of(f, texture.width, texture.height);
  if (texture.rgb) {
    return reference::evaluate_rgb(config, reference::rgb_operands(texture, texel, f.lu, f.lv))
        .color;
  }
  return reference::evaluate_lrgb(config, reference::lrgb_operands(texture, texel, f.lu, f.lv))
      .color;
}

golden::ImageReal reference_frame(const FlatJob& job, const reference::EvalConfig& config,
                                  const HardwareMap& hardware, const golden::Light& light) {
  golden::ImageReal image(job.width, job.height, 3);
  const std::vector<Fragment> fragments = make_fragments(job, config, light);
  reference::with_constant_config(config, [&](const auto& folded) {
    auto sample = image.samples.begin();
    for (const Fragment& fragment : fragments) {
      const auto color = shade(folded, hardware.texture, fragment);
      sample = std::transform(color.out.begin(), color.out.end(), sample,
                              [](reference::Value level) { return static_cast<double>(level); });
    }
  });
  return image;
}

}  // namespace

ModelResult render_golden(const FlatJob& job) {
  ModelResult result;
  result.model = "golden";
  const Stopwatch watch;
  for (const golden::Light& light : job.lights) {
    result.frames.push_back(golden::render_flat(job.map, job.width, job.height, light));
  }
  result.seconds = watch.seconds();
  return result;
}

std::vector<golden::ImageReal> reference_frames(const FlatJob& job,
                                                const reference::EvalConfig& config,
                                                const HardwareMap& hardware) {
  std::vector<golden::ImageReal> frames;
  for (const golden::Light& light : job.lights) {
    frames.push_back(reference_frame(job, config, hardware, light));
  }
  return frames;
}

ModelResult render_reference(const FlatJob& job) {
  ModelResult result;
  result.model = "reference";
  const Stopwatch watch;
  result.frames = reference_frames(job, job.config, job.hardware);
  result.seconds = watch.seconds();
  return result;
}

}  // namespace ptm::testbench
