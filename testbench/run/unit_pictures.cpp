// Golden and reference: the models of the whole unit that know nothing of time.
#include <algorithm>

#include "golden/render/unit_picture.h"
#include "model/reference/unit/shade.h"
#include "testbench/run/stopwatch.h"
#include "testbench/run/unit_models.h"

namespace ptm::testbench {

ModelResult render_unit_golden(const UnitJob& job) {
  ModelResult result;
  result.model = "golden";
  const Stopwatch watch;
  const golden::UnitRenderer renderer(job.scene, job.textures, job.extras);
  for (const UnitFrameInput& frame : job.frames) {
    result.frames.push_back(golden::render_samples(job.scene, renderer, frame.samples));
  }
  result.seconds = watch.seconds();
  return result;
}

std::vector<golden::ImageReal> unit_area_averages(const UnitJob& job) {
  const golden::UnitRenderer renderer(job.scene, job.textures, job.extras);
  std::vector<golden::ImageReal> frames;
  for (const UnitFrameInput& frame : job.frames) {
    frames.push_back(golden::exact_area_average(job.scene, renderer, frame.samples));
  }
  return frames;
}

std::vector<std::vector<reference::UnitPixel>> unit_pixels(const UnitJob& job) {
  std::vector<std::vector<reference::UnitPixel>> frames;
  for (const UnitFrameInput& frame : job.frames) {
    frames.emplace_back(frame.fragments.size());
    reference::shade_all(job.config, job.state, frame.fragments, frames.back());
  }
  return frames;
}

golden::ImageReal unit_image(const golden::UnitScene& scene,
                             const std::vector<reference::UnitPixel>& pixels) {
  golden::ImageReal image(scene.size[0], scene.size[1], 3);
  for (std::size_t i = 0; i < image.samples.size(); ++i) image.samples[i] = scene.background[i % 3];
  for (const reference::UnitPixel& pixel : pixels) {
    const std::size_t at =
        (std::size_t{pixel.y} * static_cast<std::size_t>(scene.size[0]) + pixel.x) * 3;
    std::copy(pixel.rgb.begin(), pixel.rgb.end(),
              image.samples.begin() + static_cast<std::ptrdiff_t>(at));
  }
  return image;
}

}  // namespace ptm::testbench
